// The promise: if the program dies, nothing that was shown as recorded is missing, and at most the last
// 250 ms of input is. LEADLINE_KILL_ROUNDS=200 for the long form.

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <cstring>
#include <random>
#include <thread>

#include "sessions/store/frames.h"
#include "tests/unit/sessions/made_session.h"

namespace leadline::sessions {
namespace {

struct Told {
  std::uint64_t acknowledged = 0, taken = 0;
};

/// Starts the writer, lets it live for a while, kills it; the last thing it said.
Told killed_after(const std::string& path, std::chrono::milliseconds life) {
  int pipe_ends[2];
  EXPECT_EQ(::pipe(pipe_ends), 0);
  const pid_t child = ::fork();
  if (child == 0) {
    ::dup2(pipe_ends[1], STDOUT_FILENO);
    ::close(pipe_ends[0]);
    ::close(pipe_ends[1]);
    ::execl(LEADLINE_KILL_WRITER, LEADLINE_KILL_WRITER, path.c_str(), static_cast<char*>(nullptr));
    ::_exit(127);
  }
  ::close(pipe_ends[1]);
  Told first, last;
  // Its life is counted from its first word: starting takes long under sanitizers.
  bool speaks = ::read(pipe_ends[0], &first, sizeof first) == sizeof first;
  std::thread killer([&] {
    std::this_thread::sleep_for(life);
    ::kill(child, SIGKILL);
  });
  for (Told told = first; speaks; speaks = ::read(pipe_ends[0], &told, sizeof told) == sizeof told)
    last = told;
  killer.join();
  ::close(pipe_ends[0]);
  int status = 0;
  ::waitpid(child, &status, 0);
  EXPECT_TRUE(WIFSIGNALED(status)) << "the writer ended by itself: " << WEXITSTATUS(status);
  return last;
}

TEST(SessionKill, NothingAcknowledgedIsLostAndAQuarterOfASecondOfInputAtMost) {
  const char* asked = std::getenv("LEADLINE_KILL_ROUNDS");
  const int rounds = asked != nullptr ? std::atoi(asked) : 20;
  const test::MadeFolder folder;
  std::mt19937 random(11);
  std::uint64_t acknowledged = 0, worst_lost = 0;
  double worst_open_s = 0.0;
  RunId run = 0;
  std::string path;
  for (int round = 0; round < rounds; ++round) {
    if (round % 5 == 0) path = folder.file(std::to_string(round) + ".leadline"), run = 0;  // then it goes on
    const Told told = killed_after(path, std::chrono::milliseconds(50 + random() % 550));
    ++run;
    const auto begun = std::chrono::steady_clock::now();
    auto session = Session::open(path, Access::append);
    ASSERT_TRUE(session) << session.error().line();
    worst_open_s = std::max(worst_open_s,
                            std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count());
    const auto sound = session.value().check();
    ASSERT_TRUE(sound) << sound.error().line();
    const auto runs = session.value().runs().value();
    ASSERT_EQ(runs.size(), static_cast<std::size_t>(run)) << "it goes on as the same session";
    FrameReader reader(session.value(), run);
    StoredFrame frame;
    std::uint64_t kept = 0;
    while (reader.next(frame).value()) {
      std::uint64_t number = 0;
      std::memcpy(&number, frame.bytes.data(), sizeof number);
      ASSERT_EQ(number, ++kept);
    }
    ASSERT_GE(kept, told.acknowledged);
    acknowledged += told.acknowledged;
    worst_lost = std::max(worst_lost, told.taken > kept ? told.taken - kept : 0);
    const auto events = session.value().events().value();
    EXPECT_EQ(events.size(), static_cast<std::size_t>(run - 1))
        << "a gap mark for each death before this one";
  }
  std::printf(
      "kill -9: %d rounds, %llu frames acknowledged, 0 lost; input lost at most %llu ms; opened in at "
      "most %.0f ms\n",
      rounds, static_cast<unsigned long long>(acknowledged), static_cast<unsigned long long>(worst_lost),
      worst_open_s * 1e3);
  EXPECT_GT(acknowledged, 0U);
  EXPECT_LE(worst_lost, 250U);  // a frame a millisecond
}

}  // namespace
}  // namespace leadline::sessions
