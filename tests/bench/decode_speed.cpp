// decode_speed FOLDER: how fast telegrams become facts, on one core, from a file in the page cache. NMEA 0183
// beside Debian's gpsdecode on the same 100 MB file of real logs, which is written into FOLDER; PD0 and
// MTData2 in MB/s.

#include <fmt/format.h>
#include <sys/resource.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <string>
#include <vector>

#include "core/decode/registry.h"

namespace {

using namespace leadline;

constexpr std::size_t kFileSize = 100'000'000, kChunk = 128 * 1024;
constexpr int kRuns = 5;

std::string read_file(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}
std::string data(const std::string& name) { return read_file(std::string(LEADLINE_TEST_DATA) + "/" + name); }

/// What a program wants of its receiver, and a checksum of everything it was told.
class Navigator final : public DecoderOutput {
 public:
  void fact(std::optional<Time> device_time, const Message& message) override {
    if (device_time) time_ns = device_time->ns;
    if (const auto* fix = std::get_if<GnssFix>(&message)) {
      lat_rad = fix->position.lat.rad();
      lon_rad = fix->position.lon.rad();
    } else if (const auto* course = std::get_if<Course>(&message)) {
      speed_mps = course->speed_mps;
      if (course->course) track_rad = course->course->rad();
    } else {
      return;
    }
    mix(static_cast<std::uint64_t>(time_ns));
    for (const double value : {lat_rad, lon_rad, speed_mps, track_rad}) {
      std::uint64_t bits = 0;
      std::memcpy(&bits, &value, sizeof bits);
      mix(bits);
    }
  }
  void frame(const FrameReport& report) override {
    bytes += report.length;
    ++reports[static_cast<std::size_t>(report.byte_class)];
  }

  std::int64_t time_ns = 0;
  double lat_rad = 0.0, lon_rad = 0.0, speed_mps = 0.0, track_rad = 0.0;
  std::uint64_t checksum = 0, bytes = 0;
  std::array<std::uint64_t, kByteClasses> reports{};

 private:
  void mix(std::uint64_t value) { checksum = (checksum ^ value) * 0x9E37'79B9'7F4A'7C15 + (checksum >> 31); }
};

double cpu_seconds(int who) {
  rusage used{};
  getrusage(who, &used);
  const auto seconds = [](timeval t) {
    return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
  };
  return seconds(used.ru_utime) + seconds(used.ru_stime);
}

struct Run {
  double cpu_s = 0.0;
  Navigator told;
};

/// The fastest of a few runs; reading the file is part of each.
Run decode_file(const std::string& decoder_name, const std::string& path) {
  Run best;
  for (int i = 0; i < kRuns; ++i) {
    DecoderSettings settings;
    settings.checksum_required = false;
    const auto decoder = decode::make_decoder(decoder_name, settings).value();
    Run run;
    const double begun = cpu_seconds(RUSAGE_SELF);
    const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "rb"), &std::fclose);
    std::setvbuf(file.get(), nullptr, _IONBF, 0);
    static std::array<std::uint8_t, kChunk> chunk;
    for (std::size_t n; (n = std::fread(chunk.data(), 1, chunk.size(), file.get())) > 0;)
      decoder->feed({chunk.data(), n}, {}, run.told);
    decoder->finish(run.told);
    run.cpu_s = cpu_seconds(RUSAGE_SELF) - begun;
    if (i == 0 || run.cpu_s < best.cpu_s) best = run;
  }
  return best;
}

/// `text` over and over; the file ends with a whole one.
std::string repeated(const std::string& text) {
  std::string all;
  all.reserve(kFileSize + text.size());
  while (!text.empty() && all.size() < kFileSize) all += text;
  return all;
}

void write_file(const std::string& path, const std::string& text) {
  std::ofstream(path, std::ios::binary) << text;
}

/// The sentences of a log without the stamps and comments around them.
std::string sentences_of(const std::string& log) {
  std::string out;
  for (std::size_t begin = 0; begin < log.size();) {
    const std::size_t end = std::min(log.find('\n', begin), log.size() - 1) + 1;
    const std::size_t start = log.find_first_of("$!#\n", begin);
    if (start != std::string::npos && (log[start] == '$' || log[start] == '!'))
      out.append(log, start, end - start);
    begin = end;
  }
  return out;
}

