#include "core/nav/filters/covariance_intersection.h"

#include <Eigen/LU>

#include "core/types/expect.h"

namespace leadline::nav {
namespace {

using Eigen::Matrix2d;
using Eigen::Vector2d;

constexpr double kRandomWalk_m_per_sqrt_s = 0.01;
constexpr double kLongGap_s = 120.0;

Matrix2d isotropic(double variance) { return variance * Matrix2d::Identity(); }

}  // namespace

Fused ci(const Vector2d& x1, const Matrix2d& P1, const Vector2d& x2, const Matrix2d& P2) {
  const double w1 = P2.trace() / (P1.trace() + P2.trace());
  const Matrix2d Y1 = w1 * P1.inverse();
  const Matrix2d Y2 = (1.0 - w1) * P2.inverse();
  const Matrix2d unsymmetric = (Y1 + Y2).inverse();
  const Matrix2d P = 0.5 * (unsymmetric + unsymmetric.transpose());
  return {P * (Y1 * x1 + Y2 * x2), P, w1};
}

PlainCi::PlainCi(double gamma_m) : P_(isotropic(gamma_m * gamma_m / 2.0)) { LL_EXPECT(gamma_m > 0.0); }

void PlainCi::reset(const Matrix2d& P) {
  LL_EXPECT(P.determinant() > 0.0 && P.trace() > 0.0);
  P_ = P;
  correction_.setZero();
  drift_ = {};
  rejected_.clear();
}

void PlainCi::predict(const Vector2d& v_ne_mps, double dt_s) {
  LL_EXPECT(dt_s >= 0.0 && v_ne_mps.allFinite());
  P_ += isotropic(kRandomWalk_m_per_sqrt_s * kRandomWalk_m_per_sqrt_s * dt_s);
  drift_.grow(v_ne_mps.norm(), dt_s);
}

FixResult PlainCi::fix(const Vector2d& residual, double t_s, double gamma_m, double declared_sd_m) {
  LL_EXPECT(residual.allFinite() && gamma_m > 0.0);
  FixResult result;
  result.gate_m = drift_.gate_m(gamma_m, declared_sd_m);

  if (residual.norm() < result.gate_m) {
    if (declared_sd_m > drift_.sd_m())
      P_ += isotropic(declared_sd_m * declared_sd_m / 2.0);
    else if (drift_.since_s > kLongGap_s)
      P_ += isotropic(drift_.sd_m() * drift_.sd_m() / 2.0);
    const Fused fused = ci(Vector2d::Zero(), P_, residual, isotropic(gamma_m * gamma_m / 2.0));
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
  }
  result.accepted = true;
  correction_ += result.step;
  drift_ = {};
  rejected_.clear();
  return result;
}

}  // namespace leadline::nav
