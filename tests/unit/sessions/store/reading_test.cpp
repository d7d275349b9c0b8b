// Parts of a run: in bus order, from behind, by time.

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "tests/unit/sessions/made_session.h"

namespace leadline::sessions {
namespace {

using test::MadeFolder;

class SessionReadingIn : public testing::Test {
 protected:
  void SetUp() override {
    test::MessageMaker maker;
    messages_ = test::mixed_messages(12'000, maker);
    ASSERT_NO_FATAL_FAILURE(test::make_session(folder_.file("s.leadline"), messages_));
    auto opened = Session::open(folder_.file("s.leadline"), Access::read);
    ASSERT_TRUE(opened) << opened.error().line();
    session_.emplace(std::move(opened).value());
  }
  std::vector<Envelope> read(const Reading& reading) {
    std::vector<Envelope> all;
    const auto done = session_->read_between(1, reading, [&](const Envelope& e) {
      all.push_back(e);
      return true;
    });
    EXPECT_TRUE(done) << done.error().line();
    return all;
  }

  MadeFolder folder_;
  std::vector<test::KeptEnvelope> messages_;
  std::optional<Session> session_;
};

TEST_F(SessionReadingIn, BetweenGivesEveryMessageInBusOrderAsItWasTaken) {
  for (const auto& [first, end] : std::vector<std::pair<std::uint64_t, std::uint64_t>>{{0, UINT64_MAX},
                                                                                       {1, 12'001},
                                                                                       {700, 701},
                                                                                       {5'000, 5'200},
                                                                                       {11'990, 99'999},
                                                                                       {20'000, 30'000},
                                                                                       {9, 3}}) {
    Reading reading;
    reading.first_seq = first, reading.end_seq = end;
    const auto found = read(reading);
    std::size_t i = 0;
    for (const auto& kept : messages_) {
      const Envelope& e = kept.envelope;
      if (e.seq < first || e.seq >= end) continue;
      ASSERT_LT(i, found.size());
      EXPECT_EQ(found[i].seq, e.seq);
      EXPECT_EQ(found[i].arrival, e.arrival) << e.seq;
      EXPECT_EQ(found[i].valid, e.valid) << e.seq;
      EXPECT_EQ(found[i].source, e.source) << e.seq;
      EXPECT_EQ(found[i].raw, e.raw) << e.seq;
      EXPECT_EQ(found[i].message, e.message) << e.seq;  // a frame's bytes are left out on both sides
      ++i;
    }
    EXPECT_EQ(i, found.size());
  }
}

TEST_F(SessionReadingIn, HeadsHaveTheirKindSourceAndTimesOnly) {
  Reading reading;
  reading.whole = kinds_of<Solution, ModeChange>();
  reading.heads = kinds_of<Heading, Solution>();
  std::size_t solutions = 0, headings = 0, changes = 0;
  for (const Envelope& e : read(reading)) {
    const Envelope& made = messages_[e.seq - 1].envelope;
    EXPECT_EQ(e.message.index(), made.message.index());
    EXPECT_EQ(e.source, made.source);
    EXPECT_EQ(e.arrival, made.arrival);
    solutions += std::holds_alternative<Solution>(e.message) ? 1 : 0;
    changes += std::holds_alternative<ModeChange>(e.message) ? 1 : 0;
    if (std::holds_alternative<Heading>(e.message)) {
      ++headings;
      EXPECT_EQ(e.message, Message(Heading{}));
    } else {
      EXPECT_EQ(e.message, made.message);
    }
  }
  const auto made = [&](std::size_t kind) {
    return static_cast<std::size_t>(std::count_if(messages_.begin(), messages_.end(), [&](const auto& kept) {
      return kept.envelope.message.index() == kind;
    }));
  };
  EXPECT_EQ(solutions, made(Message(Solution{}).index()));
  EXPECT_EQ(headings, made(Message(Heading{}).index()));
  EXPECT_EQ(changes, made(Message(ModeChange{}).index()));
}

TEST_F(SessionReadingIn, StoppingStopsAtOnceAndTheNextQuestionBeginsAnew) {
  for (int round = 0; round < 3; ++round) {
    int given = 0;
    ASSERT_TRUE(session_->read_between(1, {}, [&](const Envelope&) { return ++given < 5'000; }));
    EXPECT_EQ(given, 5'000);
  }
  EXPECT_EQ(read({}).size(), 12'000U);
}

TEST_F(SessionReadingIn, LastBeforeIsTheNewestOfThatSpeaker) {
  std::mt19937 random(5);
  for (int i = 0; i < 300; ++i) {
    const std::uint64_t end = random() % 12'500;
    const std::uint64_t floor = i % 3 == 0 ? random() % 12'000 : 0;
    Speaker speaker;
    if (i % 2 == 0) speaker.source = static_cast<SourceId>(random() % 2);
    if (i % 5 == 0) speaker.engine = i % 10 == 0 ? kShipTrack : EngineId{1};
    const Envelope* expected = nullptr;
    for (const auto& kept : messages_) {
      const auto* s = std::get_if<Solution>(&kept.envelope.message);
      if (s == nullptr || kept.envelope.seq >= end || kept.envelope.seq < floor) continue;
      if (speaker.source && kept.envelope.source != *speaker.source) continue;
      if (speaker.engine && s->engine != *speaker.engine) continue;
      expected = &kept.envelope;
    }
    const auto found = session_->last_before<Solution>(1, end, speaker, floor);
    ASSERT_TRUE(found) << found.error().line();
    ASSERT_EQ(found.value().has_value(), expected != nullptr) << i;
    if (expected != nullptr) {
      EXPECT_EQ(found.value()->seq, expected->seq);
      EXPECT_EQ(found.value()->message, expected->message);
    }
  }
  EXPECT_FALSE(session_->last_before<Solution>(7, 1'000).value());
  Speaker nobody;
  nobody.source = 77;
  EXPECT_FALSE(session_->last_before<Solution>(1, 9'000, nobody).value());
  const auto three = session_->read_last(1, Message(Heading{}).index(), 12'001, 3).value();
  ASSERT_EQ(three.size(), 3U);
  EXPECT_LT(three[0].seq, three[1].seq);
  EXPECT_LT(three[1].seq, three[2].seq);
}

TEST_F(SessionReadingIn, SeekAfterFindsTheFirstMessageOfAnyKindHeardLater) {
  std::mt19937 random(6);
  const std::int64_t last_ns = messages_.back().envelope.arrival.ns;
  for (int i = 0; i < 200; ++i) {
    Arrival t{test::kStartNs - 1'000'000'000 +
              static_cast<std::int64_t>(random() % 1'000'000) * ((last_ns - test::kStartNs) / 990'000)};
    if (i % 2 == 0) t = messages_[random() % messages_.size()].envelope.arrival;
    const auto later = std::find_if(messages_.begin(), messages_.end(),
                                    [&](const auto& kept) { return kept.envelope.arrival > t; });
    const std::uint64_t expected = later == messages_.end() ? 12'001 : later->envelope.seq;
    const auto found = session_->seek_after(1, t);
    ASSERT_TRUE(found) << found.error().line();
    EXPECT_EQ(found.value(), expected);
  }
  EXPECT_EQ(session_->seek_after(1, {INT64_MAX}).value(), 12'001U);
  EXPECT_EQ(session_->seek_after(9, {0}).value(), 1U);
}

TEST(SessionReading, ARunThatKeepsNoFramesIsSoughtByItsFacts) {
  MadeFolder folder;
  test::MessageMaker maker;
  const auto messages = test::mixed_messages(3'000, maker);
  auto info = test::two_source_run(RunKind::replay);
  info.store_frames = false;
  ASSERT_NO_FATAL_FAILURE(test::make_session(folder.file("s.leadline"), messages, info));
  auto session = Session::open(folder.file("s.leadline"), Access::read);
  ASSERT_TRUE(session);
  for (std::size_t i = 0; i < messages.size(); i += 97) {
    const Arrival t = messages[i].envelope.arrival;
    const auto later = std::find_if(messages.begin(), messages.end(), [&](const auto& kept) {
      return kept.envelope.arrival > t && !std::holds_alternative<RawFrame>(kept.envelope.message);
    });
    if (later == messages.end()) continue;
    EXPECT_EQ(session.value().seek_after(1, t).value(), later->envelope.seq);
  }
}

TEST(SessionReading, WhatIsCommittedMeanwhileIsReadTooAndTheRecorderNeverWaits) {
  MadeFolder folder;
  const std::string path = folder.file("s.leadline");
  auto recorder =
      Recorder::start(Session::create(path, {}).value(), test::two_source_run(), test::lossless());
  ASSERT_TRUE(recorder);
  test::MessageMaker maker;
  const auto messages = test::mixed_messages(20'000, maker);
  auto session = Session::open(path, Access::read);
  ASSERT_TRUE(session);
  std::uint64_t next = 1;
  for (std::size_t i = 0; i < messages.size(); ++i) {
    recorder.value()->take(messages[i].shown());
    if (i % 1'000 != 0) continue;
    Reading reading;
    reading.first_seq = next;
    ASSERT_TRUE(session.value().read_between(1, reading, [&](const Envelope& e) {
      EXPECT_EQ(e.seq, next);  // nothing is passed over, whatever is committed between two looks
      ++next;
      return true;
    }));
  }
  ASSERT_TRUE(recorder.value()->finish());
  Reading reading;
  reading.first_seq = next;
  ASSERT_TRUE(session.value().read_between(1, reading, [&](const Envelope& e) {
    EXPECT_EQ(e.seq, next);
    ++next;
    return true;
  }));
  EXPECT_EQ(next, 20'001U);
}

}  // namespace
}  // namespace leadline::sessions
