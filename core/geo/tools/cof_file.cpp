#include "core/geo/tools/cof_file.h"

#include <bit>
#include <cctype>
#include <cstdint>
#include <fstream>
#include <locale>
#include <sstream>
#include <string_view>

namespace leadline::geo {
namespace {

constexpr std::size_t kIdLength = 8;

std::istringstream fields_of(const std::string& line) {
  std::istringstream fields(line);
  fields.imbue(std::locale::classic());
  return fields;
}

bool at_end(std::istringstream& fields) { return (fields >> std::ws).eof(); }

/// Reads line by line and remembers where it is, so that a refusal can say so.
class Lines {
 public:
  explicit Lines(const std::string& path) : path_(path), in_(path) {}
  [[nodiscard]] bool open() const { return in_.is_open(); }
  /// Empty at the end of the file.
  std::string next() {
    ++number_;
    std::string line;
    std::getline(in_, line);
    return line;
  }
  [[nodiscard]] Error error(const std::string& what) const {
    return {what, path_ + ":" + std::to_string(number_), "take the .COF file from NOAA again"};
  }

 private:
  std::string path_;
  std::ifstream in_;
  int number_ = 0;
};

void put_bytes(std::string& out, std::uint64_t bits, int count) {
  for (int i = 0; i < count; ++i) out.push_back(static_cast<char>(bits >> (8 * i) & 0xFF));
}
void put(std::string& out, std::int32_t value) { put_bytes(out, static_cast<std::uint32_t>(value), 4); }
void put(std::string& out, double value) { put_bytes(out, std::bit_cast<std::uint64_t>(value), 8); }

/// One set of cosine and sine coefficients, order by order.
void put(std::string& out, const Harmonics& cosine, const Harmonics& sine) {
  put(out, kWmmDegree);
  put(out, kWmmDegree);
  for (std::size_t m = 0; m <= kWmmDegree; ++m)
    for (std::size_t n = m; n <= kWmmDegree; ++n) put(out, cosine[n][m]);
  for (std::size_t m = 1; m <= kWmmDegree; ++m)
    for (std::size_t n = m; n <= kWmmDegree; ++n) put(out, sine[n][m]);
}

/// Ties the two files together; GeographicLib asks for exactly eight characters.
std::string id_of(const std::string& name) {
  std::string id = name.substr(0, kIdLength);
  for (char& c : id) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  id.resize(kIdLength, '-');
  return id;
}

std::string metadata(const CofFile& cof, const std::string& name) {
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text << "WMMF-1\n# Written by cof_to_wmm from NOAA's coefficients\n"
       << "Name            " << name << "\nDescription     World Magnetic Model " << cof.name
       << "\nReleaseDate     " << cof.release_date
       << "\nRadius          6371200\nNumModels       1\nEpoch           " << cof.epoch_year
       << "\nDeltaEpoch      5\nMinTime         " << cof.epoch_year << "\nMaxTime         "
       << cof.epoch_year + 5.0 << "\nMinHeight       -1000\nMaxHeight       850000\nNormalization   schmidt\n"
       << "ByteOrder       little\nID              " << id_of(name) << "\n";
  return text.str();
}

Result<void> write_file(const std::string& path, std::string_view bytes) {
  std::ofstream out(path, std::ios::binary | std::ios::trunc);
  out.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  out.close();
  if (!out) return Error{"cannot be written", path, "check that the folder exists and has room"};
  return {};
}

}  // namespace

Result<CofFile> read_cof(const std::string& path) {
  Lines lines(path);
  if (!lines.open()) return Error{"cannot be opened", path, "give NOAA's .COF file"};

  CofFile cof;
  auto head = fields_of(lines.next());
  if (!(head >> cof.epoch_year >> cof.name >> cof.release_date) || !at_end(head))
    return lines.error("the first line must be epoch, name and release date");
  if (cof.epoch_year < 1900.0 || cof.epoch_year > 2200.0) return lines.error("the epoch is not a year");

  for (std::size_t n = 1; n <= kWmmDegree; ++n)
    for (std::size_t m = 0; m <= n; ++m) {
      auto row = fields_of(lines.next());
      std::size_t n_read = 0, m_read = 0;
      if (!(row >> n_read >> m_read >> cof.g[n][m] >> cof.h[n][m] >> cof.g_rate[n][m] >> cof.h_rate[n][m]) ||
          !at_end(row))
        return lines.error("a row must be the six numbers n m g h dg dh");
      if (n_read != n || m_read != m)
        return lines.error("expected the row of n " + std::to_string(n) + " and m " + std::to_string(m));
    }

  auto closing = fields_of(lines.next());
  std::string nines;
  closing >> nines;
  if (nines.size() < 16 || nines.find_first_not_of('9') != std::string::npos)
    return lines.error("expected the closing line of 9s");
  return cof;
}

Result<void> write_wmm(const CofFile& cof, const std::string& folder, const std::string& name) {
  std::string coefficients = id_of(name);
  put(coefficients, cof.g, cof.h);
  put(coefficients, cof.g_rate, cof.h_rate);
  const std::string path = folder + "/" + name + ".wmm";
  if (auto written = write_file(path + ".cof", coefficients); !written) return written;
  return write_file(path, metadata(cof, name));
}

}  // namespace leadline::geo
