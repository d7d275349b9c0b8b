#include "ui/bridge/pulse.h"

#include <gtest/gtest.h>

namespace leadline::ui {
namespace {

Time at(double s) { return Time{1'790'000'000'000'000'000} + duration(s); }
Arrival heard(double s) { return {at(s).ns}; }

TEST(Pulse, IsUnknownUntilTwoIntervalsAreThere) {
  Pulse pulse;
  pulse.beat(at(0.0));
  pulse.beat(at(1.0));
  EXPECT_EQ(pulse.period_s(), 0.0);
  pulse.beat(at(2.0));
  EXPECT_NEAR(pulse.period_s(), 1.0, 1e-6);
  EXPECT_EQ(pulse.last(), at(2.0));
}

TEST(Pulse, NeitherALostSampleNorAGapNorBurstsChangeIt) {
  Pulse lossy, bursts;
  for (int i = 0; i < 40; ++i)
    if (i % 6 != 0) lossy.beat(at(0.2 * i));
  EXPECT_NEAR(lossy.period_s(), 0.2, 0.01);
  lossy.beat(at(7200.0));
  EXPECT_NEAR(lossy.period_s(), 0.2, 0.01);
  for (int i = 0; i < 20; ++i)
    for (int k = 0; k < 3; ++k) bursts.beat(at(i + 0.02 * k));
  EXPECT_NEAR(bursts.period_s(), 0.96, 0.01);
}

TEST(Pulse, ATimeThatGoesBackIsNoBeat) {
  Pulse pulse;
  for (double s : {0.0, 1.0, 2.0, 1.5, 2.0, 3.0}) pulse.beat(at(s));
  EXPECT_NEAR(pulse.period_s(), 1.0, 1e-6);
}

TEST(Believable, AClockMoreThanAMinuteOffIsReplacedByTheArrival) {
  EXPECT_EQ(believable(at(-3.0), heard(0.0)), at(-3.0));
  EXPECT_EQ(believable(at(60.0), heard(0.0)), at(60.0));
  EXPECT_EQ(believable(at(-60.1), heard(0.0)), at(0.0));
  EXPECT_EQ(believable(at(7200.0), heard(0.0)), at(0.0));
  EXPECT_EQ(believable(Time{INT64_MIN}, heard(0.0)), at(0.0));
  EXPECT_EQ(believable(Time{INT64_MAX}, heard(0.0)), at(0.0));
}

TEST(RecentCount, CountsFiveSecondsAndForgets) {
  RecentCount count;
  for (int i = 0; i < 200; ++i) count.add(heard(0.05 * i));
  EXPECT_NEAR(count.rate_hz(heard(9.95)), 20.0, 0.5);
  EXPECT_EQ(count.count(heard(30.0)), 0);
  EXPECT_EQ(count.rate_hz(heard(30.0)), 0.0);
  count.add(heard(30.0));
  EXPECT_EQ(count.count(heard(30.0)), 1);
  EXPECT_EQ(RecentCount().rate_hz(heard(1.0)), 0.0);
}

TEST(RecentCount, OfASourceThatHasJustBegunIsNotTooSmall) {
  RecentCount count;
  for (int i = 0; i <= 20; ++i) count.add(heard(0.1 * i));
  EXPECT_NEAR(count.rate_hz(heard(2.0)), 10.5, 0.1);
}

}  // namespace
}  // namespace leadline::ui
