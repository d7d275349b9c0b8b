#include "core/nav/filters/windowed_covariance.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "core/nav/filters/covariance_intersection.h"
#include "core/types/expect.h"

namespace leadline::nav {
namespace {

using Eigen::Matrix2d;
using Eigen::Vector2d;

constexpr double kRandomWalk_m_per_sqrt_s = 0.01;
constexpr double kLongGap_s = 120.0;

Matrix2d isotropic(double variance) { return variance * Matrix2d::Identity(); }

/// The nearest symmetric matrix whose eigenvalues are at least `floor`.
Matrix2d floored(const Matrix2d& m, double floor) {
  const Eigen::SelfAdjointEigenSolver<Matrix2d> eigen(m);
  const Matrix2d& V = eigen.eigenvectors();
  const Matrix2d raised = V * eigen.eigenvalues().cwiseMax(floor).asDiagonal() * V.transpose();
  return 0.5 * (raised + raised.transpose());
}

}  // namespace

WindowedCi::WindowedCi(double gamma_m) : P_(isotropic(gamma_m * gamma_m / 2.0)) { LL_EXPECT(gamma_m > 0.0); }

void WindowedCi::reset(const Matrix2d& P) {
  LL_EXPECT(P.determinant() > 0.0 && P.trace() > 0.0);
  P_ = P;
  correction_.setZero();
  drift_ = {};
  rejected_.clear();
  size_ = 0;
}

bool WindowedCi::predict(const Vector2d& v_ne_mps, double dt_s) {
  if (!(dt_s > 0.0) || !std::isfinite(dt_s) || !v_ne_mps.allFinite()) return false;
  P_ += isotropic(kRandomWalk_m_per_sqrt_s * kRandomWalk_m_per_sqrt_s * dt_s);
  drift_.grow(v_ne_mps.norm(), dt_s);
  return true;
}

void WindowedCi::keep(const Entry& entry) {
  if (size_ == kWindow) {
    std::move(window_.begin() + 1, window_.end(), window_.begin());
    --size_;
  }
  window_[static_cast<std::size_t>(size_++)] = entry;
}

Matrix2d WindowedCi::scatter() const {
  double t_mean = 0.0;
  Vector2d e_mean = Vector2d::Zero();
  for (int i = 0; i < size_; ++i) {
    const Entry& entry = window_[static_cast<std::size_t>(i)];
    t_mean += entry.t_s / size_;
    e_mean += entry.e / size_;
  }
  double tt = 0.0;
  Vector2d te = Vector2d::Zero();
  for (int i = 0; i < size_; ++i) {
    const Entry& entry = window_[static_cast<std::size_t>(i)];
    tt += (entry.t_s - t_mean) * (entry.t_s - t_mean);
    te += (entry.t_s - t_mean) * (entry.e - e_mean);
  }
  const Vector2d slope = tt > 0.0 ? Vector2d(te / tt) : Vector2d::Zero();
  Matrix2d sum = Matrix2d::Zero();
  for (int i = 0; i < size_; ++i) {
    const Entry& entry = window_[static_cast<std::size_t>(i)];
    const Vector2d off = entry.e - e_mean - slope * (entry.t_s - t_mean);
    sum += off * off.transpose();
  }
  return sum / (size_ - 2);
}

FixResult WindowedCi::fix(const Vector2d& residual, double t_s, double gamma_m, double declared_sd_m) {
  FixResult result;
  if (!residual.allFinite() || !std::isfinite(t_s) || !(gamma_m > 0.0) || !std::isfinite(gamma_m))
    return result;
  const Matrix2d R0 = isotropic(gamma_m * gamma_m / 2.0);
  result.gate_m = drift_.gate_m(gamma_m, declared_sd_m);

  if (residual.norm() < result.gate_m) {
    if (declared_sd_m > drift_.sd_m())
      P_ += isotropic(declared_sd_m * declared_sd_m / 2.0);
    else if (drift_.since_s > kLongGap_s)
      P_ += isotropic(drift_.sd_m() * drift_.sd_m() / 2.0);
    if (drift_.since_s > kLongGap_s) size_ = 0;
    keep({t_s, residual + correction_, residual});

    Matrix2d P1 = P_, P2 = R0;
    if (size_ >= kEnough) {
      Matrix2d S = Matrix2d::Zero();
      for (int i = 0; i < size_; ++i) {
        const Vector2d& r = window_[static_cast<std::size_t>(i)].r;
        S += r * r.transpose() / size_;
      }
      P2 = 0.5 * (scatter() + R0);
      P1 = floored(S - P2, R0(0, 0) / kWindow);
    }
    const Fused fused = ci(Vector2d::Zero(), P1, residual, P2);
    P_ = fused.P;
    result.step = fused.x;
  } else {
    rejected_.push(t_s, residual + correction_, gamma_m);
    const auto agreement = rejected_.agreement(correction_, drift_);
    if (!agreement) return result;
    P_ = isotropic(agreement->variance);
    result.step = agreement->e - correction_;
    result.reacquired = true;
    result.agreeing = agreement->count;
    result.agreeing_over_s = agreement->span_s;
    size_ = 0;
  }
  result.accepted = true;
  correction_ += result.step;
  drift_ = {};
  rejected_.clear();
  return result;
}

}  // namespace leadline::nav
