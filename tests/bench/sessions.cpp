// The recorder against a bare loop of one prepared statement on the same disk, and what a long session costs.
//
//   session_bench FOLDER [HOURS]    a session of HOURS (24) at 50 messages a second is made in FOLDER
//   as long.leadline

#include <sqlite3.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <random>
#include <string>
#include <vector>

#include "sessions/recorder/recorder.h"

namespace {

using namespace leadline;
using Steady = std::chrono::steady_clock;

constexpr std::int64_t kStartNs = 1'700'000'000'000'000'000;

double since(Steady::time_point begun) {
  return std::chrono::duration<double>(Steady::now() - begun).count();
}

sessions::RunInfo run_info() {
  sessions::RunInfo info;
  info.started = {kStartNs};
  info.engines = {"fusion"};
  info.sources.resize(1);
  info.sources[0].info.id = 0, info.sources[0].info.name = "gps";
  return info;
}

Solution solution(std::uint64_t n) {
  Solution s;
  const double x = static_cast<double>(n);
  s.position = {Angle::rad(0.6 + x * 1.1e-9), Angle::rad(2.2 - x * 1.3e-9)};
  s.depth = Depth{50.0 + x * 1e-6};
  s.roll = Angle::rad(x * 1e-7), s.pitch = Angle::rad(-x * 1e-7), s.heading = Angle::rad(1.234567 + x * 1e-9);
  s.vel_north_mps = 1.1 + x * 1e-8, s.vel_east_mps = -0.4 + x * 1e-8, s.vel_down_mps = 0.01 + x * 1e-9;
  s.var_north_m2 = 2.3 + x * 1e-9, s.cov_north_east_m2 = 0.1 + x * 1e-9, s.var_east_m2 = 2.1 + x * 1e-9;
  s.mode = Mode::A, s.position_source = PositionSource::gnss;
  return s;
}

Envelope envelope(std::uint64_t seq, std::int64_t arrival_ns) {
  Envelope e;
  e.seq = seq;
  e.arrival = {arrival_ns};
  e.valid = e.wall_utc = e.arrival.host();
  e.source = 0;
  return e;
}

/// Depths in a row through the whole recorder; rows a second and bytes a row.
void recorder_rate(const std::string& path, std::uint64_t rows) {
  sessions::Session::Birth birth;
  birth.force = true;
  sessions::Recorder::Options options;
  options.lossless = true;
  auto recorder =
      sessions::Recorder::start(sessions::Session::create(path, birth).value(), run_info(), options).value();
  const auto begun = Steady::now();
  for (std::uint64_t n = 1; n <= rows; ++n) {
    Envelope e = envelope(n, kStartNs + static_cast<std::int64_t>(n) * 1'000'000);
    e.raw = n;
    e.message = DepthMeasured{Depth{static_cast<double>(n) * 1e-3 + 0.1}, 0.123};
    recorder->take(e);
  }
  const double taken_s = since(begun);
  const bool done = recorder->finish().ok();
  const double written_s = since(begun);
  std::printf("recorder: %.0f rows/s (%s), taken at %.0f ns each, %.1f bytes a row\n",
              static_cast<double>(rows) / written_s, done ? "all on the disk" : "failed",
              taken_s / static_cast<double>(rows) * 1e9,
              static_cast<double>(std::filesystem::file_size(path)) / static_cast<double>(rows));
}

/// The same columns by one prepared statement, commits of 20,000 rows, no foreign keys, no queue.
void bare_rate(const std::string& path, std::uint64_t rows) {
  std::filesystem::remove(path);
  sqlite3* database = nullptr;
  sqlite3_open(path.c_str(), &database);
  sqlite3_exec(
      database,
      "PRAGMA journal_mode = WAL; PRAGMA synchronous = NORMAL; CREATE TABLE depth (id INTEGER PRIMARY "
      "KEY, frame INTEGER, source INTEGER, valid_ns INTEGER NOT NULL, heard_after_ns INTEGER NOT NULL, "
      "depth_m REAL, sd_m REAL) STRICT",
      nullptr, nullptr, nullptr);
  sqlite3_stmt* insert = nullptr;
  sqlite3_prepare_v2(database, "INSERT INTO depth VALUES (?, ?, ?, ?, ?, ?, ?)", -1, &insert, nullptr);
  const auto begun = Steady::now();
  for (std::uint64_t n = 1; n <= rows; ++n) {
    if (n % 20'000 == 1) sqlite3_exec(database, "BEGIN", nullptr, nullptr, nullptr);
    const auto i = static_cast<std::int64_t>(n);
    const std::int64_t id = (std::int64_t{1} << 36) + i;
    sqlite3_bind_int64(insert, 1, id), sqlite3_bind_int64(insert, 2, id), sqlite3_bind_int64(insert, 3, 1);
    sqlite3_bind_int64(insert, 4, kStartNs + i * 1'000'000), sqlite3_bind_int64(insert, 5, 0);
    sqlite3_bind_double(insert, 6, static_cast<double>(n) * 1e-3 + 0.1),
        sqlite3_bind_double(insert, 7, 0.123);
    sqlite3_step(insert);
    sqlite3_reset(insert);
    if (n % 20'000 == 0 || n == rows) sqlite3_exec(database, "COMMIT", nullptr, nullptr, nullptr);
  }
  sqlite3_finalize(insert);
  sqlite3_close(database);
  std::printf("bare prepared statement: %.0f rows/s\n", static_cast<double>(rows) / since(begun));
  std::filesystem::remove(path);
}

/// 50 messages a second: 20 sentences of 75 bytes, a fix or depth of each, 10 solutions.
void long_session(const std::string& path, double hours) {
  sessions::Session::Birth birth;
  birth.force = true;
  sessions::Recorder::Options options;
  options.lossless = true;
  const auto seconds = static_cast<std::int64_t>(hours * 3600.0);
  std::uint64_t seq = 0;
  const auto begun = Steady::now();
  {
    auto recorder =
        sessions::Recorder::start(sessions::Session::create(path, birth).value(), run_info(), options)
            .value();
    std::vector<std::uint8_t> bytes(75, '$');
    for (std::int64_t s = 0; s < seconds; ++s) {
      for (int i = 0; i < 20; ++i) {
        const std::int64_t at_ns = kStartNs + s * 1'000'000'000 + i * 50'000'000;
        Envelope e = envelope(++seq, at_ns);
        e.message = RawFrame{bytes};
        recorder->take(e);
        e.raw = seq;
        e.seq = ++seq;
        if (i % 2 == 0)
          e.message =
              GnssFix{solution(seq).position, EllipsoidHeight{31.25}, GnssQuality::autonomous, 11, 0.9};
        else
          e.message = DepthMeasured{Depth{50.0 + 1e-6 * static_cast<double>(seq)}, {}};
        recorder->take(e);
        if (i % 2 != 0) continue;
        e.seq = ++seq;
        e.raw = 0;
        e.message = solution(seq);
        recorder->take(e);
      }
    }
    if (const auto done = recorder->finish(); !done) std::printf("%s\n", done.error().line().c_str());
  }
  const double wall_s = since(begun);
  const double bytes = static_cast<double>(std::filesystem::file_size(path));
  std::printf(
      "%.0f h at 50 messages/s: %llu messages written in %.1f s (%.0f/s), %.0f MiB, %.1f bytes a message\n",
      hours, static_cast<unsigned long long>(seq), wall_s, static_cast<double>(seq) / wall_s,
      bytes / 1048576.0, bytes / static_cast<double>(seq));
  for (const auto access : {sessions::Access::read, sessions::Access::append}) {
    const auto opening = Steady::now();
    const auto session = sessions::Session::open(path, access);
    std::printf("opened to %s in %.1f ms\n", access == sessions::Access::read ? "read" : "append",
                since(opening) * 1e3);
  }
  auto session = sessions::Session::open(path, sessions::Access::read).value();
  std::mt19937_64 random(3);
  std::vector<double> times_us;
  for (int i = 0; i < 1000; ++i) {
    const auto second = static_cast<std::int64_t>(random() % static_cast<std::uint64_t>(seconds));
    const auto asking = Steady::now();
    const auto found = session.seek(1, {kStartNs + second * 1'000'000'000});
    times_us.push_back(since(asking) * 1e6);
    if (!found || !found.value()) std::printf("second %lld is not there\n", static_cast<long long>(second));
  }
  std::sort(times_us.begin(), times_us.end());
  std::printf("seek to a second: median %.0f us, p99 %.0f us, worst %.0f us\n", times_us[500], times_us[990],
              times_us[999]);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2) return std::fprintf(stderr, "session_bench FOLDER [HOURS]\n"), 2;
  const std::string folder = argv[1];
  constexpr std::uint64_t kRows = 1'000'000;
  bare_rate(folder + "/bare.db", kRows);
  recorder_rate(folder + "/rate.leadline", kRows);
  std::filesystem::remove(folder + "/rate.leadline");
  long_session(folder + "/long.leadline", argc > 2 ? std::atof(argv[2]) : 24.0);
  return 0;
}
