#include "core/nav/filters/heading_bias_filter.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "core/types/angle.h"
#include "core/types/expect.h"

namespace leadline::nav {
namespace {

using Eigen::Matrix2d;
using Eigen::Vector2d;

double squared(double x) { return x * x; }
double wrapped(double rad) { return Angle::rad(rad).wrapped_pi().rad(); }
bool positive(double sd) { return sd > 0.0 && std::isfinite(sd); }

}  // namespace

void HeadingBiasFilter::start(const Vector2d& antenna_m, double heading_rad, double bias_rad) {
  LL_EXPECT(antenna_m.allFinite() && std::isfinite(heading_rad) && std::isfinite(bias_rad));
  started_ = true;
  x_.setZero();
  x_(psi) = wrapped(heading_rad + bias_rad);
  x_(b) = wrapped(bias_rad);
  x_.head<2>() = antenna_m - antenna();
  const Settings& s = settings_;
  State sd;
  sd << s.sd_position_m, s.sd_position_m, s.sd_heading_deg * kRadPerDeg, s.sd_velocity_mps, s.sd_cross_mps,
      s.sd_rate_deg_s * kRadPerDeg, s.sd_bias_deg * kRadPerDeg;
  P_ = sd.cwiseAbs2().asDiagonal();
}

void HeadingBiasFilter::moved(const Vector2d& step, double variance) {
  LL_EXPECT(started_ && step.allFinite() && variance > 0.0);
  x_.head<2>() += step;
  P_.topRows<2>().setZero();
  P_.leftCols<2>().setZero();
  P_.topLeftCorner<2, 2>() = variance * Matrix2d::Identity();
}

bool HeadingBiasFilter::predict(double dt_s) {
  if (!started_ || !(dt_s > 0.0) || !std::isfinite(dt_s)) return false;
  const double c = std::cos(x_(psi)), s = std::sin(x_(psi));
  const double north_mps = x_(u) * c - x_(v) * s, east_mps = x_(u) * s + x_(v) * c;
  Covariance F = Covariance::Identity();
  F(X, psi) = -east_mps * dt_s;
  F(X, u) = c * dt_s;
  F(X, v) = -s * dt_s;
  F(Y, psi) = north_mps * dt_s;
  F(Y, u) = s * dt_s;
  F(Y, v) = c * dt_s;
  F(psi, r) = dt_s;
  x_(X) += north_mps * dt_s;
  x_(Y) += east_mps * dt_s;
  x_(psi) = wrapped(x_(psi) + x_(r) * dt_s);
  const Covariance grown = F * P_ * F.transpose();
  P_ = 0.5 * (grown + grown.transpose());
  P_(u, u) += squared(settings_.q_velocity_mps) * dt_s;
  P_(v, v) += squared(settings_.q_velocity_mps) * dt_s;
  P_(r, r) += squared(settings_.q_rate_rps) * dt_s;
  P_(b, b) += squared(settings_.q_bias_rad) * dt_s;
  return true;
}

bool HeadingBiasFilter::heading(double measured_rad, double sd_rad) {
  if (!started_ || !std::isfinite(measured_rad) || !positive(sd_rad)) return false;
  Eigen::Matrix<double, 1, kStates> H = Eigen::Matrix<double, 1, kStates>::Zero();
  H(psi) = 1.0;
  H(b) = -1.0;
  scalar(H, wrapped(measured_rad - (x_(psi) - x_(b))), squared(sd_rad));
  return true;
}

bool HeadingBiasFilter::rate(double rate_rps, double sd_rps) {
  if (!started_ || !std::isfinite(rate_rps) || !positive(sd_rps)) return false;
  Eigen::Matrix<double, 1, kStates> H = Eigen::Matrix<double, 1, kStates>::Zero();
  H(r) = 1.0;
  scalar(H, rate_rps - x_(r), squared(sd_rps));
  return true;
}

bool HeadingBiasFilter::velocity(const Vector2d& uv_mps, const Vector2d& sd_mps) {
  if (!started_ || !uv_mps.allFinite() || !positive(sd_mps.x()) || !positive(sd_mps.y())) return false;
  Rows H = Rows::Zero();
  H(0, u) = H(1, v) = 1.0;
  pair(H, uv_mps - x_.segment<2>(u), sd_mps.cwiseAbs2().asDiagonal());
  return true;
}

bool HeadingBiasFilter::position(const Vector2d& residual_m, double sd_m) {
  if (!started_ || !residual_m.allFinite() || !positive(sd_m) || !fast_enough()) return false;
  if (settings_.position_gate && !(residual_m.norm() < gate_m(residual_m, sd_m))) return false;
  pair(position_rows(), residual_m, squared(sd_m) * Matrix2d::Identity());
  return true;
}

double HeadingBiasFilter::velocity_sd_mps(double component_mps) {
  return std::max(0.01 * std::abs(component_mps) + 0.001, 0.003);
}

Vector2d HeadingBiasFilter::antenna() const {
  const double c = std::cos(x_(psi)), s = std::sin(x_(psi));
  const Vector2d& l = settings_.lever_m;
  return x_.head<2>() + Vector2d(c * l.x() - s * l.y(), s * l.x() + c * l.y());
}

bool HeadingBiasFilter::fast_enough() const { return std::hypot(x_(u), x_(v)) >= kSlowestForPosition_mps; }

HeadingBiasFilter::Rows HeadingBiasFilter::position_rows() const {
  const double c = std::cos(x_(psi)), s = std::sin(x_(psi));
  const Vector2d& l = settings_.lever_m;
  Rows H = Rows::Zero();
  H(0, X) = H(1, Y) = 1.0;
  H(0, psi) = -s * l.x() - c * l.y();
  H(1, psi) = c * l.x() - s * l.y();
  return H;
}

double HeadingBiasFilter::gate_m(const Vector2d& residual_m, double sd_m) const {
  const Rows H = position_rows();
  const Matrix2d S = H * P_ * H.transpose() + squared(sd_m) * Matrix2d::Identity();
  const double distance_m = residual_m.norm();
  const Vector2d along = distance_m > 0.0 ? Vector2d(residual_m / distance_m) : Vector2d::UnitX();
  return std::sqrt(kGateNis / along.dot(S.inverse() * along));
}

void HeadingBiasFilter::scalar(const Eigen::Matrix<double, 1, kStates>& H, double innovation, double R) {
  const State PHt = P_ * H.transpose();
  const State K = PHt / (H.dot(PHt) + R);
  const Covariance I_KH = Covariance::Identity() - K * H;
  const Covariance P = I_KH * P_ * I_KH.transpose() + R * K * K.transpose();
  P_ = 0.5 * (P + P.transpose());
  correct(K * innovation);
}

void HeadingBiasFilter::pair(const Rows& H, const Vector2d& innovation, const Matrix2d& R) {
  const Eigen::Matrix<double, kStates, 2> PHt = P_ * H.transpose();
  const Matrix2d S = H * PHt + R;
  const Eigen::Matrix<double, kStates, 2> K = PHt * S.inverse();
  const Covariance I_KH = Covariance::Identity() - K * H;
  const Covariance P = I_KH * P_ * I_KH.transpose() + K * R * K.transpose();
  P_ = 0.5 * (P + P.transpose());
  correct(K * innovation);
}

void HeadingBiasFilter::correct(const State& correction) {
  x_ += correction;
  x_(psi) = wrapped(x_(psi));
  x_(b) = wrapped(x_(b));
}

}  // namespace leadline::nav
