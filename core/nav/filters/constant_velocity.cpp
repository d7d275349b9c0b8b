#include "core/nav/filters/constant_velocity.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "core/types/expect.h"

namespace leadline::nav {
namespace {

using Eigen::Matrix2d;
using Eigen::Matrix4d;
using Eigen::Vector2d;
using Eigen::Vector4d;
using Matrix42d = Eigen::Matrix<double, 4, 2>;

constexpr double kUnknownPosition_m = 100.0;
constexpr double kUnknownVelocity_mps = 2.0;

Matrix2d isotropic(double variance) { return variance * Matrix2d::Identity(); }
Matrix4d symmetric(const Matrix4d& m) { return 0.5 * (m + m.transpose()); }

}  // namespace

ConstantVelocity::ConstantVelocity(double sigma_a) : q_(sigma_a * sigma_a) {
  LL_EXPECT(sigma_a > 0.0);
  reset(isotropic(kUnknownPosition_m * kUnknownPosition_m), Vector2d::Zero(),
        isotropic(kUnknownVelocity_mps * kUnknownVelocity_mps));
}

void ConstantVelocity::reset(const Matrix2d& P_position, const Vector2d& velocity,
                             const Matrix2d& P_velocity) {
  LL_EXPECT(P_position.determinant() > 0.0 && P_velocity.determinant() > 0.0 && velocity.allFinite());
  v_ = velocity;
  P_ << P_position, Matrix2d::Zero(), Matrix2d::Zero(), P_velocity;
  forget_streak();
}

Matrix4d ConstantVelocity::process_noise(double dt_s) const {
  const Matrix2d I = Matrix2d::Identity();
  Matrix4d Q;
  Q << dt_s * dt_s * dt_s / 3.0 * I, dt_s * dt_s / 2.0 * I, dt_s * dt_s / 2.0 * I, dt_s * I;
  return q_ * Q;
}

Vector2d ConstantVelocity::predict(double dt_s) {
  LL_EXPECT(dt_s >= 0.0);
  Matrix4d F = Matrix4d::Identity();
  F.topRightCorner<2, 2>() = isotropic(dt_s);
  P_ = symmetric(F * P_ * F.transpose() + process_noise(dt_s));
  Vector2d displacement = v_ * dt_s;
  if (streak_size_ > 0) {
    streak_s_ += dt_s;
    moved_ += displacement;
  }
  return displacement;
}

FixResult ConstantVelocity::fix(const Vector2d& residual, const Matrix2d& R, double gate_nis) {
  LL_EXPECT(residual.allFinite() && R.determinant() > 0.0 && gate_nis > 0.0);
  const Matrix2d S_inverse = (P_position() + R).inverse();
  const double distance_m = residual.norm();
  const Vector2d along = distance_m > 0.0 ? Vector2d(residual / distance_m) : Vector2d::UnitX();

  FixResult result;
  result.gate_m = std::sqrt(gate_nis / along.dot(S_inverse * along));
  if (!(residual.dot(S_inverse * residual) < gate_nis)) {
    keep_rejected(residual, R);
    result.accepted = result.reacquired = restart_from_streak(result);
    return result;
  }
  const Matrix42d K = P_.leftCols<2>() * S_inverse;
  const Vector4d correction = K * residual;
  v_ += correction.tail<2>();
  Matrix4d I_KH = Matrix4d::Identity();
  I_KH.leftCols<2>() -= K;
  P_ = symmetric(I_KH * P_ * I_KH.transpose() + K * R * K.transpose());
  forget_streak();
  result.accepted = true;
  result.step = correction.head<2>();
  return result;
}

void ConstantVelocity::keep_rejected(const Vector2d& residual, const Matrix2d& R) {
  if (streak_size_ == kStreak) {
    std::move(streak_.begin() + 1, streak_.end(), streak_.begin());
    --streak_size_;
  }
  streak_[static_cast<std::size_t>(streak_size_++)] = {streak_s_, residual + moved_, R};
}

bool ConstantVelocity::restart_from_streak(FixResult& result) {
  if (streak_size_ < kStreak) return false;

  Matrix4d information = Matrix4d::Zero();
  // Keeps fixes of one instant solvable.
  information.bottomRightCorner<2, 2>() = isotropic(1.0 / (kUnknownVelocity_mps * kUnknownVelocity_mps));
  Vector4d weighted = Vector4d::Zero();
  for (const Rejected& r : streak_) {
    const double age_s = r.t_s - streak_s_;
    Matrix42d H_transposed;
    H_transposed << Matrix2d::Identity(), isotropic(age_s);
    const Matrix42d HtW = H_transposed * r.R.inverse();
    information += HtW * H_transposed.transpose();
    weighted += HtW * (r.z - moved_);
  }
  const Matrix4d P = information.inverse();
  const Vector4d run = P * weighted;
  for (const Rejected& r : streak_) {
    const Vector2d on_run = run.head<2>() + run.tail<2>() * (r.t_s - streak_s_);
    if (!((r.z - moved_ - on_run).norm() < 2.0 * std::sqrt(r.R.trace()))) return false;
  }

  const double span_s = streak_s_ - streak_.front().t_s;
  // The run was hardly quite straight.
  P_ = symmetric(P + process_noise(span_s));
  v_ = run.tail<2>();
  result.step = run.head<2>();
  result.agreeing = kStreak;
  result.agreeing_over_s = span_s;
  forget_streak();
  return true;
}

void ConstantVelocity::forget_streak() {
  streak_size_ = 0;
  streak_s_ = 0.0;
  moved_.setZero();
}

}  // namespace leadline::nav
