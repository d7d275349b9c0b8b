#include "core/nav/filters/covariance_intersection.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>

#include "tests/unit/core/nav/simulated_survey.h"

namespace leadline::nav {
namespace {

using Eigen::Matrix2d;
using Eigen::Vector2d;
using test::ErrorFigures;
using test::Pcg;
using test::SimulatedSurvey;

constexpr double kGamma_m = SimulatedSurvey::kGamma_m;

Matrix2d isotropic(double variance) { return variance * Matrix2d::Identity(); }

Matrix2d random_covariance(Pcg& random) {
  Matrix2d A;
  A << random.normal2(), random.normal2();
  return A * A.transpose() + isotropic(0.01);
}

double smallest(const Matrix2d& P) { return Eigen::SelfAdjointEigenSolver<Matrix2d>(P).eigenvalues()(0); }

TEST(CovarianceIntersection, BetterSourceGetsTheGreaterWeight) {
  const Fused fused = ci(Vector2d::Zero(), isotropic(1.0), Vector2d(10.0, 0.0), isotropic(25.0));
  EXPECT_NEAR(fused.w1, 25.0 / 26.0, 1e-15);
  EXPECT_NEAR(fused.P(0, 0), 1.0383, 5e-5);
  EXPECT_NEAR(fused.x.x(), 10.0 * 1.0 / 626.0, 1e-12);
}

TEST(CovarianceIntersection, IsotropicInputsFollowTheClosedForm) {
  Pcg random(1);
  for (int i = 0; i < 200; ++i) {
    const double a = std::exp(random.uniform(-5.0, 5.0)), b = std::exp(random.uniform(-5.0, 5.0));
    const Vector2d x1 = random.normal2(), x2 = random.normal2();
    const Fused fused = ci(x1, isotropic(a), x2, isotropic(b));
    const double P = a * b * (a + b) / (a * a + b * b);
    const double gain = a * a / (a * a + b * b);
    EXPECT_NEAR(fused.P(0, 0) / P, 1.0, 1e-12);
    EXPECT_NEAR(fused.P(1, 1) / P, 1.0, 1e-12);
    EXPECT_NEAR(fused.P(0, 1), 0.0, 1e-12 * P);
    EXPECT_LT((fused.x - (x1 + gain * (x2 - x1))).norm(), 1e-12);
  }
}

TEST(CovarianceIntersection, IsSymmetricPositiveAndNeverBetterThanTheBetterInput) {
  Pcg random(2);
  for (int i = 0; i < 2000; ++i) {
    const Matrix2d P1 = random_covariance(random), P2 = random_covariance(random);
    const Vector2d x1 = random.normal2(), x2 = random.normal2();
    const Fused fused = ci(x1, P1, x2, P2);
    EXPECT_EQ(fused.P(0, 1), fused.P(1, 0));
    EXPECT_GT(smallest(fused.P), 0.0);
    EXPECT_GE(smallest(fused.P) * (1.0 + 1e-9), std::min(smallest(P1), smallest(P2)));
    EXPECT_GT(fused.w1, 0.0);
    EXPECT_LT(fused.w1, 1.0);

    const Fused swapped = ci(x2, P2, x1, P1);
    EXPECT_LT((swapped.x - fused.x).norm(), 1e-9);
    EXPECT_LT((swapped.P - fused.P).norm(), 1e-9 * fused.P.norm());
  }
}

TEST(CovarianceIntersection, AnEstimateFusedWithItselfGainsNothing) {
  Pcg random(3);
  const Matrix2d P = random_covariance(random);
  const Fused fused = ci(Vector2d(1.0, 2.0), P, Vector2d(1.0, 2.0), P);
  EXPECT_LT((fused.P - P).norm(), 1e-12);
  EXPECT_LT((fused.x - Vector2d(1.0, 2.0)).norm(), 1e-12);
}

TEST(PlainCi, GateGrowsWithTheWayAndTheTimeSinceTheLastAcceptedFix) {
  PlainCi filter(kGamma_m);
  EXPECT_DOUBLE_EQ(filter.fix({0.0, 14.999}, 0.0, kGamma_m).gate_m, 15.0);
  filter.predict({0.3, 0.4}, 1000.0);
  const FixResult refused = filter.fix({100.0, 0.0}, 1000.0, kGamma_m);
  EXPECT_FALSE(refused.accepted);
  EXPECT_EQ(refused.step, Vector2d::Zero());
  EXPECT_NEAR(refused.gate_m, 3.0 * std::hypot(5.0, 0.01 * 500.0 + 0.002 * 1000.0), 1e-12);

  const FixResult accepted = filter.fix({refused.gate_m - 1e-6, 0.0}, 1000.0, kGamma_m);
  EXPECT_TRUE(accepted.accepted);
  EXPECT_DOUBLE_EQ(filter.fix({0.0, 0.0}, 1000.0, kGamma_m).gate_m, 15.0);
}

TEST(PlainCi, ADeclaredSigmaBeyondTheDriftWidensGateAndCovariance) {
  PlainCi filter(5.0), declared(5.0);
  EXPECT_NEAR(declared.fix({0.0, 0.0}, 1.0, 5.0, 12.0).gate_m, 3.0 * 13.0, 1e-12);
  filter.fix({0.0, 0.0}, 1.0, 5.0, 0.0);
  EXPECT_GT(declared.P()(0, 0), filter.P()(0, 0));
}

TEST(PlainCi, GateFollowsEachFixesOwnSigma) {
  PlainCi filter(kGamma_m);
  EXPECT_FALSE(filter.fix({4.0, 0.0}, 0.0, 1.0).accepted);
  EXPECT_TRUE(filter.fix({4.0, 0.0}, 0.0, 2.0).accepted);
}

TEST(PlainCi, CovarianceWidensByTheDriftOnlyAfterTwoMinutesWithoutAFix) {
  for (const double gap_s : {119.0, 121.0}) {
    PlainCi filter(kGamma_m);
    filter.predict({0.5, 0.0}, gap_s);
    double a = 12.5 + 0.01 * 0.01 * gap_s;
    if (gap_s > 120.0) a += std::pow(0.01 * 0.5 * gap_s + 0.002 * gap_s, 2) / 2.0;
    filter.fix({1.0, 0.0}, gap_s, kGamma_m);
    EXPECT_NEAR(filter.P()(0, 0), a * 12.5 * (a + 12.5) / (a * a + 12.5 * 12.5), 1e-12) << gap_s;
  }
}

TEST(PlainCi, StepsAddUpToTheCorrectionAndAResetForgetsAll) {
  PlainCi filter(kGamma_m);
  Vector2d sum = Vector2d::Zero();
  for (int i = 0; i < 10; ++i) sum += filter.fix({3.0, -1.0}, i, kGamma_m).step;
  EXPECT_LT((filter.correction() - sum).norm(), 1e-12);
  EXPECT_GT(sum.norm(), 10.0);

  for (int i = 0; i < 4; ++i) filter.fix({30.0, 0.0}, 10 + i, kGamma_m);
  filter.predict({1.0, 0.0}, 10.0);
  filter.reset(isotropic(4.0));
  EXPECT_EQ(filter.correction(), Vector2d::Zero());
  EXPECT_EQ(filter.P(), isotropic(4.0));
  EXPECT_EQ(filter.drift().since_s, 0.0);
  EXPECT_EQ(filter.drift().distance_m, 0.0);
  EXPECT_FALSE(filter.fix({30.0, 0.0}, 20.0, kGamma_m).accepted) << "the four before the reset are forgotten";
}

/// Fixes 8 s apart with the vehicle at rest, so that the gate and the believable jump stay small.
class Reacquisition : public ::testing::Test {
 protected:
  /// `e`: where the fix is, seen from where dead reckoning alone would be.
  FixResult fix_at(const Vector2d& e) {
    filter_.predict({0.0, 0.0}, 8.0);
    t_s_ += 8.0;
    return filter_.fix(e - filter_.correction(), t_s_, kGamma_m);
  }
  PlainCi filter_{kGamma_m};
  double t_s_ = 0.0;
};

TEST_F(Reacquisition, FiveThatAgreeAtABelievableDistanceMoveThePosition) {
  fix_at({1.0, 0.0});
  for (int i = 0; i < 4; ++i) EXPECT_FALSE(fix_at({16.0 + 0.1 * i, 1.0}).accepted);
  const FixResult fifth = fix_at({16.4, 1.0});
  EXPECT_TRUE(fifth.accepted);
  EXPECT_TRUE(fifth.reacquired);
  EXPECT_EQ(fifth.agreeing, 5);
  EXPECT_DOUBLE_EQ(fifth.agreeing_over_s, 32.0);
  EXPECT_LT((filter_.correction() - Vector2d(16.2, 1.0)).norm(), 1e-12);
  EXPECT_NEAR(filter_.P()(0, 0), 12.5 / 5.0, 1e-12);
  EXPECT_EQ(filter_.drift().since_s, 0.0);
  EXPECT_FALSE(fix_at({16.2, 1.0}).reacquired);
}

TEST_F(Reacquisition, AJumpTooGreatToBelieveNeedsFifteen) {
  for (int i = 0; i < 14; ++i) EXPECT_FALSE(fix_at({80.0, 0.0}).accepted) << i;
  const FixResult fifteenth = fix_at({80.0, 0.0});
  EXPECT_TRUE(fifteenth.reacquired);
  EXPECT_EQ(fifteenth.agreeing, 15);
  EXPECT_NEAR(filter_.P()(1, 1), 12.5 / 15.0, 1e-12);
}

TEST_F(Reacquisition, ThreeStrayFixesDoNotSpoilFiveThatAgree) {
  for (const Vector2d& e :
       {Vector2d(16.0, 0.0), Vector2d(-90.0, 50.0), Vector2d(16.0, 0.0), Vector2d(60.0, -150.0),
        Vector2d(16.0, 0.0), Vector2d(0.0, 70.0), Vector2d(16.0, 0.0)})
    EXPECT_FALSE(fix_at(e).accepted);
  const FixResult eighth = fix_at({16.0, 0.0});
  EXPECT_TRUE(eighth.reacquired);
  EXPECT_EQ(eighth.agreeing, 5);
  EXPECT_LT((filter_.correction() - Vector2d(16.0, 0.0)).norm(), 1e-12);
}

TEST_F(Reacquisition, TheNewestTwoMustBeAmongThoseThatAgree) {
  for (int i = 0; i < 4; ++i) fix_at({16.0, 0.0});
  EXPECT_FALSE(fix_at({-40.0, 0.0}).accepted);
  EXPECT_FALSE(fix_at({16.0, 0.0}).accepted) << "five agree, but the last but one is astray";
  EXPECT_TRUE(fix_at({16.0, 0.0}).reacquired);
}

TEST_F(Reacquisition, AnAcceptedFixForgetsTheRejected) {
  for (int i = 0; i < 4; ++i) fix_at({17.0, 0.0});
  EXPECT_TRUE(fix_at({0.0, 0.0}).accepted);
  for (int i = 0; i < 4; ++i) EXPECT_FALSE(fix_at({17.0, 0.0}).accepted);
  EXPECT_TRUE(fix_at({17.0, 0.0}).reacquired);
}

TEST_F(Reacquisition, ScatteredFixesNeverAgree) {
  Pcg random(4);
  for (int i = 0; i < 500; ++i) {
    filter_.reset(isotropic(12.5));
    for (int k = 0; k < 18; ++k)
      EXPECT_FALSE(fix_at(random.uniform(100.0, 200.0) * random.direction()).accepted);
  }
}

/// The simulated vehicle, the filter, and the position a caller would keep.
struct FilteredRun {
  explicit FilteredRun(std::uint64_t seed) : survey(seed) {}

