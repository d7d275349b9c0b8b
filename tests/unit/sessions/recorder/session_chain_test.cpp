#include "sessions/recorder/session_chain.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sessions/replay/session_source.h"
#include "tests/support/files.h"
#include "tests/unit/sessions/made_session.h"

namespace leadline::sessions {
namespace {

using testing::HasSubstr;

class SessionChainTest : public testing::Test {
 protected:
  SessionChain::Begun begin(const SessionChain::Limits& limits = {}) {
    auto begun = SessionChain::begin(path_, test::two_source_run(), {}, limits);
    EXPECT_TRUE(begun) << (begun ? "" : begun.error().line());
    return std::move(begun).value();
  }
  void put(SessionChain& chain, int count) {
    for (int i = 0; i < count; ++i) {
      const std::string text = "frame " + std::to_string(sent_.size());
      sent_.push_back(text);
      Envelope envelope;
      envelope.seq = ++seq_;
      envelope.source = 0;
      envelope.arrival = {test::kStartNs + static_cast<std::int64_t>(seq_) * 1'000'000'000};
      envelope.valid = envelope.wall_utc = envelope.arrival.host();
      envelope.message = RawFrame{{reinterpret_cast<const std::uint8_t*>(text.data()), text.size()}};
      chain.take(envelope);
    }
  }
  static std::vector<std::string> frames_of(const std::string& path) {
    auto session = Session::open(path, Access::read);
    EXPECT_TRUE(session) << (session ? "" : session.error().line());
    auto source = SessionSource::open(std::move(session).value(), {{"dvl", 0}, {"gps", 1}});
    EXPECT_TRUE(source);
    std::vector<std::string> frames;
    for (Chunk chunk; source.value().next(chunk);)
      if (!chunk.bytes.empty()) frames.emplace_back(chunk.bytes.begin(), chunk.bytes.end());
    return frames;
  }

  test::MadeFolder folder_;
  std::string path_ = folder_.file("dive.leadline");
  std::vector<std::string> sent_;
  std::uint64_t seq_ = 0;
};

TEST_F(SessionChainTest, BeginsTheNextFileWhenADayIsFullAndLosesNothing) {
  auto begun = begin({.span = Duration(60'000'000'000)});
  EXPECT_THAT(begun.notes, testing::IsEmpty());
  std::vector<std::string> files{path_};
  for (int round = 0; round < 20; ++round) {
    put(*begun.chain, 10);
    const auto next = begun.chain->look();
    ASSERT_TRUE(next);
    if (next.value()) files.push_back(*next.value());
  }
  ASSERT_TRUE(begun.chain->finish());
  EXPECT_EQ(begun.chain->status().acknowledged, sent_.size());
  EXPECT_THAT(files,
              testing::ElementsAre(path_, folder_.file("dive-2.leadline"), folder_.file("dive-3.leadline")));
  std::vector<std::string> kept;
  for (const auto& file : files)
    for (auto& frame : frames_of(file)) kept.push_back(std::move(frame));
  EXPECT_EQ(kept, sent_);
  auto second = Session::open(files[1], Access::read).value();
  EXPECT_EQ(second.identity().value().predecessor, "dive.leadline");
}

TEST_F(SessionChainTest, BeginsTheNextFileWhenItIsTooLarge) {
  auto begun = begin({.bytes = 400'000});
  bool changed = false;
  for (int i = 0; i < 200 && !changed; ++i) {
    put(*begun.chain, 500);
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    changed = begun.chain->look().value().has_value();
  }
  EXPECT_TRUE(changed);
}

TEST_F(SessionChainTest, GoesOnInTheLastFileOfItsChainWithAGapMark) {
  {
    auto begun = begin({.span = Duration(5'000'000'000)});
    put(*begun.chain, 10);
    ASSERT_TRUE(begun.chain->look().value());
    put(*begun.chain, 3);
    ASSERT_TRUE(begun.chain->finish());
  }
  auto begun = begin();
  EXPECT_EQ(begun.chain->path(), folder_.file("dive-2.leadline"));
  ASSERT_EQ(begun.notes.size(), 1U);
  EXPECT_THAT(begun.notes[0], HasSubstr("its last run kept 3 frames"));
  put(*begun.chain, 4);
  ASSERT_TRUE(begun.chain->finish());
  EXPECT_EQ(frames_of(begun.chain->path()), std::vector<std::string>(sent_.begin() + 10, sent_.end()));
  auto session = Session::open(begun.chain->path(), Access::read).value();
  const auto events = session.events().value();
  EXPECT_TRUE(std::any_of(events.begin(), events.end(), [](const Event& e) { return e.kind == "gap"; }));
}

TEST_F(SessionChainTest, ADamagedSessionIsMovedAwayWholeAndANewOneBegun) {
  {
    auto begun = begin();
    put(*begun.chain, 2000);
    ASSERT_TRUE(begun.chain->finish());
  }
  auto bytes = test::read_bytes(path_);
  for (std::size_t i = 100; i < 4000; ++i) bytes[i] = static_cast<std::uint8_t>(~bytes[i]);
  std::ofstream(path_, std::ios::binary)
      .write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  sent_.clear();
  auto begun = begin();
  ASSERT_EQ(begun.notes.size(), 2U);
  EXPECT_THAT(begun.notes[1], HasSubstr("damaged-1"));
  put(*begun.chain, 5);
  ASSERT_TRUE(begun.chain->finish());
  EXPECT_EQ(frames_of(path_), sent_);
  EXPECT_EQ(test::read_bytes(path_ + ".damaged-1"), bytes);
}

TEST_F(SessionChainTest, AnotherProgramsDatabaseIsLeftAlone) {
  {
    auto begun = begin();
    ASSERT_TRUE(begun.chain->finish());
  }
  auto bytes = test::read_bytes(path_);
  bytes[68] ^= 1;  // application_id
  std::ofstream(path_, std::ios::binary)
      .write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  const auto begun = SessionChain::begin(path_, test::two_source_run(), {});
  ASSERT_FALSE(begun);
  EXPECT_EQ(test::read_bytes(path_), bytes);
}

TEST_F(SessionChainTest, SilenceAtTheEndIsPartOfTheRun) {
  auto begun = begin();
  put(*begun.chain, 3);
  Envelope tick;
  tick.arrival = {test::kStartNs + 60'000'000'000};
  tick.message = Tick{tick.arrival};
  begun.chain->take(tick);
  ASSERT_TRUE(begun.chain->finish());
  auto source =
      SessionSource::open(Session::open(path_, Access::read).value(), {{"dvl", 0}, {"gps", 1}}).value();
  Chunk chunk, last;
  while (source.next(chunk)) last = chunk;
  EXPECT_TRUE(last.bytes.empty());
  EXPECT_EQ(last.arrival, tick.arrival);
}

}  // namespace
}  // namespace leadline::sessions
