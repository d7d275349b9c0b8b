#include "core/nav/filters/heading_bias_filter.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>
#include <limits>

#include "tests/unit/core/nav/simulated_survey.h"

namespace leadline::nav {
namespace {

using Eigen::Vector2d;
using test::Pcg;
using F = HeadingBiasFilter;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kHeadingSd = 0.5 * kRadPerDeg, kRateSd = 0.05 * kRadPerDeg;

/// Kang 2017's run on the surface: 0.3 m/s, compass and rate and GNSS at 10 Hz, DVL at 3.3 Hz.
struct SurfaceRun {
  SurfaceRun(std::uint64_t seed, double course_deg, double bias_deg, const F::Settings& settings = {})
      : random(seed),
        course(course_deg * kRadPerDeg),
        bias(bias_deg * kRadPerDeg),
        filter(settings),
        lever(settings.lever_m) {}

  void step(bool gnss) {
    ++steps;
    const double t = steps * 0.1;
    course += 0.1 * turn_rps;
    const double speed = still ? 0.0 : std::min(0.3, 0.2 * t);
    const double weave = still ? 0.0 : 3.0 * kRadPerDeg * std::sin(2.0 * kPi * t / 20.0);
    const double rate =
        still ? 0.0 : 3.0 * kRadPerDeg * 2.0 * kPi / 20.0 * std::cos(2.0 * kPi * t / 20.0) + turn_rps;
    const double psi = course + weave;
    truth += 0.1 * speed * Vector2d(std::cos(psi), std::sin(psi));
    travelled += 0.1 * speed;
    const double measured = Angle::rad(psi - bias + kHeadingSd * random.normal()).wrapped_pi().rad();
    const Vector2d arm(std::cos(psi) * lever.x() - std::sin(psi) * lever.y(),
                       std::sin(psi) * lever.x() + std::cos(psi) * lever.y());
    const double kept = correlated_s > 0.0 ? std::exp(-0.1 / correlated_s) : 0.0;
    gnss_error = kept * gnss_error + 0.3 * std::sqrt(1.0 - kept * kept) * random.normal2();
    const Vector2d fix = truth + arm + gnss_error;
    if (!filter.started()) filter.start(fix, measured, 0.0);
    EXPECT_TRUE(filter.predict(0.1));
    filter.heading(measured, kHeadingSd);
    filter.rate(rate + kRateSd * random.normal(), kRateSd);
    if (steps % 3 == 0) {
      const Vector2d uv = Vector2d(speed, 0.0) + 0.002 * random.normal2();
      filter.velocity(uv, {F::velocity_sd_mps(uv.x()), F::velocity_sd_mps(uv.y())});
    }
    if (gnss) filter.position(fix - filter.antenna(), 0.3);
    psi_true = psi;
  }
  void run(int n, bool gnss) {
    for (int i = 0; i < n; ++i) step(gnss);
  }
  [[nodiscard]] double bias_error_deg() const {
    return Angle::rad(filter.x()(F::b) - bias).wrapped_pi().deg();
  }
  [[nodiscard]] double error_m() const { return (filter.x().head<2>() - truth).norm(); }

  Pcg random;
  double course, bias;
  F filter;
  Vector2d lever;
  bool still = false;
  double turn_rps = 0.0, correlated_s = 0.0, travelled = 0.0, psi_true = 0.0;
  int steps = 0;
  Vector2d truth = Vector2d::Zero(), gnss_error = Vector2d::Zero();
};

TEST(HeadingBiasFilter, FindsTheBiasInAMinuteOnAnyCourse) {
  for (const double course_deg : {0.0, 178.0, -120.0}) {
    double worst_deg = 0.0, worst_m = 0.0;
    for (std::uint64_t seed = 1; seed <= 24; ++seed) {
      SurfaceRun run(seed, course_deg, -5.0);
      run.run(600, true);
      worst_deg = std::max(worst_deg, std::abs(run.bias_error_deg()));
      worst_m = std::max(worst_m, run.error_m());
    }
    std::printf("course %.0f: worst bias error %.2f deg, end error %.3f m\n", course_deg, worst_deg, worst_m);
    EXPECT_LE(worst_deg, 0.6);
    EXPECT_LE(worst_m, 0.08);
  }
}

TEST(HeadingBiasFilter, GnssErrorsThatLastHalfAMinuteStayInTheWiderBand) {
  constexpr int kRuns = 100;
  double squares_deg2 = 0.0, squares_m2 = 0.0;
  int within_deg = 0, within_m = 0;
  for (std::uint64_t seed = 1; seed <= kRuns; ++seed) {
    SurfaceRun run(seed, 0.0, -5.0);
    run.correlated_s = 30.0;
    run.run(600, true);
    squares_deg2 += run.bias_error_deg() * run.bias_error_deg();
    squares_m2 += run.error_m() * run.error_m();
    within_deg += std::abs(run.bias_error_deg()) <= 3.5;
    within_m += run.error_m() <= 0.9;
  }
  const double rms_deg = std::sqrt(squares_deg2 / kRuns), rms_m = std::sqrt(squares_m2 / kRuns);
  std::printf("bias error rms %.2f deg, %d of %d within 3.5 deg; end error rms %.2f m, %d within 0.9 m\n",
              rms_deg, within_deg, kRuns, rms_m, within_m);
  EXPECT_LE(rms_deg, 1.5);
  EXPECT_LE(rms_m, 0.40);
  // The bands are two and a half to three times the rms, which is the error of the GNSS itself.
  EXPECT_GE(within_deg, 98);
  EXPECT_GE(within_m, 98);
}

TEST(HeadingBiasFilter, AMinuteOfGnssServesADiveOfHalfAnHour) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    SurfaceRun run(seed, 0.0, -5.0);
    run.run(600, true);
    run.run(17400, false);
    EXPECT_LE(run.error_m(), 3.0) << seed;
    const double uncorrected_m = 2.0 * run.travelled * std::sin(2.5 * kRadPerDeg);
    EXPECT_GE(uncorrected_m / run.error_m(), 15.0) << seed;
  }
}

