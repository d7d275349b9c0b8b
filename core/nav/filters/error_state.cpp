#include "core/nav/filters/error_state.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "core/types/angle.h"
#include "core/types/expect.h"

namespace leadline::nav {
namespace {

using Eigen::Matrix2d;
using Eigen::Vector2d;

constexpr int kAlpha = 2, kScale = 3, kBias = 4;
constexpr double kWindowNis = 20.0;
constexpr double kLongGap_s = 120.0;
constexpr int kCorrelationOver = 100;
/// Fewer innovations than this say nothing of their correlation.
constexpr int kCorrelationFrom = 20;

Matrix2d isotropic(double variance) { return variance * Matrix2d::Identity(); }
double squared(double x) { return x * x; }

}  // namespace

ErrorState::ErrorState(const Settings& settings) : settings_(settings) {
  LL_EXPECT(settings.position_sd_m > 0.0 && settings.alpha_sd_deg >= 0.0 && settings.scale_sd >= 0.0 &&
            settings.fix_bias_m >= 0.0 && settings.fix_bias_time_s > 0.0);
  P_.topLeftCorner<2, 2>() = isotropic(squared(settings.position_sd_m));
  P_(kAlpha, kAlpha) = squared(settings.alpha_sd_deg * kRadPerDeg);
  P_(kScale, kScale) = squared(settings.scale_sd);
  P_.bottomRightCorner<2, 2>() = isotropic(squared(settings.fix_bias_m) / 2.0);
}

void ErrorState::reset(const Matrix2d& P) {
  LL_EXPECT(P.determinant() > 0.0 && P.trace() > 0.0);
  P_.topRows<2>().setZero();
  P_.leftCols<2>().setZero();
  P_.topLeftCorner<2, 2>() = 0.5 * (P + P.transpose());
  correction_.setZero();
  drift_ = {};
  rejected_.clear();
  size_ = innovations_ = 0;
}

void ErrorState::align(double alpha_rad, double sd_alpha_rad, double s, double sd_s) {
  LL_EXPECT(std::isfinite(alpha_rad) && sd_alpha_rad > 0.0 && s < 1.0 && sd_s > 0.0);
  alpha_ = alpha_rad;
  s_ = s;
  P_.middleRows<2>(kAlpha).setZero();
  P_.middleCols<2>(kAlpha).setZero();
  P_(kAlpha, kAlpha) = squared(sd_alpha_rad);
  P_(kScale, kScale) = squared(sd_s);
  size_ = innovations_ = 0;
}

Vector2d ErrorState::over_ground(const Vector2d& v) const {
  const double c = std::cos(alpha_), s = std::sin(alpha_);
  return (1.0 - s_) * Vector2d(c * v.x() - s * v.y(), s * v.x() + c * v.y());
}

bool ErrorState::predict(const Vector2d& v_ne_mps, double dt_s) {
  if (!(dt_s > 0.0) || !std::isfinite(dt_s) || !v_ne_mps.allFinite()) return false;
  const Vector2d moved = v_ne_mps * dt_s;
  Covariance F = Covariance::Identity();
  F.block<2, 1>(0, kAlpha) << -moved.y(), moved.x();
  F.block<2, 1>(0, kScale) = -moved / (1.0 - s_);
  State Q = State::Zero();
  Q.head<2>().setConstant(squared(settings_.position_walk_m_sqrt_s) * dt_s);
  Q(kAlpha) = squared(settings_.alpha_walk_deg_sqrt_h * kRadPerDeg) * dt_s / 3600.0;
  Q(kScale) = squared(settings_.scale_walk_sqrt_s) * dt_s;
  const double kept = std::exp(-dt_s / settings_.fix_bias_time_s);
  F.bottomRightCorner<2, 2>() = isotropic(kept);
  Q.tail<2>().setConstant(squared(settings_.fix_bias_m) / 2.0 * (1.0 - kept * kept));

  b_ *= kept;
  const Covariance grown = F * P_ * F.transpose();
  P_ = 0.5 * (grown + grown.transpose());
  P_.diagonal() += Q;
  drift_.grow(v_ne_mps.norm(), dt_s);
  return true;
}

FixResult ErrorState::fix(const Vector2d& residual, double t_s, double gamma_m, double declared_sd_m) {
  FixResult result;
  if (!residual.allFinite() || !std::isfinite(t_s) || !(gamma_m > 0.0) || !std::isfinite(gamma_m))
    return result;
  const double R = gamma_m * gamma_m / 2.0;
  // What dead reckoning may have strayed beyond the model counts for this fix, and stays only if it is used.
  double strayed = declared_sd_m > drift_.sd_m() ? squared(declared_sd_m) / 2.0 : 0.0;
  const Vector2d innovation = residual - b_;
  const Matrix2d P_pb = P_.block<2, 2>(0, kBias);
  const Matrix2d S = P() + isotropic(R + strayed) + P_pb + P_pb.transpose() + P_.bottomRightCorner<2, 2>();
  const Matrix2d S_inverse = S.inverse();
  const double distance_m = residual.norm();
  const Vector2d along = distance_m > 0.0 ? Vector2d(residual / distance_m) : Vector2d::UnitX();
  result.gate_m = std::sqrt(kGateNis / along.dot(S_inverse * along));
  bool inside = innovation.dot(S_inverse * innovation) < kGateNis;
  if (settings_.window_detector) {
    const double outer_m = drift_.gate_m(gamma_m, declared_sd_m);
    result.gate_m = std::max(result.gate_m, outer_m);
    // After a long gap the first fix outside what P explains tells that P was too small; passed without that
    // it would move the position a little and close the gate before the others.
    if (!inside && distance_m < outer_m && drift_.since_s > kLongGap_s && strayed == 0.0)
      strayed = squared(drift_.sd_m()) / 2.0;
    inside = inside || distance_m < outer_m;
  }
  if (!inside) {
    rejected_.push(t_s, residual + correction_, gamma_m);
    const auto agreement = rejected_.agreement(correction_, drift_);
    if (!agreement) return result;
    reacquire(*agreement, result);
  } else {
    P_.topLeftCorner<2, 2>() += isotropic(strayed);
    if (settings_.window_detector) detect(innovation, R);
    learn_correlation(innovation);
    update(innovation, R, result);
  }
  result.accepted = true;
  correction_ += result.step;
  drift_ = {};
  rejected_.clear();
  return result;
}

void ErrorState::detect(const Vector2d& innovation, double R) {
  if (size_ == kWindow) {
    std::move(window_.begin() + 1, window_.end(), window_.begin());
    --size_;
  }
  window_[static_cast<std::size_t>(size_++)] = innovation;
  if (size_ < kWindow) return;
  Vector2d mean = Vector2d::Zero();
  for (const Vector2d& i : window_) mean += i / kWindow;
  const Matrix2d P_pb = P_.block<2, 2>(0, kBias);
  const Matrix2d S = P() + P_pb + P_pb.transpose() + P_.bottomRightCorner<2, 2>() + isotropic(R / kWindow);
  if (!(mean.dot(S.inverse() * mean) > kWindowNis)) return;
  P_.topLeftCorner<2, 2>() += mean * mean.transpose() + isotropic(mean.squaredNorm() / 4.0);
  size_ = 0;
}

void ErrorState::update(const Vector2d& innovation, double R, FixResult& result) {
  const Eigen::Matrix<double, kStates, 2> PHt = P_.leftCols<2>() + P_.rightCols<2>();
  const Matrix2d S = PHt.topRows<2>() + PHt.bottomRows<2>() + isotropic(R);
  const Eigen::Matrix<double, kStates, 2> K = PHt * S.inverse();
  const State correction = K * innovation;
  result.step = correction.head<2>();
  alpha_ = Angle::rad(alpha_ + correction(kAlpha)).wrapped_pi().rad();
  s_ += correction(kScale);
  b_ += correction.tail<2>();
  Covariance I_KH = Covariance::Identity();
  I_KH.leftCols<2>() -= K;
  I_KH.rightCols<2>() -= K;
  const Covariance P = I_KH * P_ * I_KH.transpose() + R * K * K.transpose();
  P_ = 0.5 * (P + P.transpose());
}

void ErrorState::reacquire(const RejectedFixes::Agreement& agreement, FixResult& result) {
  result.step = agreement.e - correction_ - b_;
  result.reacquired = true;
  result.agreeing = agreement.count;
  result.agreeing_over_s = agreement.span_s;
  const Matrix2d P_bb = P_.bottomRightCorner<2, 2>();
  P_.topRows<2>().setZero();
  P_.leftCols<2>().setZero();
  P_.topLeftCorner<2, 2>() = isotropic(agreement.variance) + P_bb;
  // p = z - b - noise.
  P_.topRightCorner<2, 2>() = -P_bb;
  P_.bottomLeftCorner<2, 2>() = -P_bb;
  size_ = innovations_ = 0;
}

void ErrorState::learn_correlation(const Vector2d& innovation) {
  if (innovations_ == 0) innovation_m2_ = lagged_m2_ = 0.0;
  const double share = 1.0 / std::min(innovations_ + 1, kCorrelationOver);
  innovation_m2_ += share * (innovation.squaredNorm() - innovation_m2_);
  if (innovations_ > 0) {
    const double pairs = 1.0 / std::min(innovations_, kCorrelationOver);
    lagged_m2_ += pairs * (innovation.dot(last_innovation_) - lagged_m2_);
  }
  last_innovation_ = innovation;
  innovations_ = std::min(innovations_ + 1, kCorrelationOver);
}

double ErrorState::innovation_correlation() const {
  return innovations_ < kCorrelationFrom || !(innovation_m2_ > 0.0) ? 0.0 : lagged_m2_ / innovation_m2_;
}

Matrix2d ErrorState::stated_covariance() const {
  if (settings_.fix_bias_m > 0.0 || innovations_ < kCorrelationFrom || !(lagged_m2_ > 0.0)) return P();
  return P() + isotropic(lagged_m2_ / 2.0);
}

double ErrorState::sd_alpha_rad() const { return std::sqrt(P_(kAlpha, kAlpha)); }
double ErrorState::sd_s() const { return std::sqrt(P_(kScale, kScale)); }

}  // namespace leadline::nav
