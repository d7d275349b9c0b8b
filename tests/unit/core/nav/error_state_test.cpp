#include "core/nav/filters/error_state.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>
#include <limits>

#include "tests/unit/core/nav/filtered_survey.h"

namespace leadline::nav {
namespace {

using Eigen::Vector2d;
using test::ErrorFigures;
using test::Pcg;
using test::SimulatedSurvey;
using Covariance = Eigen::Matrix<double, 6, 6>;

constexpr double kGamma_m = SimulatedSurvey::kGamma_m;
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
const ErrorState::Settings kPlain{.window_detector = false, .alpha_walk_deg_sqrt_h = 0.1};

TEST(ErrorState, CovarianceStaysSymmetricAndPositiveWhateverTheFixes) {
  for (const double fix_bias_m : {0.0, 3.0}) {
    Pcg random(1);
    ErrorState filter({.fix_bias_m = fix_bias_m});
    const int states = fix_bias_m > 0.0 ? 6 : 4;
    for (int i = 0; i < 5000; ++i) {
      filter.predict(filter.over_ground(random.normal2()), random.uniform(1e-3, 20.0));
      const double reach = std::exp(random.uniform(-3.0, 5.0));
      filter.fix(reach * random.normal2(), 8.0 * i, std::exp(random.uniform(-1.0, 3.0)));
      const Eigen::MatrixXd P = filter.P_all().topLeftCorner(states, states);
      ASSERT_EQ(P, P.transpose());
      ASSERT_GT(Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(P).eigenvalues()(0), 0.0) << i;
    }
  }
}

TEST(ErrorState, WhatIsNotFiniteAndTimeThatStandsStillLeaveNoTrace) {
  ErrorState filter({});
  filter.predict({0.5, 0.0}, 8.0);
  filter.fix({1.0, 1.0}, 8.0, kGamma_m);
  const Covariance P = filter.P_all();
  const double alpha = filter.alpha_rad();
  for (const double dt : {0.0, -1.0, kNaN, std::numeric_limits<double>::infinity()})
    EXPECT_FALSE(filter.predict({0.5, 0.0}, dt));
  EXPECT_FALSE(filter.predict({kNaN, 0.0}, 1.0));
  EXPECT_FALSE(filter.fix({kNaN, 0.0}, 9.0, kGamma_m).accepted);
  EXPECT_FALSE(filter.fix({0.0, 0.0}, kNaN, kGamma_m).accepted);
  for (const double gamma : {0.0, -1.0, kNaN}) EXPECT_FALSE(filter.fix({0.0, 0.0}, 9.0, gamma).accepted);
  EXPECT_EQ(filter.P_all(), P);
  EXPECT_EQ(filter.alpha_rad(), alpha);
}

TEST(ErrorState, ANewPositionKeepsMisalignmentAndScale) {
  ErrorState filter({});
  filter.align(0.1, 0.01, 0.003, 0.002);
  filter.reset(Eigen::Matrix2d::Identity());
  EXPECT_EQ(filter.alpha_rad(), 0.1);
  EXPECT_NEAR(filter.sd_alpha_rad(), 0.01, 1e-15);
  EXPECT_NEAR(filter.sd_s(), 0.002, 1e-15);
  const Vector2d v = filter.over_ground({1.0, 0.0});
  EXPECT_NEAR(v.x(), 0.997 * std::cos(0.1), 1e-15);
  EXPECT_NEAR(v.y(), 0.997 * std::sin(0.1), 1e-15);
}

TEST(ErrorState, CoastingSigmaGrowsAcrossTheTrackByTheMisalignmentsOwn) {
  ErrorState filter({.alpha_walk_deg_sqrt_h = 0.0});
  filter.reset(0.01 * Eigen::Matrix2d::Identity());
  for (int i = 0; i < 1000; ++i) filter.predict({1.0, 0.0}, 1.0);
  EXPECT_NEAR(std::sqrt(filter.P()(1, 1)), 1000.0 * 5.0 * kRadPerDeg, 0.1);
  EXPECT_NEAR(std::sqrt(filter.P()(0, 0)), 1000.0 * 0.01, 0.1);
}

struct SurveyFigures {
  ErrorFigures errors;
  double nees = 0.0;
  FixCount fixes;
};
SurveyFigures surveyed(const ErrorState::Settings& settings) {
  SurveyFigures figures;
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    FilteredSurvey<ErrorState> run(seed, ErrorState(settings));
    run.until(600.0);
    while (run.survey.t_s() < 5400.0) {
      figures.fixes.add(run.survey, run.step());
      figures.errors.add(run.error_m());
      figures.nees += run.nees();
    }
  }
  figures.nees /= static_cast<double>(figures.errors.count);
  return figures;
}

TEST(ErrorStateOnASurvey, IsLessThanHalfAsFarOffAsPlainIntersectionAndHonestAboutIt) {
  for (const auto& settings : {kPlain, ErrorState::Settings{}}) {
    const SurveyFigures figures = surveyed(settings);
    std::printf("%s: RMS %.3f m, NEES %.2f, good refused %.2f %%, outliers accepted %.2f %%\n",
                settings.window_detector ? "window" : "plain", figures.errors.rms(), figures.nees,
                100.0 * figures.fixes.good_refused(), 100.0 * figures.fixes.outliers_accepted());
    EXPECT_LE(figures.errors.rms(), 0.9);
    EXPECT_GE(figures.nees, 0.3);
    EXPECT_LE(figures.nees, 4.0);
    EXPECT_LE(figures.fixes.good_refused(), 0.005);
    EXPECT_LE(figures.fixes.outliers_accepted(), 0.02);
  }
}

TEST(ErrorStateOnASurvey, RecoversFromFortyMinutesWithoutFixes) {
  double slowest_s = 0.0;
  for (const auto& settings : {kPlain, ErrorState::Settings{}})
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
      const double took_s = recovery_s(FilteredSurvey<ErrorState>(seed, ErrorState(settings)), seed);
      EXPECT_LE(took_s, 180.0) << seed;
      slowest_s = std::max(slowest_s, took_s);
    }
  std::printf("below 6 m after at most %.0f s\n", slowest_s);
}

