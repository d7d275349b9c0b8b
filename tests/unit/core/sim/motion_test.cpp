#include "core/sim/truth/motion.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "core/geo/geodesy.h"
#include "tests/unit/core/sim/simulated.h"

namespace leadline::sim {
namespace {

constexpr double kStep = 0.01;

Route rough_route() {
  Route route;
  auto& b = route.body;
  b.depth_m = 20, b.speed_mps = 1, b.max_speed_mps = 3, b.repeat = 0;
  b.speed_variation = 0.1, b.weave_deg = 4, b.roll_mean_deg = 2, b.roll_deg = 5, b.pitch_deg = 4;
  b.heave_m = 0.3, b.sway_mps = 0.1;
  route.legs = {{.heading_deg = 30.0, .duration_s = 20.0, .speed_mps = 1.5, .depth_m = 25.0},
                {.heading_deg = 250.0, .duration_s = 20.0, .speed_mps = 0.7, .depth_m = 18.0}};
  return route;
}
Water rough_water() {
  return Water({.current_mps = 0.3,
                .current_towards_deg = 100,
                .tide_mps = 0.2,
                .tide_period_s = 600,
                .shear_mps_per_m = 0.01,
                .shear_towards_deg = 200});
}
const Geodetic kOrigin{Angle::deg(59.0), Angle::deg(5.0)};

// Everything a sample says is the derivative of what another says: differences within one step, where the
// motion is analytic.
TEST(Motion, VelocityAccelerationAndTurnRateAreExactDerivatives) {
  Motion motion(rough_route(), rough_water(), kOrigin, kStep);
  constexpr double kH = 1e-3;
  double worst_v = 0, worst_a = 0, worst_w = 0, worst_alpha = 0;
  for (int i = 0; i < 4000; ++i, motion.step()) {
    const double t = motion.from_s() + 0.5 * kStep;
    const Truth a = motion.at(t - kH), m = motion.at(t), b = motion.at(t + kH);
    const auto moved = geo::difference(a.position, b.position, -m.depth_m);
    const Eigen::Vector3d v(moved.north_m, moved.east_m, b.depth_m - a.depth_m);
    worst_v = std::max(worst_v, (v / (2 * kH) - m.v_n).norm());
    worst_a = std::max(worst_a, ((b.v_n - a.v_n) / (2 * kH) - m.a_n).norm());
    const Eigen::AngleAxisd turned(a.C_nb.transpose() * b.C_nb);
    worst_w = std::max(worst_w, (turned.angle() * turned.axis() / (2 * kH) - m.w_nb_b).norm());
    worst_alpha = std::max(worst_alpha, ((b.w_nb_b - a.w_nb_b) / (2 * kH) - m.alpha_nb_b).norm());
  }
  std::cout << "  worst differences: v " << worst_v << " m/s, a " << worst_a << " m/s2, w " << worst_w
            << " rad/s, alpha " << worst_alpha << " rad/s2\n";
  EXPECT_LT(worst_v, 3e-6);  // a double's longitude resolves 1e-9 m, over 2 ms
  EXPECT_LT(worst_a, 3e-6);
  EXPECT_LT(worst_w, 3e-6);
  EXPECT_LT(worst_alpha, 3e-6);
}

TEST(Motion, IsContinuousFromStepToStep) {
  Motion motion(rough_route(), rough_water(), kOrigin, kStep);
  for (int i = 0; i < 3000; ++i) {
    const Truth before = motion.at(motion.to_s());
    motion.step();
    const Truth after = motion.at(motion.from_s());
    const auto moved = geo::difference(before.position, after.position);
    ASSERT_LT(std::hypot(moved.north_m, moved.east_m), 1e-8);
    ASSERT_LT((before.v_n - after.v_n).norm(), 1e-9);
    ASSERT_LT((before.w_nb_b - after.w_nb_b).norm(), 1e-9);
    ASSERT_NEAR(before.depth_m, after.depth_m, 1e-9);
  }
}

TEST(Motion, SpeedRespondsInItsFirstOrderAndKeepsToItsAcceleration) {
  Route route;
  route.body.max_speed_mps = 10, route.body.speed_time_constant_s = 5, route.body.acceleration_mps2 = 10;
  route.legs = {{.duration_s = 100.0, .speed_mps = 2.0}};
  Motion motion(route, Water({}), kOrigin, kStep);
  while (motion.from_s() < 5.0 - 1e-9) motion.step();
  EXPECT_NEAR(motion.at(motion.from_s()).v_n.x(), 2.0 * (1.0 - std::exp(-1.0)), 1e-6);

  route.body.acceleration_mps2 = 0.04, route.body.speed_time_constant_s = 0.0;
  Motion ramp(route, Water({}), kOrigin, kStep);
  while (ramp.from_s() < 25.0 - 1e-9) ramp.step();
  EXPECT_NEAR(ramp.at(ramp.from_s()).v_n.x(), 1.0, 1e-9);
}

TEST(Motion, TurnsNoFasterThanItsRateAndSettlesOnTheCourse) {
  Route route;
  route.body.speed_mps = 1, route.body.turn_rate_dps = 6;
  route.legs = {{.heading_deg = 170.0, .duration_s = 100.0}};
  Motion motion(route, Water({}), kOrigin, kStep);
  double fastest = 0, farthest_deg = 0;
  while (motion.from_s() < 60.0) {
    motion.step();
    const Truth truth = motion.at(motion.from_s());
    fastest = std::max(fastest, std::abs(truth.w_nb_b.z()) * kDegPerRad);
    farthest_deg = std::max(farthest_deg, truth.attitude.heading.deg());
  }
  EXPECT_NEAR(fastest, 6.0, 1e-3);
  EXPECT_LE(farthest_deg, 170.02);
  EXPECT_NEAR(motion.at(motion.from_s()).attitude.heading.deg(), 170.0, 1e-3);
}

TEST(Motion, DivesToItsDepthWithoutGoingBeyond) {
  Route route;
  route.body.max_vertical_mps = 0.5;
  route.legs = {{.duration_s = 200.0, .depth_m = 30.0}};
  Motion motion(route, Water({}), kOrigin, kStep);
  double deepest = 0, fastest = 0;
  while (motion.from_s() < 150.0) {
    motion.step();
    const Truth truth = motion.at(motion.from_s());
    deepest = std::max(deepest, truth.depth_m), fastest = std::max(fastest, truth.v_n.z());
  }
  EXPECT_NEAR(deepest, 30.0, 0.02);
  EXPECT_NEAR(fastest, 0.5, 1e-3);
}

TEST(Motion, ReachesItsWaypointsAcrossACurrent) {
  Route route;
  route.body.speed_mps = 1;
  route.legs = {{.north_m = 200.0, .east_m = 50.0, .speed_mps = 1.0}, {.north_m = 0.0, .east_m = 0.0}};
  Motion motion(route, Water({.current_mps = 0.5, .current_towards_deg = 90}), kOrigin, kStep);
  double nearest_m = 1e9, off_track_m = 0;
  while (motion.from_s() < 250.0) {
    motion.step();
    const auto here = geo::difference(kOrigin, motion.at(motion.from_s()).position);
    const double to_go = std::hypot(here.north_m - 200, here.east_m - 50);
    nearest_m = std::min(nearest_m, to_go);
    if (motion.from_s() < 150)
      off_track_m = std::max(off_track_m, std::abs(here.east_m - here.north_m / 4) * 0.97);
  }
  EXPECT_LE(nearest_m, 2.0);
  EXPECT_LT(off_track_m, 15.0);  // it crabs: only the first turn carries it off
}

TEST(Motion, LegsGoByTheDistanceRunAndRepeat) {
  Route route;
  route.body.speed_mps = 1, route.body.repeat = 2, route.body.turn_rate_dps = 6;
  route.legs = {{.heading_deg = 0.0, .distance_m = 100.0, .speed_mps = 1.0},
                {.heading_deg = 180.0, .distance_m = 100.0}};
  Motion motion(route, Water({}), kOrigin, kStep);
  double farthest = -1e9;
  while (motion.from_s() < 190.0) {
    motion.step();
    farthest = std::max(farthest, geo::difference(kOrigin, motion.at(motion.from_s()).position).north_m);
  }
  EXPECT_NEAR(farthest, 100.0 + 1.0 / (6.0 * kRadPerDeg), 2.0);  // plus the radius of the turn
  while (motion.from_s() < 395.0) motion.step();
  EXPECT_NEAR(motion.at(motion.from_s()).v_n.norm(), 1.0, 1e-9);
  while (motion.from_s() < 430.0) motion.step();
  EXPECT_NEAR(motion.at(motion.from_s()).v_n.norm(), 0.0, 1e-5) << "after two rounds it stops";
}

TEST(Water, ShearAndTideAreWhatTheKeysSay) {
  const Water water = rough_water();
  const auto c = water.current(150.0, 10.0);  // a quarter of the tide's period: full flood
  EXPECT_NEAR(c.x(), 0.3 * std::cos(100 * kRadPerDeg) + 0.2 + 0.1 * std::cos(200 * kRadPerDeg), 1e-12);
  EXPECT_NEAR(c.y(), 0.3 * std::sin(100 * kRadPerDeg) + 0.1 * std::sin(200 * kRadPerDeg), 1e-12);
}

// The survey covers what a lawn-mower does: 5.3 km in 3 h over 450 m and some 630 m.
TEST(Motion, TheDeepSurveyIsTheOneOfThePaper) {
  Scenario scenario = shipped("deep-survey");
  Motion motion(*scenario.vehicle, Water(scenario.water), scenario.origin(), scenario.options.step_s);
  double run_m = 0, north = 0, east = 0, fastest_dps = 0;
  Truth last = motion.at(0);
  while (motion.from_s() < 10800.0) {
    for (int i = 0; i < 20; ++i) motion.step();
    const Truth truth = motion.at(motion.from_s());
    run_m += truth.v_n.head<2>().norm();
    fastest_dps = std::max(fastest_dps, std::abs(truth.w_nb_b.z()) * kDegPerRad);
    const auto here = geo::difference(scenario.origin(), truth.position);
    north = std::max(north, here.north_m), east = std::max(east, here.east_m);
    last = truth;
  }
  EXPECT_NEAR(run_m, 5420.0, 60.0);
  EXPECT_NEAR(north, 450.0, 15.0);
  EXPECT_NEAR(east, 630.0, 40.0);
  EXPECT_LT(fastest_dps, 6.5);
  EXPECT_DOUBLE_EQ(last.depth_m, 1500.0);
}

}  // namespace
}  // namespace leadline::sim
