#include "ui/bridge/snapshot_builder.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/unit/ui/bridge/made_messages.h"

namespace leadline::ui {
namespace {

using test::Dive;
using test::dive_setup;
using test::kDiveNs;

Snapshot shown(const Dive& dive, const ConsoleSetup& setup = dive_setup()) {
  SnapshotBuilder builder(setup);
  for (const Envelope& e : dive.messages) builder.take(e);
  return builder.snapshot(Time{kDiveNs} + duration(dive.now_s()));
}

const SourceState& source(const Snapshot& s, SourceId id) { return s.sources.at(id); }

TEST(Snapshot, EachFigureNamesItsFeedWithAgeAndPeriod) {
  Dive dive;
  dive.sail(0.0, 120.0);
  const Snapshot s = shown(dive);
  ASSERT_TRUE(s.vehicle && s.ship);
  const BodyState& v = *s.vehicle;
  EXPECT_EQ(v.name, "MDV-1");
  EXPECT_EQ(v.engine, "fusion");
  EXPECT_NEAR(v.rate_hz, 5.0, 0.3);
  ASSERT_TRUE(v.position && v.heading && v.velocity && v.depth && v.attitude && v.altitude);
  EXPECT_EQ(v.position->source, "usbl + dvl");
  EXPECT_EQ(v.heading->source, "ahrs");
  EXPECT_NEAR(v.heading->period_s, 0.1, 0.001);
  EXPECT_EQ(v.velocity->source, "dvl");
  EXPECT_NEAR(v.velocity->period_s, 0.2, 0.001);
  EXPECT_EQ(v.depth->source, "press");
  EXPECT_NEAR(v.depth->period_s, 0.25, 0.001);
  EXPECT_EQ(v.attitude->source, "ahrs");
  EXPECT_EQ(v.altitude->above_bottom_m, 18.6);
  EXPECT_EQ(v.altitude->feed.source, "dvl");
  EXPECT_NEAR(seconds(s.now - v.heading->valid), 0.1 + 0.012, 0.01);
  EXPECT_EQ(s.ship->name, "HAEYANG 7");
  EXPECT_EQ(s.ship->engine, "ship");
  EXPECT_EQ(s.ship->position->source, "gnss");
  EXPECT_FALSE(s.ship->heading);
  ASSERT_EQ(s.others.size(), 1U);
  EXPECT_EQ(s.others[0].engine, "dead-reckoning");
  ASSERT_TRUE(s.beam);
  EXPECT_EQ(s.beam->feed.source, "usbl");
  EXPECT_NEAR(s.beam->feed.period_s, 8.0, 0.01);
  ASSERT_EQ(s.targets.size(), 1U);
  EXPECT_EQ(s.targets[0].name, "beacon");
  EXPECT_EQ(s.targets[0].depth, Depth{1520.0});
  EXPECT_NEAR(s.targets[0].var_north_m2 + s.targets[0].var_east_m2, 23.0 * 23.0, 1e-9);
}

TEST(Snapshot, SourcesHaveRateLatencyQualityAndTheLastEightFixes) {
  Dive dive;
  dive.sail(0.0, 120.0);
  dive.frame(test::kPress);
  dive.say(test::kPress, Rejected{"checksum", 5, 12});
  const Snapshot s = shown(dive);
  EXPECT_NEAR(source(s, test::kDvl).rate_hz, 5.0, 0.3);
  EXPECT_NEAR(source(s, test::kUsbl).rate_hz, 0.125, 0.001);
  EXPECT_NEAR(*source(s, test::kDvl).latency_s, 0.041, 1e-6);
  EXPECT_NEAR(*source(s, test::kUsbl).latency_s, 1.1, 1e-6);
  EXPECT_EQ(source(s, test::kDvl).beams, 4);
  EXPECT_EQ(source(s, test::kGps).satellites, 11);
  EXPECT_NEAR(*source(s, test::kCompass).sigma, 0.2, 1e-9);
  EXPECT_EQ(source(s, test::kCompass).sigma_unit, "°");
  EXPECT_EQ(source(s, test::kPress).refused, 1U);
  EXPECT_EQ(source(s, test::kPress).last_refusal, "checksum");
  EXPECT_EQ(source(s, test::kUsbl).fixes_judged, 8);
  EXPECT_EQ(source(s, test::kUsbl).fixes_refused, 3);
  EXPECT_EQ(source(s, test::kGps).fixes_judged, 0);
  EXPECT_EQ(source(s, test::kDvl).frames, 600U);
}

TEST(Snapshot, ASourceThatFallsSilentHandsOverAndTheChangeIsTold) {
  Dive dive;
  dive.sail(0.0, 60.0);
  dive.messages.erase(std::remove_if(dive.messages.begin(), dive.messages.end(),
                                     [](const Envelope& e) {
                                       return e.source == test::kCompass &&
                                              seconds(e.arrival - Arrival{kDiveNs}) > 50.0;
                                     }),
                      dive.messages.end());
  Snapshot s = shown(dive);
  EXPECT_EQ(s.vehicle->heading->source, "spare");
  EXPECT_EQ(s.vehicle->heading->was, "ahrs");
  EXPECT_NEAR(seconds(s.vehicle->heading->changed - Time{kDiveNs}), 53.5, 1.0);
  EXPECT_EQ(s.vehicle->attitude->source, "ahrs") << "nobody else gives it: it is shown, old";
  EXPECT_GT(seconds(s.now - s.vehicle->attitude->valid), 9.0);
  EXPECT_EQ(source(s, test::kCompass).rate_hz, 0.0);
  dive.go_to(75.0);
  EXPECT_EQ(shown(dive).vehicle->heading->was, "") << "after 10 s it is news no more";
}

TEST(Snapshot, TheModeSaysWhatThePositionIsMadeOf) {
  Dive dive;
  dive.sail(0.0, 60.0);
  dive.say(kNoSource, ModeChange{0, Mode::B, Mode::E1, "USBL lost: no fix for 40 s"});
  dive.say(kNoSource, ModeChange{1, Mode::B, Mode::E0, "of another engine"});
  dive.solution(0, 60.0, 80.0, Mode::E1);
  const Snapshot s = shown(dive);
  EXPECT_EQ(s.availability.mode, Mode::E1);
  EXPECT_EQ(s.availability.reason, "USBL lost: no fix for 40 s");
  EXPECT_EQ(s.availability.since, Time{kDiveNs} + duration(60.0));
  EXPECT_EQ(s.vehicle->position->source, "dvl");
  EXPECT_EQ(s.vehicle->position->was, "usbl + dvl");
}

TEST(Snapshot, WhereTheShipIsNavigatedThereIsNoVehicle) {
  ConsoleSetup setup = dive_setup();
  setup.navigated = Body::ship;
  for (auto& s : setup.sources) s.body = Body::ship;
  Dive dive;
  dive.sail(0.0, 30.0);
  const Snapshot s = shown(dive, setup);
  EXPECT_FALSE(s.vehicle);
  ASSERT_TRUE(s.ship);
  EXPECT_EQ(s.ship->engine, "fusion");
  EXPECT_EQ(s.ship->heading->source, "ahrs");
  ASSERT_EQ(s.others.size(), 2U);
  EXPECT_EQ(s.others[1].engine, "ship");
}

TEST(Snapshot, AlertsAreNewestFirstBoundedAndNotRepeated) {
  Dive dive;
  for (int i = 0; i < 200; ++i) {
    dive.go_to(i);
    dive.say(kNoSource, Alarm{Alarm::Priority::warning, "blocked", "engine " + std::to_string(i % 70)});
  }
  const Snapshot s = shown(dive);
  ASSERT_EQ(s.alerts.size(), SnapshotBuilder::kMostAlerts);
  EXPECT_EQ(s.alerts[0].text, "engine 59");
  EXPECT_EQ(s.alerts[0].raised, Time{kDiveNs} + duration(199.0));
  EXPECT_EQ(s.alerts[1].text, "engine 58");
}

TEST(Snapshot, AClockThatIsHoursOffDoesNotMakeLiveDataOld) {
  Dive dive;
  for (int i = 0; i < 50; ++i) {
    dive.go_to(i * 0.2);
    dive.heard(test::kDvl, DvlVelocity{DvlReference::bottom, DvlFrame::instrument, false, 1, 0, 0, true},
               7200.0);
    dive.say(kNoSource, Solution{.engine = 0, .position = test::near_busan(0, 0), .vel_north_mps = 1.0},
             7200.0);
  }
  const Snapshot s = shown(dive);
  EXPECT_LT(seconds(s.now - s.vehicle->valid), 1.0);
  EXPECT_LT(seconds(s.now - s.vehicle->velocity->valid), 1.0);
  EXPECT_NEAR(*source(s, test::kDvl).latency_s, 7200.0, 1e-6) << "but the latency says it";
}

TEST(Snapshot, ARunWithoutFramesCountsInstantsThatGaveFacts) {
  ConsoleSetup setup = dive_setup();
  setup.frames_kept = false;
  Dive dive;
  dive.sail(0.0, 60.0);
  const Snapshot s = shown(dive, setup);
  EXPECT_EQ(source(s, test::kDvl).frames, 300U) << "three facts a ping are one";
  EXPECT_NEAR(source(s, test::kDvl).rate_hz, 5.0, 0.3);
}

TEST(Snapshot, OfNothingHasTheSourcesAndNoPosition) {
  const Snapshot s = SnapshotBuilder(dive_setup()).snapshot();
  EXPECT_FALSE(s.vehicle || s.ship || s.beam);
  EXPECT_EQ(s.sources.size(), 7U);
  EXPECT_FALSE(s.sources[0].last);
  Dive dive;  // what no configuration knows of is passed over
  dive.heard(40, Heading{});
  dive.say(kNoSource, Solution{.engine = 9});
  EXPECT_FALSE(shown(dive).vehicle);
}

}  // namespace
}  // namespace leadline::ui
