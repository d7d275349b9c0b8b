#include "ui/bridge/history_builder.h"

#include <gtest/gtest.h>

#include "tests/unit/ui/bridge/made_messages.h"

namespace leadline::ui {
namespace {

using test::Dive;
using test::dive_setup;
using test::kDiveNs;

History history_of(const Dive& dive, std::size_t take_every = 0) {
  HistoryBuilder builder(dive_setup());
  History history;
  for (std::size_t i = 0; i < dive.messages.size(); ++i) {
    builder.take(dive.messages[i]);
    if (take_every > 0 && i % take_every == 0) append(history, builder.take_new());
  }
  append(history, builder.take_new());
  return history;
}

const Track* track(const History& history, EngineId engine) {
  for (const Track& t : history.tracks)
    if (t.engine == engine) return &t;
  return nullptr;
}

TEST(History, HoldsTracksFixesModesAndEventsInTheOrderOfTime) {
  Dive dive;
  dive.sail(0.0, 60.0);
  dive.say(kNoSource, ModeChange{0, Mode::E0, Mode::B, "a fix that agrees"});
  dive.say(kNoSource, Alarm{Alarm::Priority::caution, "x", "caution text"});
  dive.say(kNoSource, Health{Health::Level::warning, "position set anew"});
  dive.say(kNoSource, Health{Health::Level::note, "a note is no event"});
  const History h = history_of(dive);
  ASSERT_EQ(h.tracks.size(), 3U);
  EXPECT_EQ(track(h, 0)->points.size(), 300U);
  EXPECT_EQ(track(h, 0)->body, Body::vehicle);
  EXPECT_NEAR(track(h, 0)->points[0].drms_m, 0.6, 1e-6);
  EXPECT_EQ(track(h, kShipTrack)->name, "ship");
  EXPECT_EQ(track(h, kShipTrack)->body, Body::ship);
  for (const Track& t : h.tracks)
    for (std::size_t i = 1; i < t.points.size(); ++i) ASSERT_LE(t.points[i - 1].valid, t.points[i].valid);
  ASSERT_EQ(h.modes.size(), 1U);
  EXPECT_EQ(h.modes[0].mode, Mode::B);
  ASSERT_EQ(h.events.size(), 2U);
  EXPECT_EQ(h.events[0].kind, EventMark::Kind::caution);
  EXPECT_EQ(h.events[1].kind, EventMark::Kind::event);
  EXPECT_EQ(h.first, Time{kDiveNs});
  int used = 0, refused = 0, unused = 0;
  for (const FixMark& fix : h.fixes) ++(!fix.accepted ? unused : *fix.accepted ? used : refused);
  EXPECT_EQ(used + refused, 8);
  EXPECT_EQ(refused, 3);
  EXPECT_EQ(unused, 4) << "the beacon's";
}

TEST(History, IsTheSameHoweverOftenItIsTaken) {
  Dive dive;
  dive.sail(0.0, 60.0);
  const History once = history_of(dive), often = history_of(dive, 7);
  ASSERT_EQ(once.tracks.size(), often.tracks.size());
  for (const Track& t : once.tracks) EXPECT_EQ(t.points, track(often, t.engine)->points);
  EXPECT_EQ(once.fixes, often.fixes);
  EXPECT_EQ(once.last, often.last);
  EXPECT_EQ(once.first, often.first);
}

TEST(History, ASilenceOfAllIsAGapAndOneBadStampIsNone) {
  Dive dive;
  dive.sail(0.0, 30.0);
  dive.solution(0, 1e5, 0.0);
  dive.messages.back().valid = Time{kDiveNs} + duration(1e7);  // a broken clock
  dive.sail(90.0, 120.0);
  const History h = history_of(dive);
  ASSERT_EQ(h.events.size(), 1U);
  EXPECT_EQ(h.events[0].kind, EventMark::Kind::gap);
  EXPECT_EQ(h.events[0].text, "nothing heard for 60 s");
  EXPECT_NEAR(seconds(h.events[0].until - Time{kDiveNs}), 90.0, 0.1);
  EXPECT_EQ(track(h, 0)->points.size(), 301U) << "the track goes on behind it";
  EXPECT_LT(track(h, 0)->points.back().valid, Time{kDiveNs} + duration(120.0));
}

TEST(History, FixesThatAreNotUsedAreThinnedToOneASecond) {
  Dive dive;
  for (int i = 0; i < 100; ++i) {
    dive.go_to(i * 0.1);
    dive.say(test::kGps, FixVerdict{.engine = 0, .position = test::near_busan(0, 0)});
  }
  EXPECT_EQ(history_of(dive).fixes.size(), 10U);
}

TEST(History, ThatNobodyTakesStaysBoundedAndKeepsItsShape) {
  HistoryBuilder builder(dive_setup(), 1000);
  Dive dive;
  for (int i = 0; i < 100'000; ++i) {
    dive.messages.clear();
    dive.go_to(i * 0.1);
    dive.solution(0, i, 0.0);
    dive.say(kNoSource, Alarm{Alarm::Priority::alarm, "x", "y"});
    for (const Envelope& e : dive.messages) builder.take(e);
  }
  const History h = builder.take_new();
  const auto& points = track(h, 0)->points;
  EXPECT_LE(points.size(), 1000U);
  EXPECT_GE(points.size(), 300U);
  EXPECT_LT(seconds(points.front().valid - Time{kDiveNs}), 1.0);
  EXPECT_GT(seconds(points.back().valid - Time{kDiveNs}), 9'900.0);
  EXPECT_LE(h.events.size(), 2001U);
}

}  // namespace
}  // namespace leadline::ui
