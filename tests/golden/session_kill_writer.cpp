// Records 1000 frames a second into a session and tells each change of the acknowledged count on its standard
// output, until it is killed: what session_kill_test does to it.
//
//   session_kill_writer SESSION    makes it, or goes on with it

#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <thread>

#include "sessions/recorder/recorder.h"

namespace {

using namespace leadline;
using namespace std::chrono_literals;

struct Told {
  std::uint64_t acknowledged, taken;
};

int record(const std::string& path) {
  auto session = std::filesystem::exists(path) ? sessions::Session::open(path, sessions::Access::append)
                                               : sessions::Session::create(path, {});
  if (!session) return std::fprintf(stderr, "%s\n", session.error().line().c_str()), 1;
  sessions::RunInfo info;
  info.started = {1'700'000'000'000'000'000};
  info.sources.resize(1);
  info.sources[0].info.id = 0, info.sources[0].info.name = "load";
  auto recorder = sessions::Recorder::start(std::move(session).value(), info, {});
  if (!recorder) return std::fprintf(stderr, "%s\n", recorder.error().line().c_str()), 1;
  std::array<std::uint8_t, 80> bytes{};
  std::uint64_t told = 0;
  const auto begun = std::chrono::steady_clock::now();
  for (std::uint64_t n = 1;; ++n) {
    std::this_thread::sleep_until(begun + n * 1ms);
    std::memcpy(bytes.data(), &n, sizeof n);
    Envelope e;
    e.seq = n;
    e.arrival = {info.started.ns + static_cast<std::int64_t>(n) * 1'000'000};
    e.valid = e.wall_utc = e.arrival.host();
    e.source = 0;
    e.message = RawFrame{bytes};
    recorder.value()->take(e);
    const Told now{recorder.value()->acknowledged(), n};
    if (now.acknowledged == told && n % 5 != 0) continue;
    told = now.acknowledged;
    if (::write(STDOUT_FILENO, &now, sizeof now) != sizeof now) return 1;
  }
}

}  // namespace

int main(int argc, char** argv) { return argc == 2 ? record(argv[1]) : 2; }
