#include "core/types/angle.h"

#include <gtest/gtest.h>

#include <cmath>

namespace leadline {
namespace {

TEST(Angle, ConvertsOnTheWayInAndOut) {
  EXPECT_DOUBLE_EQ(Angle::deg(180.0).rad(), kPi);
  EXPECT_DOUBLE_EQ(Angle::rad(kPi / 2).deg(), 90.0);
  EXPECT_DOUBLE_EQ((Angle::deg(350.0) + Angle::deg(20.0)).deg(), 370.0);
  EXPECT_DOUBLE_EQ((-Angle::deg(7.8) * 2.0).deg(), -15.6);
}

TEST(Angle, HeadingWrapsIntoZeroToBelow360) {
  EXPECT_NEAR(Angle::deg(-90.0).wrapped_2pi().deg(), 270.0, 1e-12);
  EXPECT_NEAR(Angle::deg(725.0).wrapped_2pi().deg(), 5.0, 1e-12);
  EXPECT_NEAR(Angle::deg(359.999999).wrapped_2pi().deg(), 359.999999, 1e-12);
}

TEST(Angle, HeadingNeverRoundsUpTo360) {
  for (const double r : {-1e-20, -1e-17, -1e-300, 2 * kPi, -2 * kPi, 4 * kPi}) {
    const double wrapped = Angle::rad(r).wrapped_2pi().rad();
    EXPECT_GE(wrapped, 0.0) << r;
    EXPECT_LT(wrapped, 2 * kPi) << r;
  }
  EXPECT_EQ(Angle::rad(-1e-20).wrapped_2pi().rad(), 0.0);
}

TEST(Angle, HeadingOfNorthIsNeverMinusZero) {
  EXPECT_FALSE(std::signbit(Angle::rad(-0.0).wrapped_2pi().rad()));
  EXPECT_FALSE(std::signbit(Angle::rad(-2 * kPi).wrapped_2pi().rad()));
}

TEST(Angle, DifferenceGoesTheShortWayRound) {
  EXPECT_NEAR((Angle::deg(1.0) - Angle::deg(359.0)).wrapped_pi().deg(), 2.0, 1e-12);
  EXPECT_NEAR((Angle::deg(359.0) - Angle::deg(1.0)).wrapped_pi().deg(), -2.0, 1e-12);
  EXPECT_EQ(Angle::rad(kPi).wrapped_pi().rad(), -kPi);
  EXPECT_EQ(Angle::rad(-kPi).wrapped_pi().rad(), -kPi);
  EXPECT_EQ(Angle::rad(0.0).wrapped_pi().rad(), 0.0);
}

TEST(Angle, WrappingKeepsTheDirection) {
  for (int i = -2000; i <= 2000; ++i) {
    const Angle a = Angle::deg(i * 0.7317);
    for (const Angle w : {a.wrapped_2pi(), a.wrapped_pi()}) {
      EXPECT_NEAR(sin(w), sin(a), 1e-13);
      EXPECT_NEAR(cos(w), cos(a), 1e-13);
    }
    EXPECT_GE(a.wrapped_pi().rad(), -kPi);
    EXPECT_LT(a.wrapped_pi().rad(), kPi);
  }
}

}  // namespace
}  // namespace leadline
