// `leadline record` on real links: pseudo-terminals, datagrams and TCP by system calls, contents compared.
// The long forms: LEADLINE_LIVE_LONG=1, with LEADLINE_LIVE_PROGRAM naming the release build's program.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/live_load.h"
#include "tests/support/program.h"

namespace leadline::test {
namespace {

using namespace std::chrono_literals;
using testing::HasSubstr;
using Kind = LiveLoad::Kind;

bool long_form() { return std::getenv("LEADLINE_LIVE_LONG") != nullptr; }
double seconds_of(double brief, double full) { return long_form() ? full : brief; }
std::string program() {
  const char* other = std::getenv("LEADLINE_LIVE_PROGRAM");
  return other != nullptr ? other : LEADLINE_PROGRAM;
}
Kind in_turn(int i) { return static_cast<Kind>(i % 3); }
Kind all_terminals(int) { return Kind::terminal; }
Kind all_udp(int) { return Kind::udp; }

class RecordTest : public testing::Test {
 protected:
  std::unique_ptr<RecordProcess> record(const LiveLoad& load, const std::string& more = "") {
    write_file(config_, load.configuration(more));
    return std::make_unique<RecordProcess>(program(), config_, session_, folder_ + "/err");
  }
  /// Everything that was sent is in the session, byte for byte and in order.
  static void expect_all_kept(LiveLoad& load, const std::string& session) {
    auto kept = recorded_frames(session);
    for (const auto& instrument : load.instruments()) {
      EXPECT_EQ(joined(kept[instrument.name]), joined(instrument.sent)) << instrument.name;
      if (instrument.kind == Kind::udp) {
        EXPECT_EQ(kept[instrument.name], instrument.sent) << instrument.name;
      }
    }
  }
  static std::string line_with(const std::string& text, const std::string& words) {
    const auto at = text.find(words);
    if (at == std::string::npos) return "(nothing about " + words + ")";
    const auto begin = text.rfind('\n', at) + 1;
    return text.substr(begin, text.find('\n', at) - begin);
  }
  /// Waits until the program has recorded what it was sent.
  static void settle() { std::this_thread::sleep_for(500ms); }