std::string all_logs() {
  std::vector<std::string> paths;
  for (const char* folder : {"nmea_gpsd", "nmea_signalk", "nmea_openrvdas_nbp1406"})
    for (const auto& entry :
         std::filesystem::directory_iterator(std::string(LEADLINE_TEST_DATA) + "/" + folder))
      if (entry.path().extension() == ".log" || entry.path().filename().string().substr(0, 4) == "NBP1")
        paths.push_back(entry.path().string());
  std::sort(paths.begin(), paths.end());
  std::string all;
  for (const auto& path : paths) all += sentences_of(read_file(path));
  return all;
}

/// Lines a second of gpsdecode; 0 when it is not there.
double gpsdecode_lines_per_s(const std::string& path, double lines) {
  const double begun = cpu_seconds(RUSAGE_CHILDREN);
  const int status = std::system(("gpsdecode < '" + path + "' > /dev/null 2>&1").c_str());
  return status == 0 ? lines / (cpu_seconds(RUSAGE_CHILDREN) - begun) : 0.0;
}

void nmea(const std::string& folder, const char* label, std::string text) {
  if (!text.empty() && text.back() != '\n') text += "\r\n";
  const std::string path = folder + "/nmea.txt", all = repeated(text);
  write_file(path, all);
  const auto lines = static_cast<double>(std::count(all.begin(), all.end(), '\n'));
  const Run run = decode_file("nmea0183", path);
  const double ours = lines / run.cpu_s;
  fmt::print("{}: {:.1f} MB, {:.0f} lines\n", label, static_cast<double>(all.size()) * 1e-6, lines);
  fmt::print("  leadline   {:10.0f} lines/s, {:5.0f} MB/s, checksum {:016x}\n", ours,
             static_cast<double>(all.size()) * 1e-6 / run.cpu_s, run.told.checksum);
  const auto of = [&](ByteClass c) { return run.told.reports[static_cast<std::size_t>(c)]; };
  fmt::print("             {} decoded, {} unused, {} unknown, {} refused; {}\n", of(ByteClass::decoded),
             of(ByteClass::unused), of(ByteClass::unknown), of(ByteClass::refused),
             run.told.bytes == all.size() ? "every byte is accounted for" : "BYTES ARE MISSING");
  if (const double theirs = gpsdecode_lines_per_s(path, lines); theirs > 0.0)
    fmt::print("  gpsdecode  {:10.0f} lines/s: leadline is {:.1f} times as fast\n", theirs, ours / theirs);
  else
    fmt::print("  gpsdecode is not there (Debian: gpsd-clients)\n");
  std::remove(path.c_str());
}

void binary(const std::string& folder, const char* label, const char* decoder, const std::string& telegrams) {
  const std::string path = folder + "/binary", all = repeated(telegrams);
  write_file(path, all);
  const Run run = decode_file(decoder, path);
  fmt::print("{}: {:.0f} MB/s, {:.0f} telegrams/s{}\n", label,
             static_cast<double>(all.size()) * 1e-6 / run.cpu_s,
             static_cast<double>(run.told.reports[0]) / run.cpu_s,
             run.told.bytes == all.size() ? "" : ", BYTES ARE MISSING");
  std::remove(path.c_str());
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) return std::fputs("decode_speed FOLDER\n", stderr), 2;
  nmea(argv[1], "real NMEA logs", all_logs());
  nmea(argv[1], "one GPS receiver", data("nmea_signalk/gps.log"));
  binary(argv[1], "PD0, Workhorse", "trdi-pd0", data("dvl_pd0_adcp/RDI_withBT.000"));
  binary(argv[1], "PD0, winriver01 with NMEA inside", "trdi-pd0", data("dvl_pd0_adcp/winriver01.PD0"));
  binary(argv[1], "MTData2", "xsens-mtdata2", data("wire-samples/xsens_mtdata2.bin"));
}
