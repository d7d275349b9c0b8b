#include "ui/models/own_data.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/unit/ui/bridge/made_messages.h"
#include "ui/bridge/snapshot_builder.h"

namespace leadline::ui {
namespace {

using test::Dive;
using test::kDiveNs;

Snapshot shown(const Dive& dive, double now_s, ConsoleSetup setup = test::dive_setup()) {
  SnapshotBuilder builder(std::move(setup));
  for (const Envelope& e : dive.messages) builder.take(e);
  return builder.snapshot(Time{kDiveNs} + duration(now_s));
}

Dive sailed() {
  Dive dive;
  dive.sail(0.0, 120.0);
  return dive;
}

TEST(OwnData, OfTheVehicleReadsAsThePictureDoes) {
  const OwnDataText t = vehicle_text(shown(sailed(), 120.0));
  EXPECT_EQ(t.subject, "MDV-1");
  EXPECT_EQ(t.fact, "engine fusion   5.0 Hz");
  EXPECT_EQ(t.absent, "");
  ASSERT_TRUE(t.position && t.heading && t.speed && t.depth && t.altitude && t.roll && t.pitch && t.rose);
  EXPECT_EQ(t.position->value.substr(0, 6), "36°54");
  EXPECT_NE(t.position->value_2.find("′ E"), std::string::npos);
  EXPECT_EQ(t.position->sigma, "0.6 m");
  EXPECT_EQ(t.position->source, "usbl + dvl");
  EXPECT_EQ(t.heading->value, "071.9");
  EXPECT_EQ(t.heading->unit, "° T");
  EXPECT_EQ(t.heading->sigma, "0.3°");
  EXPECT_EQ(t.heading->source, "ahrs");
  EXPECT_EQ(t.speed->value, "1.42");
  EXPECT_EQ(t.speed->unit, "m/s");
  EXPECT_EQ(t.speed->sigma, "0.01");
  EXPECT_EQ(t.speed->note, "COG 074.9° T");
  EXPECT_EQ(t.depth->value, "1512.4");
  EXPECT_EQ(t.depth->sigma, "0.3");
  EXPECT_EQ(t.altitude->value, "18.6");
  EXPECT_EQ(t.roll->value, "+0.8");
  EXPECT_EQ(t.pitch->value, "\u22121.6");
  EXPECT_EQ(t.pitch->unit, "°");
  EXPECT_EQ(t.pitch->source, "");
  EXPECT_NEAR(*t.rose->heading_deg, 71.9, 1e-9);
  EXPECT_NEAR(*t.rose->course_deg, 74.9, 0.05);
  EXPECT_EQ(t.heading->state, ValueState::live);
  EXPECT_FALSE(t.current);
}

TEST(OwnData, OfTheShipHasNoFigureWithoutFeed) {
  const OwnDataText t = ship_text(shown(sailed(), 120.0));
  EXPECT_EQ(t.subject, "HAEYANG 7");
  EXPECT_TRUE(t.position);
  EXPECT_FALSE(t.heading || t.speed || t.depth || t.altitude || t.roll || t.rose);
}

TEST(OwnData, OfAShipWithAGyroAndALogIsInKnots) {
  ConsoleSetup setup = test::dive_setup();
  setup.navigated = Body::ship;
  for (auto& s : setup.sources) s.body = Body::ship;
  const Snapshot s = shown(sailed(), 120.0, setup);
  const OwnDataText t = ship_text(s);
  EXPECT_EQ(t.speed->value, "2.8");
  EXPECT_EQ(t.speed->unit, "kn");
  EXPECT_EQ(vehicle_text(s).absent, "no vehicle in this configuration");
}

TEST(OwnData, AFigureIsAsOldAsTheOlderOfItsParents) {
  Dive dive = sailed();
  for (int i = 0; i < 100; ++i) {  // the compass speaks on, the engine does not
    dive.go_to(120.0 + i * 0.1);
    dive.heard(test::kCompass, Heading{Angle::deg(80.0)});
  }
  OwnDataText t = vehicle_text(shown(dive, 130.0));
  EXPECT_EQ(t.heading->value, "071.9") << "the engine's";
  EXPECT_EQ(t.heading->state, ValueState::stale);
  EXPECT_EQ(t.heading->age, "10 s");
  EXPECT_EQ(t.rose->state, ValueState::stale);
  dive = sailed();
  for (int i = 0; i < 100; ++i) {  // the engine speaks on, the compasses do not
    dive.go_to(120.0 + i * 0.1);
    dive.solution(0, 0.0, 0.0);
  }
  t = vehicle_text(shown(dive, 130.0));
  EXPECT_EQ(t.heading->state, ValueState::stale);
  EXPECT_EQ(t.position->state, ValueState::live);
}

TEST(OwnData, WhatIsLostHasNoValueButSaysItsLast) {
  const OwnDataText t = vehicle_text(shown(sailed(), 300.0));
  EXPECT_EQ(t.depth->state, ValueState::lost);
  EXPECT_EQ(t.depth->value, "");
  EXPECT_EQ(t.depth->note.substr(0, 16), "last 1512.4 m at");
  EXPECT_EQ(t.heading->note.substr(0, 18), "last 071.9° T at ");
  EXPECT_EQ(t.position->value, "");
  EXPECT_EQ(t.position->value_2, "");
  EXPECT_NE(t.position->note.find("N 129°"), std::string::npos) << t.position->note;
  EXPECT_EQ(t.depth->age, "3:00");
}

TEST(OwnData, ANewSourceIsShownWithTheOneBefore) {
  Dive dive = sailed();
  for (int i = 0; i < 8; ++i) {
    dive.go_to(120.0 + i);
    dive.heard(test::kSpareCompass, Heading{Angle::deg(72.4)});
    dive.solution(0, 0.0, 0.0);
  }
  const OwnDataText t = vehicle_text(shown(dive, 127.0));
  EXPECT_EQ(t.heading->source, "spare");
  EXPECT_EQ(t.heading->was_source, "ahrs");
}

TEST(OwnData, SaysWhyThereIsNothing) {
  EXPECT_EQ(vehicle_text(shown({}, 0.0)).absent, "no position of the vehicle yet");
  EXPECT_EQ(sources_text(Snapshot{}).absent, "no sources in this configuration");
  EXPECT_EQ(ranges_text(Snapshot{}).absent, "nothing has a position yet");
}

TEST(Sources, RowsSayRateAgeLatencyAndQuality) {
  const SourcesText t = sources_text(shown(sailed(), 120.0));
  EXPECT_EQ(t.fact, "7 of 7 live");
  ASSERT_EQ(t.rows.size(), 7U);
  EXPECT_EQ(t.rows[test::kDvl].rate, "5.0 Hz");
  EXPECT_EQ(t.rows[test::kDvl].latency, "41 ms");
  EXPECT_EQ(t.rows[test::kDvl].quality, "4 beams");
  EXPECT_EQ(t.rows[test::kUsbl].rate, "0.125 Hz");
  EXPECT_EQ(t.rows[test::kUsbl].latency, "1.1 s");
  EXPECT_EQ(t.rows[test::kUsbl].quality, "3 of 8 refused");
  EXPECT_EQ(t.rows[test::kUsbl].alert, Alarm::Priority::warning);
  EXPECT_EQ(t.rows[test::kUsbl].state, ValueState::live) << "its period is 8 s";
  EXPECT_EQ(t.rows[test::kCompass].quality, "σ 0.2°");
  EXPECT_EQ(t.rows[test::kGps].quality, "σ 0.8 m");
  EXPECT_EQ(t.rows[test::kPress].tool_tip, "paroscientific · 480 frames");
}

TEST(Sources, ASilentOneIsLostAndNotCounted) {
  Dive dive;
  dive.spare = false;
  dive.sail(0.0, 60.0);
  dive.frame(test::kDvl);
  dive.say(test::kDvl, Rejected{"checksum", 0, 3});
  SourcesText t = sources_text(shown(dive, 60.0));
  EXPECT_EQ(t.fact, "6 of 7 live");
  EXPECT_EQ(t.rows[test::kSpareCompass].state, ValueState::lost);
  EXPECT_EQ(t.rows[test::kSpareCompass].age, "");
  EXPECT_EQ(t.rows[test::kSpareCompass].rate, "");
  EXPECT_NE(t.rows[test::kDvl].tool_tip.find("1 refused, last: checksum"), std::string::npos);
  ConsoleSetup setup = test::dive_setup();
  setup.replay = true;
  EXPECT_EQ(sources_text(shown(dive, 60.0, setup)).fact, "6 of 7 recorded");
}

TEST(Ranges, BetweenShipVehicleAndTarget) {
  Dive dive;
  dive.sail(0.0, 60.0);
  dive.solution(0, 0.0, 0.0);
  const RangesText t = ranges_text(shown(dive, 60.0));
  ASSERT_EQ(t.rows.size(), 3U);
  // The ship lies 340 m south and 250 m east of the vehicle.
  EXPECT_EQ(t.rows[0].from, "Ship");
  EXPECT_EQ(t.rows[0].to, "MDV-1");
  EXPECT_EQ(t.rows[0].horizontal, "422 m");
  EXPECT_EQ(t.rows[0].bearing, "323.7° T");
  EXPECT_EQ(t.rows[0].slant, "1570 m");
  EXPECT_EQ(t.rows[1].from, "MDV-1");
  EXPECT_EQ(t.rows[1].to, "beacon");
  EXPECT_EQ(t.rows[1].horizontal, "215 m");
  EXPECT_EQ(t.rows[1].bearing, "111.8° T");
  EXPECT_EQ(t.rows[1].slant, "215 m");
  EXPECT_EQ(t.rows[2].from, "Ship");
  EXPECT_EQ(t.rows[0].tool_tip.substr(0, 3), "σ ");
}

TEST(Ranges, AreAsOldAsTheOlderEnd) {
  Dive dive;
  dive.sail(0.0, 60.0);
  for (int i = 0; i < 50; ++i) {
    dive.go_to(60.0 + 0.2 * i);
    dive.solution(0, 0.0, 0.0);
  }
  EXPECT_EQ(ranges_text(shown(dive, 70.0)).rows[0].state, ValueState::stale) << "the ship fell silent";
  const RangeRow lost = ranges_text(shown(dive, 200.0)).rows[0];
  EXPECT_EQ(lost.state, ValueState::lost);
  EXPECT_EQ(lost.horizontal, "");
}

TEST(Bars, SayModeTimeAndThatNothingIsSentInReplay) {
  ConsoleSetup setup = test::dive_setup();
  setup.replay = true;
  Dive dive;
  dive.sail(0.0, 60.0);
  dive.say(kNoSource, ModeChange{0, Mode::B, Mode::E1, "USBL lost"});
  const TopBarText t = top_bar_text(shown(dive, 60.0, setup));
  EXPECT_EQ(t.operation, Operation::replay);
  EXPECT_EQ(t.dive, "Dive 07");
  EXPECT_EQ(t.file, "dive-07.leadline · read only");
  EXPECT_EQ(t.mode, Mode::E1);
  EXPECT_EQ(t.mode_words, "DVL only, σ grows");
  EXPECT_EQ(t.mode_since, "since " + time_text(Time{kDiveNs} + duration(60.0)));
  EXPECT_EQ(t.outputs, "Outputs off");
  EXPECT_EQ(t.time, time_text(Time{kDiveNs} + duration(60.0)));
  EXPECT_FALSE(top_bar_text(shown({}, 0.0)).mode);
}

TEST(Bars, TheHighestPriorityLeadsNewestFirst) {
  Dive dive;
  dive.say(kNoSource,
           Alarm{Alarm::Priority::warning, "a", "USBL: 3 of the last 8 fixes refused; gate 15.2 m"});
  dive.go_to(1.0);
  dive.say(test::kDvl, Alarm{Alarm::Priority::warning, "b", "second"});
  dive.go_to(2.0);
  dive.say(kNoSource, Alarm{Alarm::Priority::caution, "c", "newest"});
  AlertBarText t = alert_bar_text(shown(dive, 13.0));
  ASSERT_TRUE(t.alert);
  EXPECT_EQ(t.alert->text, "second");
  EXPECT_EQ(t.alert->cause, "dvl");
  EXPECT_EQ(t.counts, (std::array<int, 3>{0, 2, 1}));
  EXPECT_NE(t.alert->state.find(" · 12 s · unacknowledged"), std::string::npos) << t.alert->state;
  dive.say(kNoSource, Alarm{Alarm::Priority::emergency, "a", "man overboard; port side"});
  t = alert_bar_text(shown(dive, 13.0));
  EXPECT_EQ(t.alert->text, "man overboard");
  EXPECT_EQ(t.alert->cause, "port side");
  EXPECT_EQ(t.counts[0], 1);
  EXPECT_FALSE(alert_bar_text(Snapshot{}).alert);
}

}  // namespace
}  // namespace leadline::ui