  std::string folder_ = scratch_folder();
  std::string config_ = folder_ + "/live.toml", session_ = folder_ + "/live.leadline";
};

TEST_F(RecordTest, WhatIsSentIsStoredAndReplaysToTheSameBits) {
  LiveLoad load(folder_, 8, in_turn);
  const auto process = record(load);
  load.meet();
  ASSERT_TRUE(process->opens(8)) << process->said();
  load.send_all(seconds_of(400.0, 1000.0), seconds_of(3.0, 60.0));
  settle();
  EXPECT_EQ(process->end(SIGTERM), 0) << process->said();
  expect_all_kept(load, session_);
  std::printf("%lu telegrams of 8 instruments sent and stored\n%s\n", load.telegrams(),
              line_with(process->said(), "arrival to solution").c_str());

  ASSERT_EQ(leadline("export " + session_ + " --format csv --output " + folder_ + "/live").status, 0);
  ASSERT_EQ(leadline("replay " + session_ + " --csv " + folder_ + "/replayed").status, 0);
  const std::string rows = read_text(folder_ + "/live/fusion.csv");
  EXPECT_GT(std::count(rows.begin(), rows.end(), '\n'), 20);
  for (const char* file : {"fusion.csv", "ship.csv", "fixes.csv"})
    EXPECT_EQ(read_text(folder_ + "/replayed/" + file), read_text(folder_ + "/live/" + file)) << file;
}

TEST_F(RecordTest, UnpluggedTerminalsComeBackAndNothingGrows) {
  const int rounds = long_form() ? 20 : 2;
  LiveLoad load(folder_, 8, all_terminals);
  const auto process = record(load);
  ASSERT_TRUE(process->opens(8)) << process->said();
  load.send_all(400.0, 0.5);
  settle();
  const auto before = process->usage();
  double worst_back_s = 0.0, dead_cpu = 0.0;
  for (int round = 0; round < rounds; ++round) {
    for (auto& instrument : load.instruments()) {
      const std::string half = "$HEHDT,12";  // unplugged in mid-sentence
      ASSERT_EQ(::write(instrument.peer.file(), half.data(), half.size()), 9);
      instrument.sent.push_back(half);
    }
    std::this_thread::sleep_for(50ms);
    for (auto& instrument : load.instruments()) {
      instrument.peer.close();
      std::filesystem::remove(instrument.path);
    }
    if (round == 0) {
      const double cpu_s = process->usage().cpu_s, wait_s = seconds_of(1.0, 10.0);
      std::this_thread::sleep_for(std::chrono::duration<double>(wait_s));
      dead_cpu = (process->usage().cpu_s - cpu_s) / wait_s / 8.0;
    } else {
      std::this_thread::sleep_for(300ms);
    }
    const auto plugged = std::chrono::steady_clock::now();
    for (auto& instrument : load.instruments()) LiveLoad::plug(instrument);
    for (auto& instrument : load.instruments()) {
      ASSERT_TRUE(comes_about([&] { return LiveLoad::heard(instrument); })) << process->said();
      worst_back_s = std::max(
          worst_back_s, std::chrono::duration<double>(std::chrono::steady_clock::now() - plugged).count());
    }
    std::this_thread::sleep_for(50ms);  // open, and set up
    load.send_all(400.0, 0.2);
  }
  settle();
  const auto after = process->usage();
  EXPECT_EQ(after.handles, before.handles);
  EXPECT_EQ(after.threads, before.threads);
  EXPECT_EQ(process->end(SIGTERM), 3) << "half sentences were refused";
  expect_all_kept(load, session_);
  std::printf(
      "%d unplugs of 8 terminals: back after %.2f s at most; handles %zu -> %zu, threads %zu -> %zu, "
      "memory %zu -> %zu KiB; CPU of a dead port %.2f %%\n",
      rounds, worst_back_s, before.handles, after.handles, before.threads, after.threads, before.resident_kib,
      after.resident_kib, dead_cpu * 100.0);
}

TEST_F(RecordTest, AFloodOfGarbageCostsNoSentence) {
  LiveLoad load(folder_, 4, all_udp);
  const std::uint16_t flooded = port_of(udp_peer());
  const auto process =
      record(load, "[[source]]\nname = \"flooded\"\nlink = \"udp://127.0.0.1:" + std::to_string(flooded) +
                       "\"\ndecoder = \"nmea0183\"\nbody = \"ship\"\n");
  ASSERT_TRUE(process->opens(5)) << process->said();
  load.send_all(400.0, 1.0);
  const auto before = process->usage();
  Flood::Sum sent;
  std::size_t most_kib = 0;
  {
    std::thread sender([&] { load.send_all(seconds_of(400.0, 1000.0), seconds_of(2.0, 30.0)); });
    Flood flood(flooded, seconds_of(2e6, 20e6));
    for (int i = 0; i < static_cast<int>(seconds_of(20, 300)); ++i) {
      std::this_thread::sleep_for(100ms);
      most_kib = std::max(most_kib, process->usage().resident_kib);
    }
    sent = flood.end();
    sender.join();
  }
  settle();
  if (long_form()) std::this_thread::sleep_for(2s);
  EXPECT_EQ(process->end(SIGTERM), 3);
  auto kept = recorded_frames(session_);
  for (const auto& instrument : load.instruments()) EXPECT_EQ(kept[instrument.name], instrument.sent);
  Flood::Sum stored;
  for (const auto& datagram : kept["flooded"]) stored.add(datagram);
  EXPECT_EQ(stored, sent);
  std::printf(
      "flood of %.1f MB/s: %lu datagrams, all recorded; %lu sentences beside it, 0 lost; memory %zu -> "
      "%zu KiB\n%s\n%s\n",
      static_cast<double>(sent.bytes) / seconds_of(2.0, 30.0) * 1e-6, sent.datagrams, load.telegrams(),
      before.resident_kib, most_kib, line_with(process->said(), "arrival to solution").c_str(),
      line_with(process->said(), ": " + std::to_string(sent.bytes) + " bytes in").c_str());
}

TEST_F(RecordTest, AnOverloadOfGoodSentencesIsRecordedWhole) {
  LiveLoad load(folder_, 8, [](int i) { return i < 6 ? Kind::udp : Kind::tcp; });
  const auto process = record(load);
  load.meet();
  ASSERT_TRUE(process->opens(8)) << process->said();
  const auto before = process->usage();
  load.send_all(seconds_of(2'000.0, 20'000.0), seconds_of(2.0, 30.0));
  settle();
  const auto after = process->usage();
  EXPECT_EQ(process->end(SIGTERM), 0) << process->said();
  expect_all_kept(load, session_);
  std::printf("%lu telegrams in %.0f s, all recorded; memory %zu -> %zu KiB; CPU %.0f %%\n%s\n",
              load.telegrams(), seconds_of(2.0, 30.0), before.resident_kib, after.resident_kib,
              100.0 * (after.cpu_s - before.cpu_s) / seconds_of(2.0, 30.0),
              line_with(process->said(), "arrival to solution").c_str());
}

TEST_F(RecordTest, KilledItGoesOnInTheSameSessionAndSaysWhatWasKept) {
  const int rounds = long_form() ? 50 : 3;
  std::mt19937 random(3);
  std::size_t worst_lost = 0;
  double worst_lost_ms = 0.0;
  for (int round = 0; round < rounds; ++round) {
    if (round % 10 == 0)
      for (const auto& suffix : {"", "-wal", "-shm", "-input"}) std::filesystem::remove(session_ + suffix);
    const auto run = static_cast<sessions::RunId>(round % 10 + 1);
    LiveLoad load(folder_, 4, all_udp);
    const auto process = record(load);
    ASSERT_TRUE(process->opens(4)) << process->said();
    if (round % 10 > 0) {
      EXPECT_THAT(process->said(), HasSubstr("goes on; its last run kept"));
      EXPECT_THAT(process->said(), HasSubstr("it was not ended"));
    }
    constexpr double kPer_s = 1000.0;
    load.send_all(kPer_s, 0.3 + static_cast<double>(random() % 700) * 1e-3);
    EXPECT_EQ(process->end(SIGKILL), -1);
    auto kept = recorded_frames(session_, run);
    std::size_t lost = 0;
    for (const auto& instrument : load.instruments()) {
      const auto& frames = kept[instrument.name];
      ASSERT_LE(frames.size(), instrument.sent.size());
      EXPECT_TRUE(std::equal(frames.begin(), frames.end(), instrument.sent.begin())) << instrument.name;
      lost += instrument.sent.size() - frames.size();
    }
    worst_lost = std::max(worst_lost, lost);
    worst_lost_ms = std::max(worst_lost_ms, static_cast<double>(lost) / kPer_s * 1e3);
  }
  // How much was under way when it died depends on the machine; the figure is told.
  std::printf("killed %d times at 1000 telegrams/s: at most %zu lost, the last %.0f ms\n", rounds, worst_lost,
              worst_lost_ms);
  auto session = sessions::Session::open(session_, sessions::Access::append);
  ASSERT_TRUE(session) << session.error().line();
  EXPECT_TRUE(session.value().check());
}

TEST_F(RecordTest, APortInUseIsSaidAndTheOthersAreHeard) {
  LiveLoad load(folder_, 4, all_udp);
  const Peer holder = udp_peer();
  const auto process = record(
      load, "[[source]]\nname = \"late\"\nlink = \"udp://127.0.0.1:" + std::to_string(port_of(holder)) +
                "\"\ndecoder = \"nmea0183\"\nbody = \"ship\"\n");
  ASSERT_TRUE(process->opens(4)) << process->said();
  load.send_all(200.0, 0.5);
  ASSERT_TRUE(comes_about([&] { return process->said_count("another program listens on this port") > 0; }))
      << process->said();
  settle();
  EXPECT_EQ(process->end(SIGINT), 0) << process->said();
  expect_all_kept(load, session_);
}

TEST_F(RecordTest, AnEndlessLineCostsNoMemoryAndTheNextSentenceIsDecoded) {
  LiveLoad load(folder_, 1, [](int) { return Kind::tcp; });
  const auto process = record(load);
  load.meet();
  ASSERT_TRUE(process->opens(1)) << process->said();
  auto& instrument = load.instruments().front();
  load.send(instrument);
  settle();
  const auto before = process->usage();
  const std::string endless(1 << 20, 'x');
  for (int i = 0; i < 16; ++i) {
    for (std::size_t done = 0; done < endless.size();) {
      const auto n = ::write(instrument.peer.file(), endless.data() + done, endless.size() - done);
      ASSERT_GT(n, 0);
      done += static_cast<std::size_t>(n);
    }
    instrument.sent.push_back(endless);
  }
  std::this_thread::sleep_for(
      2s);  // a slow machine may still be at the line, and leaves what is late undecoded
  for (int i = 0; i < 10; ++i) {
    load.send(instrument);
    std::this_thread::sleep_for(100ms);  // a fix of its own each
  }
  settle();
  const auto after = process->usage();
  EXPECT_EQ(process->end(SIGTERM), 3);
  expect_all_kept(load, session_);
  ASSERT_EQ(leadline("replay " + session_ + " --csv " + folder_ + "/csv").status, 3);
  const std::string fixes = read_text(folder_ + "/csv/fixes.csv");
  // A header, the position before, and behind the rubbish others again.
  EXPECT_GE(std::count(fixes.begin(), fixes.end(), '\n'), 4) << fixes;
  std::printf("16 MiB without a line's end: memory %zu -> %zu KiB\n", before.resident_kib,
              after.resident_kib);
}

TEST_F(RecordTest, NoPortIsOpenButThoseConfigured) {
  LiveLoad load(folder_, 4, all_udp);
  const auto process = record(load);
  ASSERT_TRUE(process->opens(4)) << process->said();
  std::size_t sockets = 0;
  for (const auto& entry :
       std::filesystem::directory_iterator("/proc/" + std::to_string(process->pid()) + "/fd")) {
    std::error_code gone;
    if (std::filesystem::read_symlink(entry, gone).string().rfind("socket:", 0) == 0) ++sockets;
  }
  EXPECT_EQ(sockets, 4U);
  EXPECT_EQ(process->end(SIGTERM), 0);
}

TEST_F(RecordTest, WhatIsWrongIsSaidBeforeAnythingIsOpened) {
  write_file(config_, "version = 1\n[[source]]\nname = \"a\"\ndecoder = \"nmea0183\"\n");
  auto ran = leadline("record --config " + config_ + " --session " + session_);
  EXPECT_EQ(ran.status, 2);
  EXPECT_THAT(ran.err, HasSubstr("source a has no link"));
  EXPECT_FALSE(std::filesystem::exists(session_));
  EXPECT_EQ(leadline("record --config " + config_).status, 2);
  LiveLoad load(folder_, 1, all_udp);
  write_file(config_, load.configuration());
  ran = leadline("record --duration 1 --config " + config_ + " --session " + folder_ +
                 "/missing/live.leadline");
  EXPECT_EQ(ran.status, 1);
  EXPECT_THAT(ran.err, HasSubstr("missing"));
}

}  // namespace
}  // namespace leadline::test