  std::optional<FixResult> step(bool with_fix = true, const Vector2d& false_fix = Vector2d::Zero()) {
    survey.step();
    filter.predict(survey.dvl_mps(), SimulatedSurvey::kStep_s);
    position += survey.dvl_mps() * SimulatedSurvey::kStep_s;
    if (!survey.fix() || !with_fix) return std::nullopt;
    const Vector2d z = false_fix.isZero() ? *survey.fix() : Vector2d(survey.truth() + false_fix);
    residual = z - position;
    const FixResult result = filter.fix(residual, survey.t_s(), kGamma_m);
    position += result.step;
    return result;
  }
  FixResult fix_at_truth() { return filter.fix(survey.truth() - position, survey.t_s(), kGamma_m); }
  void until(double t_s) {
    while (survey.t_s() < t_s) step();
  }
  [[nodiscard]] double error_m() const { return (position - survey.truth()).norm(); }

  SimulatedSurvey survey;
  PlainCi filter{kGamma_m};
  Vector2d position = Vector2d::Zero(), residual = Vector2d::Zero();
};

TEST(PlainCiOnASurvey, SettlesAtHalfGainAndGammaOverRootThree) {
  ErrorFigures errors;
  double gains = 0.0;
  long accepted = 0, good = 0, good_refused = 0, outliers = 0, outliers_accepted = 0;
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    FilteredRun run(seed);
    run.until(600.0);
    while (run.survey.t_s() < 5400.0) {
      const auto result = run.step();
      errors.add(run.error_m());
      if (!result) continue;
      (run.survey.fix_is_outlier() ? outliers : good) += 1;
      if (result->accepted) {
        gains += result->step.norm() / run.residual.norm();
        ++accepted;
        outliers_accepted += run.survey.fix_is_outlier();
      } else {
        good_refused += !run.survey.fix_is_outlier();
      }
    }
  }
  const double gain = gains / static_cast<double>(accepted);
  std::printf("RMS/gamma %.3f, gain %.3f, good refused %ld of %ld, outliers accepted %ld of %ld\n",
              errors.rms() / kGamma_m, gain, good_refused, good, outliers_accepted, outliers);
  EXPECT_NEAR(gain, 0.50, 0.03);
  EXPECT_GE(errors.rms() / kGamma_m, 0.54);
  EXPECT_LE(errors.rms() / kGamma_m, 0.62);
  EXPECT_LE(static_cast<double>(good_refused), 0.005 * static_cast<double>(good));
  EXPECT_LE(static_cast<double>(outliers_accepted), 0.02 * static_cast<double>(outliers));
}

TEST(PlainCiOnASurvey, RecoversFromFortyMinutesWithoutFixesAndADriftOf36Metres) {
  double slowest_s = 0.0;
  ErrorFigures after;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    FilteredRun run(seed);
    run.until(1200.0);
    run.survey.dvl_fault_mps = 36.0 / 2400.0 * Pcg(seed).direction();
    while (run.survey.t_s() < 3600.0) run.step(false);
    run.survey.dvl_fault_mps.setZero();
    EXPECT_GT(run.error_m(), 20.0) << "the outage must hurt";

    while (run.error_m() >= 6.0 && run.survey.t_s() < 3600.0 + 600.0) run.step();
    EXPECT_LE(run.survey.t_s(), 3600.0 + 180.0) << "seed " << seed;
    slowest_s = std::max(slowest_s, run.survey.t_s() - 3600.0);
    run.until(3600.0 + 180.0);
    while (run.survey.t_s() < 3600.0 + 1200.0) run.step(), after.add(run.error_m());
  }
  std::printf("below 6 m after at most %.0f s, RMS from then on %.2f m\n", slowest_s, after.rms());
  EXPECT_LT(after.rms(), 0.62 * kGamma_m);
}

TEST(PlainCiOnASurvey, TenFalseFixesAt80MetresDoNotCaptureIt) {
  double worst_m = 0.0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    FilteredRun run(seed);
    run.until(1800.0);
    const Vector2d false_fix = 80.0 * Pcg(seed + 100).direction();
    ErrorFigures errors;
    for (int fixes = 0; fixes < 10;) {
      const auto result = run.step(true, false_fix);
      errors.add(run.error_m());
      if (!result) continue;
      EXPECT_FALSE(result->accepted);
      ++fixes;
    }
    EXPECT_TRUE(run.fix_at_truth().accepted) << "seed " << seed << ": nor do they shut out the right ones";
    EXPECT_LT(errors.largest, 8.0) << "seed " << seed;
    worst_m = std::max(worst_m, errors.largest);
  }
  std::printf("largest error %.2f m\n", worst_m);
}

}  // namespace
}  // namespace leadline::nav
