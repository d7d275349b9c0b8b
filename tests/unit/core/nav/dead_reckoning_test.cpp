#include "core/nav/motion/dead_reckoning.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>

#include "core/geo/geodesy.h"

namespace leadline::nav {
namespace {

const Geodetic kStart{Angle::deg(59.0), Angle::deg(5.0)};
const Eigen::Matrix2d kP0 = Eigen::Matrix2d::Identity() * 4.0;

Time at(double s) { return from_unix(1'700'000'000.0 + s); }
DeadReckoning::Velocity moving(double north, double east, double noise = 0.0, double drift = 0.0) {
  return {.v_ne = {north, east}, .noise_mps = noise, .drift_mps = drift};
}

geo::NorthEast from_start(const DeadReckoning& track) { return geo::difference(kStart, track.position()); }

TEST(DeadReckoning, SumsVelocityTimesMeasuredInterval) {
  DeadReckoning track({});
  track.start(at(0), kStart, kP0);
  track.velocity(at(1.0), moving(1, 0));
  track.velocity(at(1.5), moving(0, 2));
  EXPECT_NEAR(from_start(track).north_m, 1.0, 1e-6);
  EXPECT_NEAR(from_start(track).east_m, 1.0, 1e-6);
}

TEST(DeadReckoning, TimeThatStandsOrGoesBackMovesNothing) {
  DeadReckoning track({});
  track.start(at(0), kStart, kP0);
  EXPECT_TRUE(track.velocity(at(1), moving(1, 0)));
  EXPECT_FALSE(track.velocity(at(1), moving(1, 0)));
  EXPECT_FALSE(track.velocity(at(0.5), moving(1, 0)));
  EXPECT_NEAR(from_start(track).north_m, 1.0, 1e-6);
}

TEST(DeadReckoning, StartsFromAFixOlderThanThePingBeforeIt) {
  DeadReckoning track({});
  track.velocity(at(0), moving(1, 0));
  track.velocity(at(1), moving(1, 0));
  track.start(at(0.25), kStart, kP0);  // the fix came late: the ping at 1 s already moved on
  EXPECT_NEAR(from_start(track).north_m, 0.75, 1e-6);
  EXPECT_EQ(track.time(), at(1));
}

TEST(DeadReckoning, SigmaIsTheFormulaOfNetDisplacement) {
  DeadReckoning track({.scale = 0.01, .angle_rad = 0.02});
  track.start(at(0), kStart, kP0);
  for (int i = 1; i <= 100; ++i) track.velocity(at(i), moving(1, 0, 0.1));
  const Eigen::Matrix2d P = track.covariance();
  EXPECT_NEAR(P(0, 0), 4.0 + 0.01 * 0.01 * 1e4 + 100 * 0.01, 1e-9);
  EXPECT_NEAR(P(1, 1), 4.0 + 0.02 * 0.02 * 1e4 + 100 * 0.01, 1e-9);
  // There and back again: the systematic part closes, the noise does not.
  for (int i = 101; i <= 200; ++i) track.velocity(at(i), moving(-1, 0, 0.1));
  EXPECT_NEAR(track.covariance()(0, 0), 4.0 + 200 * 0.01, 1e-9);
  track.fixed(kP0);
  EXPECT_TRUE(track.covariance().isApprox(kP0));
}

TEST(DeadReckoning, CovarianceIsSymmetricAndPositive) {
  DeadReckoning track({.scale = 0.01, .angle_rad = 0.3});
  track.start(at(0), kStart, kP0);
  for (int i = 1; i <= 5000; ++i) {
    track.velocity(at(0.2 * i), moving(std::sin(0.01 * i), std::cos(0.003 * i), 0.01, 0.001));
    const Eigen::Matrix2d P = track.covariance();
    ASSERT_EQ(P(0, 1), P(1, 0));
    ASSERT_GT(Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>(P).eigenvalues().minCoeff(), 0.0);
  }
}

TEST(DeadReckoning, AnUnknownCurrentGrowsWithTimeNotWithItsRoot) {
  DeadReckoning track({});
  track.start(at(0), kStart, kP0);
  for (int i = 1; i <= 100; ++i) track.velocity(at(i), moving(2, 0, 0.0, 0.5));
  EXPECT_NEAR(std::sqrt(track.covariance()(0, 0) - 4.0), 50.0, 1e-9);
}

TEST(DeadReckoning, AGapIsBridgedByTheMeanVelocityWithASigmaForIt) {
  DeadReckoning track({});
  track.start(at(0), kStart, kP0);
  for (int i = 1; i <= 10; ++i) track.velocity(at(i), moving(1, 0));
  const auto step = track.velocity(at(40), moving(3, 0));
  ASSERT_TRUE(step);
  EXPECT_TRUE(step->gap);
  EXPECT_NEAR(step->displacement.x(), 60.0, 1e-9);
  EXPECT_NEAR(std::sqrt(track.covariance()(0, 0) - 4.0), 45.0, 1e-6);  // half of the faster speed, 30 s long
}

TEST(DeadReckoning, ThePastIsOnTheTrackAndMovesWithACorrection) {
  DeadReckoning track({});
  track.start(at(0), kStart, kP0);
  for (int i = 1; i <= 20; ++i) track.velocity(at(i), moving(1, 0));
  track.shift({0, 7});
  const auto past = track.position_at(at(4.5));
  ASSERT_TRUE(past);
  EXPECT_NEAR(geo::difference(kStart, *past).north_m, 4.5, 1e-4);
  EXPECT_NEAR(geo::difference(kStart, *past).east_m, 7.0, 1e-4);
  const auto ahead = track.position_at(at(21.5));
  ASSERT_TRUE(ahead);
  EXPECT_NEAR(geo::difference(kStart, *ahead).north_m, 21.5, 1e-4);
  EXPECT_FALSE(track.position_at(at(-1)));
  EXPECT_FALSE(track.position_at(at(60)));
}

TEST(DeadReckoning, ALongTrackAlongAParallelStaysOnIt) {
  DeadReckoning track({});
  const Geodetic north{Angle::deg(70.0), Angle::deg(179.5)};
  track.start(at(0), north, kP0);
  for (int i = 1; i <= 20000; ++i) track.velocity(at(i), moving(0, 2));  // 40 km, over the date line
  EXPECT_NEAR(track.position().lat.deg(), 70.0, 1e-6);
  const double run = (track.position().lon - north.lon).wrapped_2pi().rad() *
                     geo::radii(north.lat).prime_vertical_m * std::cos(70.0 * kRadPerDeg);
  EXPECT_NEAR(run, 40000.0, 0.1);
}

}  // namespace
}  // namespace leadline::nav
