#include "core/sim/random.h"

#include <gtest/gtest.h>

#include <cmath>

namespace leadline::sim {
namespace {

TEST(Random, GivesTheSameNumbersForTheSameSeedAndName) {
  Random a(7, "dvl"), b(7, "dvl");
  for (int i = 0; i < 100; ++i) ASSERT_EQ(a.next(), b.next());
}

TEST(Random, StreamsOfOtherNamesAndSeedsAreUncorrelated) {
  Random a(7, "dvl"), b(7, "ahrs"), c(8, "dvl");
  double ab = 0, ac = 0;
  constexpr int kCount = 20000;
  for (int i = 0; i < kCount; ++i) {
    const double x = a.normal();
    ab += x * b.normal() / kCount, ac += x * c.normal() / kCount;
  }
  EXPECT_LT(std::abs(ab), 4.0 / std::sqrt(kCount));
  EXPECT_LT(std::abs(ac), 4.0 / std::sqrt(kCount));
}

TEST(Random, NormalHasItsMomentsAndTails) {
  Random random(1, "normal");
  double mean = 0, square = 0, fourth = 0;
  int beyond = 0;
  constexpr int kCount = 400000;
  for (int i = 0; i < kCount; ++i) {
    const double x = random.normal();
    mean += x / kCount, square += x * x / kCount, fourth += x * x * x * x / kCount;
    beyond += std::abs(x) > 2.0;
  }
  EXPECT_NEAR(mean, 0.0, 0.006);
  EXPECT_NEAR(square, 1.0, 0.01);
  EXPECT_NEAR(fourth, 3.0, 0.08);
  EXPECT_NEAR(beyond / double{kCount}, 0.0455, 0.0012);
}

TEST(GaussMarkov, KeepsItsSigmaAndForgetsWithItsTimeConstant) {
  Random random(3, "wander");
  GaussMarkov process(2.0, 50.0, random);
  std::vector<double> x;
  for (int i = 0; i < 400000; ++i) x.push_back(process.advance(1.0, random));
  double c0 = 0, c50 = 0;
  for (std::size_t i = 0; i + 50 < x.size(); ++i) c0 += x[i] * x[i], c50 += x[i] * x[i + 50];
  EXPECT_NEAR(std::sqrt(c0 / static_cast<double>(x.size() - 50)), 2.0, 0.06);
  EXPECT_NEAR(c50 / c0, std::exp(-1.0), 0.04);
}

TEST(GaussMarkov, WithoutATimeConstantIsAConstant) {
  Random random(3, "wander");
  GaussMarkov process(2.0, 0.0, random);
  const double first = process.value();
  EXPECT_EQ(process.advance(1000.0, random), first);
}

}  // namespace
}  // namespace leadline::sim