TEST(HeadingBiasFilter, StandingStillTheBiasStaysWhereItWasAndItsSigmaWide) {
  SurfaceRun run(3, 40.0, 5.0);
  run.still = true;
  run.correlated_s = 30.0;
  run.run(3000, true);
  EXPECT_LT(std::abs(run.filter.x()(F::b)) / kRadPerDeg, 1.0);
  EXPECT_GT(std::sqrt(run.filter.P()(F::b, F::b)) / kRadPerDeg, 5.0);
}

TEST(HeadingBiasFilter, ALeverArmThatIsKnownDoesNoHarm) {
  double worst_deg = 0.0;
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    SurfaceRun run(seed, 0.0, -5.0, {.lever_m = {0.5, 0.2}});
    run.run(300, true);
    run.turn_rps = 6.0 * kRadPerDeg;
    run.run(200, true);
    run.turn_rps = 0.0;
    run.run(300, true);
    worst_deg = std::max(worst_deg, std::abs(run.bias_error_deg()));
  }
  std::printf("worst bias error %.2f deg\n", worst_deg);
  EXPECT_LE(worst_deg, 1.0);
}

TEST(HeadingBiasFilter, AWildPositionIsRefused) {
  SurfaceRun run(1, 0.0, -5.0);
  run.run(300, true);
  const F::State before = run.filter.x();
  EXPECT_FALSE(run.filter.position({10.0, 0.0}, 0.3));
  EXPECT_EQ(run.filter.x(), before);
}

TEST(HeadingBiasFilter, CovarianceStaysSymmetricAndPositive) {
  Pcg random(2);
  F filter({.lever_m = {1.0, -0.5}, .position_gate = false});
  filter.start({0.0, 0.0}, 3.0, 0.0);
  for (int i = 0; i < 5000; ++i) {
    filter.predict(random.uniform(1e-3, 5.0));
    switch (random.next() % 4) {
      case 0:
        filter.heading(random.uniform(-7.0, 7.0), kHeadingSd);
        break;
      case 1:
        filter.rate(0.1 * random.normal(), kRateSd);
        break;
      case 2:
        filter.velocity(2.0 * random.normal2(), {0.003, 0.02});
        break;
      default:
        filter.position(30.0 * random.normal2(), std::exp(random.uniform(-3.0, 3.0)));
        break;
    }
    ASSERT_EQ(filter.P(), filter.P().transpose());
    ASSERT_GT(Eigen::SelfAdjointEigenSolver<F::Covariance>(filter.P()).eigenvalues()(0), 0.0) << i;
    ASSERT_LE(std::abs(filter.x()(F::psi)), kPi + 1e-12);
    ASSERT_LE(std::abs(filter.x()(F::b)), kPi + 1e-12);
  }
}

TEST(HeadingBiasFilter, WhatIsNotFiniteAndTimeThatStandsStillLeaveNoTrace) {
  F filter({});
  EXPECT_FALSE(filter.predict(0.1)) << "not started";
  EXPECT_FALSE(filter.heading(1.0, kHeadingSd));
  filter.start({0.0, 0.0}, 1.0, 0.0);
  filter.velocity({1.0, 0.0}, {0.003, 0.003});
  const F::State x = filter.x();
  const F::Covariance P = filter.P();
  for (const double dt : {0.0, -0.1, kNaN, std::numeric_limits<double>::infinity()})
    EXPECT_FALSE(filter.predict(dt));
  EXPECT_FALSE(filter.heading(kNaN, kHeadingSd));
  EXPECT_FALSE(filter.rate(kNaN, kRateSd));
  EXPECT_FALSE(filter.velocity({kNaN, 0.0}, {0.003, 0.003}));
  EXPECT_FALSE(filter.position({0.0, kNaN}, 0.3));
  for (const double sd : {0.0, -1.0, kNaN}) {
    EXPECT_FALSE(filter.heading(1.0, sd));
    EXPECT_FALSE(filter.rate(0.0, sd));
    EXPECT_FALSE(filter.velocity({1.0, 0.0}, {0.003, sd}));
    EXPECT_FALSE(filter.position({0.0, 0.0}, sd));
  }
  EXPECT_EQ(filter.x(), x);
  EXPECT_EQ(filter.P(), P);
}

}  // namespace
}  // namespace leadline::nav
