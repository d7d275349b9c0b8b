#include "core/nav/filters/windowed_covariance.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>
#include <limits>

#include "tests/unit/core/nav/filtered_survey.h"

namespace leadline::nav {
namespace {

using Eigen::Matrix2d;
using Eigen::Vector2d;
using test::ErrorFigures;
using test::Pcg;
using test::SimulatedSurvey;

constexpr double kGamma_m = SimulatedSurvey::kGamma_m;
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

TEST(WindowedCi, CovarianceStaysSymmetricAndPositiveWhateverTheFixes) {
  Pcg random(1);
  WindowedCi filter(kGamma_m);
  for (int i = 0; i < 5000; ++i) {
    filter.predict(random.normal2(), random.uniform(1e-3, 20.0));
    const double reach = std::exp(random.uniform(-3.0, 5.0));
    filter.fix(reach * random.normal2(), 8.0 * i, std::exp(random.uniform(-1.0, 3.0)));
    EXPECT_EQ(filter.P()(0, 1), filter.P()(1, 0));
    ASSERT_GT(Eigen::SelfAdjointEigenSolver<Matrix2d>(filter.P()).eigenvalues()(0), 0.0) << i;
  }
}

TEST(WindowedCi, WhatIsNotFiniteAndTimeThatStandsStillLeaveNoTrace) {
  WindowedCi filter(kGamma_m);
  filter.predict({0.5, 0.0}, 8.0);
  filter.fix({1.0, 1.0}, 8.0, kGamma_m);
  const Matrix2d P = filter.P();
  for (const double dt : {0.0, -1.0, kNaN, std::numeric_limits<double>::infinity()})
    EXPECT_FALSE(filter.predict({0.5, 0.0}, dt));
  EXPECT_FALSE(filter.predict({kNaN, 0.0}, 1.0));
  EXPECT_FALSE(filter.fix({kNaN, 0.0}, 9.0, kGamma_m).accepted);
  EXPECT_FALSE(filter.fix({0.0, 0.0}, kNaN, kGamma_m).accepted);
  for (const double gamma : {0.0, -1.0, kNaN}) EXPECT_FALSE(filter.fix({0.0, 0.0}, 9.0, gamma).accepted);
  EXPECT_EQ(filter.P(), P);
  EXPECT_EQ(filter.drift().since_s, 0.0);
}

TEST(WindowedCi, FixesOfOneInstantAreNoRunInTime) {
  WindowedCi filter(kGamma_m);
  for (int i = 0; i < 30; ++i) EXPECT_TRUE(filter.fix({0.1, -0.1}, 5.0, kGamma_m).accepted);
  EXPECT_TRUE(filter.P().allFinite());
}

TEST(WindowedCiOnASurvey, IsLessThanHalfAsFarOffAsPlainIntersectionAndHonestAboutIt) {
  ErrorFigures errors;
  double nees = 0.0;
  FixCount fixes;
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    FilteredSurvey<WindowedCi> run(seed, WindowedCi(kGamma_m));
    run.until(600.0);
    while (run.survey.t_s() < 5400.0) {
      fixes.add(run.survey, run.step());
      errors.add(run.error_m());
      nees += run.nees();
    }
  }
  nees /= static_cast<double>(errors.count);
  std::printf("RMS %.3f m, NEES %.2f, good refused %.2f %%, outliers accepted %.2f %%\n", errors.rms(), nees,
              100.0 * fixes.good_refused(), 100.0 * fixes.outliers_accepted());
  EXPECT_LE(errors.rms(), 1.4);
  EXPECT_GE(nees, 0.3);
  EXPECT_LE(nees, 4.0);
  EXPECT_LE(fixes.good_refused(), 0.005);
  EXPECT_LE(fixes.outliers_accepted(), 0.02);
}

TEST(WindowedCiOnASurvey, RecoversFromFortyMinutesWithoutFixes) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const FilteredSurvey<WindowedCi> start(seed, WindowedCi(kGamma_m));
    EXPECT_LE(recovery_s(start, seed), 180.0) << seed;
  }
}

TEST(WindowedCiOnASurvey, TenFalseFixesAt80MetresDoNotCaptureIt) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed)
    EXPECT_LT(largest_error_under_false_fixes_m(FilteredSurvey<WindowedCi>(seed, WindowedCi(kGamma_m)), seed),
              8.0);
}

}  // namespace
}  // namespace leadline::nav
