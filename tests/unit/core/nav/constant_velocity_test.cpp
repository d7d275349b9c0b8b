#include "core/nav/filters/constant_velocity.h"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <cmath>

#include "tests/unit/core/nav/simulated_survey.h"

namespace leadline::nav {
namespace {

using Eigen::Matrix2d;
using Eigen::Matrix4d;
using Eigen::Vector2d;
using test::ErrorFigures;
using test::Pcg;
using test::SimulatedSurvey;

constexpr double kGamma_m = 5.0;

Matrix2d isotropic(double variance) { return variance * Matrix2d::Identity(); }
Matrix2d R_of(double gamma_m) { return isotropic(gamma_m * gamma_m / 2.0); }

bool symmetric_positive(const Matrix4d& P) {
  return P == P.transpose() && Eigen::LLT<Matrix4d>(P).info() == Eigen::Success;
}

TEST(ConstantVelocity, PredictionMovesByTheVelocityAndGrowsAsWhiteAccelerationDoes) {
  ConstantVelocity filter(0.1);
  filter.reset(isotropic(4.0), {0.5, -0.2}, isotropic(0.25));
  EXPECT_LT((filter.predict(10.0) - Vector2d(5.0, -2.0)).norm(), 1e-12);
  const Matrix4d P = filter.P();
  EXPECT_NEAR(P(0, 0), 4.0 + 0.25 * 100.0 + 0.01 * 1000.0 / 3.0, 1e-9);
  EXPECT_NEAR(P(0, 2), 0.25 * 10.0 + 0.01 * 100.0 / 2.0, 1e-9);
  EXPECT_NEAR(P(3, 3), 0.25 + 0.01 * 10.0, 1e-12);
  EXPECT_NEAR(P(0, 1), 0.0, 1e-12);
}

TEST(ConstantVelocity, DiscretisationIsExactHoweverTheTimeIsCut) {
  ConstantVelocity whole, parts;
  Vector2d moved = Vector2d::Zero();
  const Vector2d moved_whole = whole.predict(8.0);
  for (int i = 0; i < 80; ++i) moved += parts.predict(0.1);
  EXPECT_LT((whole.P() - parts.P()).norm(), 1e-9 * whole.P().norm());
  EXPECT_LT((moved - moved_whole).norm(), 1e-12);
}

TEST(ConstantVelocity, OneFixMovesByTheKalmanGain) {
  ConstantVelocity filter;
  filter.reset(isotropic(3.0), Vector2d::Zero(), isotropic(1.0));
  const FixResult result = filter.fix({2.0, 0.0}, isotropic(1.0));
  EXPECT_TRUE(result.accepted);
  EXPECT_LT((result.step - Vector2d(1.5, 0.0)).norm(), 1e-12);
  EXPECT_NEAR(filter.P()(0, 0), 0.75, 1e-12);
  EXPECT_NEAR(result.gate_m, std::sqrt(13.8 * 4.0), 1e-12);
}

TEST(ConstantVelocity, GateIsGivenAlongTheResidual) {
  Matrix2d P;
  P << 96.0, 0.0, 0.0, 5.0;
  for (const double beyond : {-1e-6, 1e-6}) {
    for (const Vector2d& along : {Vector2d(1.0, 0.0), Vector2d(0.0, -1.0), Vector2d(0.6, 0.8)}) {
      ConstantVelocity filter;
      filter.reset(P, Vector2d::Zero(), isotropic(1.0));
      const double gate_m = ConstantVelocity(filter).fix(along, isotropic(4.0)).gate_m;
      EXPECT_EQ(filter.fix(along * (gate_m + beyond), isotropic(4.0)).accepted, beyond < 0.0) << along;
    }
  }
}

TEST(ConstantVelocity, CallersGateWins) {
  ConstantVelocity filter;
  filter.reset(isotropic(3.0), Vector2d::Zero(), isotropic(1.0));
  EXPECT_FALSE(ConstantVelocity(filter).fix({2.1, 0.0}, isotropic(1.0), 1.0).accepted);
  EXPECT_TRUE(ConstantVelocity(filter).fix({2.1, 0.0}, isotropic(1.0), 1.2).accepted);
}

TEST(ConstantVelocity, FindsTheVelocityOfAStraightRun) {
  ErrorFigures position_errors, velocity_errors;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    Pcg random(seed);
    ConstantVelocity filter;
    Vector2d position(40.0, -30.0);
    const Vector2d velocity(0.5, -0.3);
    for (int i = 1; i <= 450; ++i) {
      position += filter.predict(8.0);
      const Vector2d truth = velocity * (8.0 * i);
      position +=
          filter.fix(truth + kGamma_m / std::sqrt(2.0) * random.normal2() - position, R_of(kGamma_m)).step;
      if (i < 30) continue;
      position_errors.add((position - truth).norm());
      velocity_errors.add((filter.velocity() - velocity).norm());
    }
  }
  std::printf("straight run: RMS %.2f m, %.3f m/s\n", position_errors.rms(), velocity_errors.rms());
  EXPECT_LT(position_errors.rms(), 3.6);
  EXPECT_GT(position_errors.rms(), 2.0);
  EXPECT_LT(velocity_errors.rms(), 0.3);
}

ErrorFigures state_d(std::uint64_t seed, double outlier_share) {
  SimulatedSurvey survey(seed);
  survey.outlier_share = outlier_share;
  ConstantVelocity filter;
  Vector2d position = Vector2d::Zero();
  ErrorFigures errors;
  while (survey.t_s() < 5400.0) {
    survey.step();
    position += filter.predict(SimulatedSurvey::kStep_s);
    if (survey.fix()) position += filter.fix(*survey.fix() - position, R_of(kGamma_m)).step;
    if (survey.t_s() > 600.0) errors.add((position - survey.truth()).norm());
  }
  return errors;
}

TEST(ConstantVelocity, StateDOnALawnMowerStaysBetterThanTheRawFix) {
  for (const double outlier_share : {0.0, 0.0665}) {
    ErrorFigures all;
    for (std::uint64_t seed = 1; seed <= 8; ++seed) all.add(state_d(seed, outlier_share));
    std::printf("state D, %.2f %% outliers: RMS %.2f m, largest %.1f m\n", 100.0 * outlier_share, all.rms(),
                all.largest);
    EXPECT_GT(all.rms(), 2.5);
    EXPECT_LT(all.rms(), 4.6);
    EXPECT_LT(all.largest, outlier_share == 0.0 ? 25.0 : 60.0);
  }
}

TEST(ConstantVelocity, CovarianceStaysSymmetricAndPositiveOverRandomSteps) {
  Pcg random(7);
  ConstantVelocity filter;
  Vector2d position = Vector2d::Zero(), truth = Vector2d::Zero();
  int accepted = 0, reacquired = 0;
  for (int i = 0; i < 100000; ++i) {
    if (i % 200 == 0) truth = 1e5 * random.normal2();
    position += filter.predict(std::exp(random.uniform(-7.0, 4.0)));
    const double gamma_m = std::exp(random.uniform(-3.0, 4.0));
    const Vector2d z = truth + gamma_m / std::sqrt(2.0) * random.normal2();
    const FixResult result = filter.fix(z - position, R_of(gamma_m));
    position += result.step;
    accepted += result.accepted;
    reacquired += result.reacquired;
    ASSERT_TRUE(symmetric_positive(filter.P())) << i << "\n" << filter.P();
  }
  EXPECT_GT(accepted, 90000);
  EXPECT_GT(reacquired, 400);
}

/// A filter that knows a vehicle at 0.5 m/s north well.
struct Settled {
  Settled() {
    for (int i = 0; i < 60; ++i) step(truth_at_next());
  }
  Vector2d truth_at_next() const { return {0.5 * (t_s + 8.0), 0.0}; }
  FixResult step(const Vector2d& z) {
    t_s += 8.0;
    position += filter.predict(8.0);
    const FixResult result = filter.fix(z - position, R_of(kGamma_m));
    position += result.step;
    return result;
  }
  ConstantVelocity filter;
  Vector2d position = Vector2d::Zero();
  double t_s = 0.0;
};

TEST(ConstantVelocity, FiveRejectedFixesOnOneStraightRunStartItAnew) {
  Settled run;
  const Vector2d jump(0.0, 500.0), drift(0.0, 1.5);
  int steps = 0;
  FixResult result;
  const double t0_s = run.t_s;
  do {
    result = run.step(run.truth_at_next() + jump + drift * (run.t_s + 8.0 - t0_s));
    ++steps;
  } while (!result.accepted && steps < 20);
  EXPECT_EQ(steps, 5);
  EXPECT_TRUE(result.reacquired);
  EXPECT_EQ(result.agreeing, 5);
  EXPECT_DOUBLE_EQ(result.agreeing_over_s, 32.0);
  EXPECT_NEAR(run.position.y(), 500.0 + 1.5 * 40.0, 1.0);
  EXPECT_NEAR(run.filter.velocity().x(), 0.5, 0.05);
  EXPECT_NEAR(run.filter.velocity().y(), 1.5, 0.05);
  EXPECT_TRUE(symmetric_positive(run.filter.P()));
  EXPECT_TRUE(run.step(run.position + 8.0 * run.filter.velocity()).accepted);
}

TEST(ConstantVelocity, AStrayFixInTheStreakOnlyDelays) {
  Settled run;
  int steps = 0;
  FixResult result;
  do {
    ++steps;
    result = run.step(run.truth_at_next() + Vector2d(steps == 3 ? -900.0 : 400.0, 0.0));
  } while (!result.accepted && steps < 20);
  EXPECT_TRUE(result.reacquired);
  EXPECT_EQ(steps, 8);
  EXPECT_NEAR((run.position - Vector2d(0.5 * run.t_s + 400.0, 0.0)).norm(), 0.0, 2.0);
}

TEST(ConstantVelocity, ScatteredRejectedFixesDoNotStartItAnew) {
  Pcg random(8);
  int reacquired = 0;
  for (int i = 0; i < 1000; ++i) {
    ConstantVelocity filter;
    filter.reset(isotropic(4.0), Vector2d::Zero(), isotropic(0.01));
    for (int k = 0; k < 5; ++k) {
      static_cast<void>(filter.predict(1.0));
      reacquired += filter.fix(random.uniform(100.0, 300.0) * random.direction(), R_of(kGamma_m)).reacquired;
    }
  }
  EXPECT_EQ(reacquired, 0);
}

TEST(ConstantVelocity, FiveFixesOfOneInstantAreNoSingularity) {
  ConstantVelocity filter;
  filter.reset(isotropic(4.0), Vector2d::Zero(), isotropic(0.01));
  FixResult result;
  for (int i = 0; i < 5; ++i) result = filter.fix({100.0, 0.0}, R_of(kGamma_m));
  EXPECT_TRUE(result.reacquired);
  EXPECT_LT((result.step - Vector2d(100.0, 0.0)).norm(), 1e-9);
  EXPECT_TRUE(symmetric_positive(filter.P()));
}

TEST(ConstantVelocity, NoStreakLocksItOutForEver) {
  // A wrong and certain velocity, noisy fixes with outliers: the prediction runs away from the vehicle.
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    Pcg random(seed);
    ConstantVelocity filter;
    filter.reset(isotropic(0.01), random.uniform(2.0, 20.0) * random.direction(), isotropic(1e-6));
    Vector2d position = Vector2d(1000.0, 0.0);
    ErrorFigures late;
    for (int i = 0; i < 150; ++i) {
      position += filter.predict(8.0);
      Vector2d z = kGamma_m / std::sqrt(2.0) * random.normal2();
      if (random.uniform() < 0.0665) z += random.uniform(15.0, 200.0) * random.direction();
      position += filter.fix(z - position, R_of(kGamma_m)).step;
      if (i >= 75) late.add(position.norm());
    }
    EXPECT_LT(late.rms(), kGamma_m) << "seed " << seed;
  }
}

}  // namespace
}  // namespace leadline::nav
