#include "sessions/export/csv_file.h"

#include <array>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <iterator>

#include "core/types/expect.h"

namespace leadline::sessions {
namespace {

constexpr std::size_t kBuffer = 1 << 18;
constexpr int kMostDecimals = 10;
constexpr std::array<double, kMostDecimals + 1> kPowersOfTen = {1,   1e1, 1e2, 1e3, 1e4, 1e5,
                                                                1e6, 1e7, 1e8, 1e9, 1e10};

/// value with `decimals` digits after the point, rounded to nearest, as an integer and digits: several times
/// as fast as a general formatter, and the same text but for exact halves.
void append_fixed(std::string& row, double value, int decimals) {
  LL_EXPECT(decimals >= 0 && decimals <= kMostDecimals);
  const double scaled = std::round(value * kPowersOfTen[static_cast<std::size_t>(decimals)]);
  if (!(std::abs(scaled) < 9e15)) {  // beyond exact integers
    fmt::format_to(std::back_inserter(row), "{:.{}f}", value, decimals);
    return;
  }
  auto n = static_cast<std::int64_t>(scaled);
  std::array<char, 24> digits;
  char* end = digits.data() + digits.size();
  char* p = end;
  const bool negative = n < 0;
  if (negative) n = -n;
  for (int i = 0; i < decimals; ++i, n /= 10) *--p = static_cast<char>('0' + n % 10);
  if (decimals > 0) *--p = '.';
  do {
    *--p = static_cast<char>('0' + n % 10);
    n /= 10;
  } while (n > 0);
  if (negative) *--p = '-';
  row.append(p, end);
}

}  // namespace

std::string csv_text(std::string_view text) {
  std::string cell(text);
  if (!cell.empty() && std::string_view("=+-@").find(cell.front()) != std::string_view::npos)
    cell.insert(0, "'");
  if (cell.find_first_of(",\"\r\n") == std::string::npos) return cell;
  std::string quoted = "\"";
  for (const char c : cell) {
    quoted.push_back(c);
    if (c == '"') quoted.push_back(c);
  }
  return quoted + "\"";
}

Result<CsvFile> CsvFile::create(const std::string& path, std::string_view header) {
  CsvFile csv;
  csv.path_ = path;
  csv.file_.reset(std::fopen(path.c_str(), "wb"));
  if (!csv.file_)
    return Error{std::string("cannot be written: ") + std::strerror(errno), path,
                 "choose another --csv folder"};
  csv.buffer_.reserve(kBuffer + 4096);
  csv.buffer_.append(header);
  csv.buffer_.push_back('\n');
  return csv;
}

void CsvFile::time(Time t) {
  field();
  const std::int64_t us = arrival_at(t).ns / 1000;
  const std::int64_t whole = us >= 0 ? us / 1'000'000 : -((-us + 999'999) / 1'000'000);
  fmt::format_to(std::back_inserter(row_), "{}.{:06}", whole, us - whole * 1'000'000);
}

void CsvFile::iso(Time t) {
  field();
  row_.append(iso8601(t, 3));
}

void CsvFile::number(std::optional<double> value, int decimals) {
  field();
  if (value && std::isfinite(*value)) append_fixed(row_, *value, decimals);
}

void CsvFile::end_row() {
  row_.push_back('\n');
  buffer_.append(row_.data(), row_.data() + row_.size());
  row_.clear();
  begun_ = false;
  ++rows_;
  if (buffer_.size() < kBuffer) return;
  failed_ = failed_ || std::fwrite(buffer_.data(), 1, buffer_.size(), file_.get()) != buffer_.size();
  buffer_.clear();
}

Result<void> CsvFile::close() {
  if (!file_) return {};
  failed_ = failed_ || std::fwrite(buffer_.data(), 1, buffer_.size(), file_.get()) != buffer_.size();
  failed_ = std::fclose(file_.release()) != 0 || failed_;
  if (failed_)
    return Error{std::string("not all of it could be written: ") + std::strerror(errno), path_,
                 "is the disk full?"};
  return {};
}

}  // namespace leadline::sessions
