#include "core/nav/availability/availability.h"

#include <gtest/gtest.h>

#include <optional>
#include <string>
#include <vector>

namespace leadline::nav {
namespace {

Time at(double s) { return from_unix(1.8e9) + duration(s); }

/// Regular sources on a 100 ms clock; each can be switched off. Keeps the reported changes.
struct Feed {
  double gnss_every_s = 1.0, usbl_every_s = 8.0, dvl_every_s = 0.2;
  bool gnss = false, usbl = false, dvl = false;
  bool gate_passed = true, lock = true;
  std::optional<double> above_bottom_m;

  Availability availability;
  std::vector<Availability::Change> changes;
  std::vector<double> change_s;
  long tick = 0;

  [[nodiscard]] double t_s() const { return static_cast<double>(tick) * 0.1; }
  [[nodiscard]] bool due(double every_s) const { return tick % std::lround(every_s * 10.0) == 0; }

  void run(double for_s) {
    for (const long end = tick + std::lround(for_s * 10.0); tick < end;) {
      ++tick;
      if (gnss && due(gnss_every_s)) availability.gnss_fix(at(t_s()));
      if (usbl && due(usbl_every_s)) availability.usbl_fix(at(t_s()), gate_passed);
      if (dvl && due(dvl_every_s)) availability.dvl_ping(at(t_s()), lock, above_bottom_m);
      if (const auto change = availability.evaluate(at(t_s()))) {
        changes.push_back(*change);
        change_s.push_back(t_s());
      }
    }
  }
  [[nodiscard]] Mode mode() const { return availability.mode(); }
  [[nodiscard]] std::string reason() const {
    return changes.empty() ? "" : std::string(changes.back().reason.view());
  }
};

Mode expected_mode(bool gnss, bool usbl, bool dvl) {
  if (gnss && dvl) return Mode::A;
  if (gnss) return Mode::C;
  if (usbl && dvl) return Mode::B;
  if (usbl) return Mode::D;
  return dvl ? Mode::E1 : Mode::E0;
}

TEST(Availability, EveryChangeOfOneInputLeadsWhereTheTableSays) {
  int reported = 0;
  for (int from = 0; from < 8; ++from) {
    for (const int toggled : {1, 2, 4}) {
      SCOPED_TRACE(::testing::Message() << "from " << from << ", toggled " << toggled);
      const auto mode_of = [](int inputs) { return expected_mode(inputs & 1, inputs & 2, inputs & 4); };
      const auto set = [](Feed& feed, int inputs) {
        feed.gnss = inputs & 1;
        feed.usbl = inputs & 2;
        feed.dvl = inputs & 4;
      };
      Feed feed;
      set(feed, from);
      feed.run(100.0);
      ASSERT_EQ(feed.mode(), mode_of(from));
      feed.changes.clear();
      const int to = from ^ toggled;
      set(feed, to);
      feed.run(100.0);
      EXPECT_EQ(feed.mode(), mode_of(to));
      EXPECT_EQ(feed.availability.gnss_ok(), (to & 1) != 0);
      EXPECT_EQ(feed.availability.usbl_ok(), (to & 2) != 0);
      EXPECT_EQ(feed.availability.dvl_ok(), (to & 4) != 0);
      if (mode_of(from) == mode_of(to)) {
        EXPECT_TRUE(feed.changes.empty()) << feed.reason();
        continue;
      }
      ASSERT_EQ(feed.changes.size(), 1U);
      EXPECT_EQ(feed.changes[0].from, mode_of(from));
      EXPECT_EQ(feed.changes[0].to, mode_of(to));
      EXPECT_FALSE(feed.changes[0].reason.empty());
      ++reported;
    }
  }
  EXPECT_EQ(reported, 20) << "24 toggles, 4 of them of USBL while GNSS wins";
}

TEST(Availability, StartsWithNothing) {
  Feed feed;
  feed.run(10.0);
  EXPECT_EQ(feed.mode(), Mode::E0);
  EXPECT_TRUE(feed.changes.empty());
}

TEST(Availability, GnssWinsAtTheSurfaceAndUsblTakesOverBelow) {
  Feed feed;
  feed.gnss = feed.usbl = feed.dvl = true;
  feed.run(60.0);
  EXPECT_EQ(feed.mode(), Mode::A);
  feed.availability.surfaced(false);
  feed.run(0.1);
  EXPECT_EQ(feed.mode(), Mode::B);
  EXPECT_EQ(feed.reason(), "GNSS lost: below the surface");
  feed.availability.surfaced(true);
  feed.run(1.0);
  EXPECT_EQ(feed.mode(), Mode::A);
  EXPECT_EQ(feed.reason(), "GNSS back");
}

TEST(Availability, GnssIsLostAfterThreeSecondsOrThreeMedianIntervals) {
  for (const double every_s : {0.2, 1.0, 1.3, 5.0, 10.4}) {
    Feed feed;
    feed.gnss = true;
    feed.gnss_every_s = every_s;
    feed.run(40.0 * every_s);
    ASSERT_EQ(feed.mode(), Mode::C) << every_s;
    feed.gnss = false;
    feed.run(60.0);
    EXPECT_EQ(feed.mode(), Mode::E0);
    EXPECT_NEAR(feed.change_s.back() - 40.0 * every_s, std::max(3.0, 3.0 * every_s), 0.01) << every_s;
  }
}

TEST(Availability, UsblIsDroppedAfterFivePeriodsNotBefore) {
  for (const double every_s : {1.3, 2.0, 8.0, 10.4}) {
    Feed feed;
    feed.usbl = true;
    feed.usbl_every_s = every_s;
    feed.run(40.0 * every_s);
    ASSERT_EQ(feed.mode(), Mode::D) << every_s;
    feed.usbl = false;
    feed.run(10.0 * every_s);
    EXPECT_EQ(feed.mode(), Mode::E0);
    EXPECT_NEAR(feed.change_s.back() - 40.0 * every_s, 5.0 * every_s + 0.1, 0.01) << every_s;
  }
}

TEST(Availability, AMissedFixOfAnEightSecondUsblIsNoLoss) {
  Feed feed;
  feed.usbl = feed.dvl = true;
  feed.run(200.0);
  feed.changes.clear();
  feed.usbl = false;
  feed.run(16.0);
  feed.usbl = true;
  feed.run(200.0);
  EXPECT_EQ(feed.mode(), Mode::B);
  EXPECT_TRUE(feed.changes.empty()) << feed.reason();
}

TEST(Availability, UsblIsGainedByAFixYoungerThanThreePeriodsOnly) {
  Availability availability;
  for (int i = 0; i <= 10; ++i) availability.usbl_fix(at(8.0 * i), false);
  EXPECT_EQ(availability.evaluate(at(80.0)), std::nullopt) << "none passed the gate";

  Availability late = availability;
  late.usbl_fix(at(88.0), true);
  late.tick(at(88.0 + 24.0));
  EXPECT_FALSE(late.usbl_ok());
  Availability early = availability;
  early.usbl_fix(at(88.0), true);
  early.tick(at(88.0 + 23.9));
  EXPECT_TRUE(early.usbl_ok());
  early.tick(at(88.0 + 40.0));
  EXPECT_TRUE(early.usbl_ok()) << "once gained it is kept for five";
  early.tick(at(88.0 + 40.1));
  EXPECT_FALSE(early.usbl_ok());
}

TEST(Availability, UsblHasTenSecondsBeforeItsPeriodIsKnown) {
  Availability availability;
  availability.usbl_fix(at(0.0), true);
  EXPECT_EQ(availability.evaluate(at(0.1))->to, Mode::D);
  EXPECT_FALSE(availability.evaluate(at(10.0)));
  const auto lost = availability.evaluate(at(10.1));
  ASSERT_TRUE(lost);
  EXPECT_EQ(lost->to, Mode::E0);
  EXPECT_EQ(lost->reason.view(), "USBL lost: no fix for 10 s");
}

TEST(Availability, FixesThatFailTheGateDoNotKeepUsblAliveButTellItsPeriod) {
  Feed feed;
  feed.usbl = true;
  feed.run(160.0);
  feed.gate_passed = false;
  feed.run(60.0);
  EXPECT_EQ(feed.mode(), Mode::E0);
  EXPECT_NEAR(feed.change_s.back(), 200.1, 0.01);
  EXPECT_EQ(feed.reason(), "USBL lost: no fix passed the gate for 40 s");
}

TEST(Availability, BottomLockNeedsThreeOfTheLastFivePings) {
  Availability availability;
  double t = 0.0;
  const auto ping = [&](bool lock) {
    t += 1.5;
    availability.dvl_ping(at(t), lock, std::nullopt);
    availability.tick(at(t));
    return availability.dvl_ok();
  };
  EXPECT_FALSE(ping(true));
  EXPECT_FALSE(ping(true));
  EXPECT_TRUE(ping(true)) << "three good ones are enough at the start";
  EXPECT_TRUE(ping(false));
  EXPECT_TRUE(ping(false));
  EXPECT_FALSE(ping(false)) << "2 of 5";
  EXPECT_FALSE(ping(true));
  EXPECT_FALSE(ping(true));
  EXPECT_TRUE(ping(true)) << "3 of 5";
}

TEST(Availability, BottomLockIsLostWithoutPingsForASecondOrThreeIntervals) {
  for (const double every_s : {0.2, 1.3, 3.5, 10.4}) {
    Feed feed;
    feed.dvl = true;
    feed.dvl_every_s = every_s;
    feed.run(40.0 * every_s);
    ASSERT_EQ(feed.mode(), Mode::E1) << every_s;
    feed.dvl = false;
    feed.run(60.0);
    EXPECT_EQ(feed.mode(), Mode::E0);
    EXPECT_NEAR(feed.change_s.back() - 40.0 * every_s, std::max(1.0, 3.0 * every_s) + 0.1, 0.01) << every_s;
  }
}

TEST(Availability, TheBottomMayBe110MetresBelowTheDvlWhenKnown) {
  Feed feed;
  feed.dvl = true;
  feed.above_bottom_m = 110.0;
  feed.run(5.0);
  EXPECT_EQ(feed.mode(), Mode::E1);
  feed.above_bottom_m = 133.2;
  feed.run(0.4);
  EXPECT_EQ(feed.mode(), Mode::E1) << "two pings are no proof";
  feed.run(0.2);
  EXPECT_EQ(feed.mode(), Mode::E0);
  EXPECT_EQ(feed.reason(), "bottom 134 m below the DVL, limit 110 m");
  feed.above_bottom_m.reset();
  feed.run(1.0);
  EXPECT_EQ(feed.mode(), Mode::E1);

  Availability deep(200.0);
  for (int i = 0; i < 3; ++i) deep.dvl_ping(at(i), true, 150.0);
  deep.tick(at(2.0));
  EXPECT_TRUE(deep.dvl_ok());
}

TEST(Availability, ReasonsAreInTheOperatorsWords) {
  Feed feed;
  feed.gnss = feed.usbl = feed.dvl = true;
  feed.gnss_every_s = 10.4;
  feed.run(10.4 * 20);
  ASSERT_EQ(feed.mode(), Mode::A);
  feed.gnss = false;
  feed.run(40.0);
  EXPECT_EQ(feed.mode(), Mode::B);
  EXPECT_EQ(feed.reason(), "GNSS lost: no fix for 31 s");

  feed.lock = false;
  feed.run(2.0);
  EXPECT_EQ(feed.mode(), Mode::D);
  EXPECT_EQ(feed.reason(), "bottom lock lost: 2 of the last 5 pings");
  feed.lock = true;
  feed.run(2.0);
  EXPECT_EQ(feed.reason(), "bottom lock back");
  feed.dvl = false;
  feed.run(2.0);
  EXPECT_EQ(feed.reason(), "bottom lock lost: no DVL ping for 1 s");
  feed.usbl = false;
  feed.run(60.0);
  EXPECT_EQ(feed.mode(), Mode::E0);
  EXPECT_EQ(feed.reason(), "USBL lost: no fix for 40 s");
  feed.usbl = true;
  feed.run(20.0);
  EXPECT_EQ(feed.mode(), Mode::D);
  EXPECT_EQ(feed.reason(), "USBL back");

  Feed fresh;
  fresh.usbl = true;
  fresh.run(10.0);
  EXPECT_EQ(fresh.reason(), "USBL acquired");
}

TEST(Availability, InputsThatChangeTogetherAreBothNamed) {
  Feed feed;
  feed.gnss = feed.dvl = true;
  feed.gnss_every_s = 0.2;
  feed.run(10.0);
  feed.gnss = feed.dvl = false;
  for (int i = 0; i < 5; ++i) feed.availability.dvl_ping(at(10.01 + 0.001 * i), false, std::nullopt);
  feed.availability.surfaced(false);
  feed.run(0.1);
  EXPECT_EQ(feed.reason(), "GNSS lost: below the surface; bottom lock lost: 0 of the last 5 pings");
}

TEST(Availability, TimeThatGoesBackIsIgnored) {
  Feed feed;
  feed.gnss = feed.usbl = feed.dvl = true;
  feed.run(100.0);
  feed.changes.clear();
  for (int i = 0; i < 100; ++i) {
    feed.availability.gnss_fix(at(50.0 + 0.01 * i));
    feed.availability.usbl_fix(at(50.0 + 0.01 * i), true);
    feed.availability.dvl_ping(at(50.0 + 0.01 * i), false, 500.0);
    EXPECT_FALSE(feed.availability.evaluate(at(40.0)));
  }
  feed.run(100.0);
  EXPECT_TRUE(feed.changes.empty()) << feed.reason();
  EXPECT_EQ(feed.mode(), Mode::A);
}

TEST(Intervals, MedianOfTheLastFifteenIsDeafToGapsAndBursts) {
  for (const double every_s : {1.3, 2.0, 5.5, 10.4}) {
    Intervals intervals;
    double t = 0.0;
    intervals.event(at(t));
    EXPECT_FALSE(intervals.median());
    for (int i = 0; i < 15; ++i) intervals.event(at(t += every_s));
    intervals.event(at(t += 2400.0));
    for (int i = 0; i < 4; ++i) intervals.event(at(t += 0.001));
    EXPECT_NEAR(seconds(*intervals.median()), every_s, 1e-6);
  }
}

TEST(Intervals, MedianFollowsANewRateAndAveragesTheMiddleTwo) {
  Intervals intervals;
  for (const double t : {0.0, 1.0, 4.0}) intervals.event(at(t));
  EXPECT_NEAR(seconds(*intervals.median()), 2.0, 1e-9);
  for (int i = 1; i <= 15; ++i) EXPECT_TRUE(intervals.event(at(4.0 + 10.4 * i)));
  EXPECT_NEAR(seconds(*intervals.median()), 10.4, 1e-6);
  EXPECT_FALSE(intervals.event(at(4.0 + 10.4 * 15)));
  EXPECT_FALSE(intervals.event(at(3.0)));
  EXPECT_EQ(intervals.last(), at(4.0 + 10.4 * 15));
}

}  // namespace
}  // namespace leadline::nav