TEST(ErrorStateOnASurvey, TenFalseFixesAt80MetresDoNotCaptureIt) {
  for (const auto& settings : {kPlain, ErrorState::Settings{}})
    for (std::uint64_t seed = 1; seed <= 20; ++seed)
      EXPECT_LT(
          largest_error_under_false_fixes_m(FilteredSurvey<ErrorState>(seed, ErrorState(settings)), seed),
          8.0);
}

TEST(ErrorStateOnASurvey, WindowDetectorLimitsWhatAFaultOfTheDvlDoes) {
  ErrorFigures with, without;
  for (std::uint64_t seed = 1; seed <= 10; ++seed)
    for (const bool window : {false, true}) {
      FilteredSurvey<ErrorState> run(seed, ErrorState({.window_detector = window}));
      run.until(3600.0);
      run.survey.dvl_fault_mps = 0.1 * Pcg(seed).direction();
      while (run.survey.t_s() < 3900.0) run.step(), (window ? with : without).add(run.error_m());
      run.survey.dvl_fault_mps.setZero();
      while (run.survey.t_s() < 4800.0) run.step(), (window ? with : without).add(run.error_m());
    }
  std::printf("RMS %.1f m, max %.1f m with; %.1f m, %.1f m without\n", with.rms(), with.largest,
              without.rms(), without.largest);
  EXPECT_LT(with.rms(), without.rms());
  EXPECT_LT(with.largest, 15.0);
}

/// Fixes whose error lasts 300 s, 3 m RMS: on top of the survey's own.
TEST(ErrorState, ErrorsTheFixesHaveInCommonAreStatedOrCarried) {
  double carried_nees = 0.0, plain_nees = 0.0, stated_nees = 0.0, correlation = 0.0;
  long count = 0;
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    Pcg random(seed + 50);
    SimulatedSurvey survey(seed);
    survey.outlier_share = 0.0;
    ErrorState plain({}), carried({.fix_bias_m = 3.0});
    Vector2d plain_at = Vector2d::Zero(), carried_at = Vector2d::Zero(),
             common = 3.0 / std::sqrt(2.0) * random.normal2();
    while (survey.t_s() < 5400.0) {
      survey.step();
      const Vector2d v = plain.over_ground(survey.dvl_mps()), w = carried.over_ground(survey.dvl_mps());
      plain.predict(v, 0.2), carried.predict(w, 0.2);
      plain_at += 0.2 * v, carried_at += 0.2 * w;
      if (!survey.fix()) continue;
      const double kept = std::exp(-8.0 / 300.0);
      common = kept * common + 3.0 * std::sqrt((1.0 - kept * kept) / 2.0) * random.normal2();
      const Vector2d z = *survey.fix() + common;
      plain_at += plain.fix(z - plain_at, survey.t_s(), kGamma_m).step;
      carried_at += carried.fix(z - carried_at, survey.t_s(), kGamma_m).step;
      if (survey.t_s() < 1200.0) continue;
      const Vector2d error = plain_at - survey.truth(), other = carried_at - survey.truth();
      plain_nees += error.dot(plain.P().inverse() * error);
      stated_nees += error.dot(plain.stated_covariance().inverse() * error);
      carried_nees += other.dot(carried.P().inverse() * other);
      correlation += plain.innovation_correlation();
      ++count;
    }
  }
  const auto n = static_cast<double>(count);
  std::printf("NEES %.1f, as stated %.1f, with b carried %.1f; correlation %.2f\n", plain_nees / n,
              stated_nees / n, carried_nees / n, correlation / n);
  EXPECT_LT(carried_nees, 0.5 * plain_nees);
  EXPECT_LT(carried_nees / n, 4.0);
  EXPECT_LT(stated_nees, plain_nees);
}

}  // namespace
}  // namespace leadline::nav
