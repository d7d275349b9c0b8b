#include "ui/models/freshness.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace leadline::ui {
namespace {

ValueState at(double age_s, double period_s) { return freshness(duration(age_s), period_s); }

TEST(Freshness, OfAFastSourceFollowsTheFixedLimits) {
  EXPECT_EQ(at(0.0, 0.1), ValueState::live);
  EXPECT_EQ(at(1.0, 0.1), ValueState::live);
  EXPECT_EQ(at(1.01, 0.1), ValueState::ageing);
  EXPECT_EQ(at(3.0, 0.1), ValueState::ageing);
  EXPECT_EQ(at(3.01, 0.1), ValueState::stale);
  EXPECT_EQ(at(60.0, 0.1), ValueState::stale);
  EXPECT_EQ(at(60.01, 0.1), ValueState::lost);
}

TEST(Freshness, OfASlowSourceFollowsItsPeriod) {
  EXPECT_EQ(at(16.0, 8.0), ValueState::live);
  EXPECT_EQ(at(16.01, 8.0), ValueState::ageing);
  EXPECT_EQ(at(40.01, 8.0), ValueState::stale);
  EXPECT_EQ(at(160.0, 8.0), ValueState::stale);
  EXPECT_EQ(at(160.01, 8.0), ValueState::lost);
  EXPECT_EQ(at(2.0, 0.0), ValueState::ageing) << "a period that is not known yet";
  EXPECT_EQ(at(-5.0, 1.0), ValueState::live) << "a device a little ahead";
}

TEST(Freshness, TheWorseWinsInTheOrderOfTheLook) {
  const ValueState order[] = {ValueState::live,     ValueState::ageing, ValueState::pending,
                              ValueState::disagree, ValueState::alert,  ValueState::stale,
                              ValueState::lost};
  for (int i = 0; i < 7; ++i)
    for (int k = 0; k < 7; ++k) EXPECT_EQ(worse(order[i], order[k]), order[std::max(i, k)]);
}

TEST(Freshness, TheCircleOfAStaleSymbolGrowsWithSpeedAndAge) {
  EXPECT_DOUBLE_EQ(grown_sigma_m(0.6, 1.4, duration(10.0)), 15.6);
  EXPECT_DOUBLE_EQ(grown_sigma_m(0.6, 0.0, duration(10.0)), 1.6);
  EXPECT_DOUBLE_EQ(grown_sigma_m(0.6, 1.4, duration(-1.0)), 0.6);
}

}  // namespace
}  // namespace leadline::ui
