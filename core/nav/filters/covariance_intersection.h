#pragma once

#include <Eigen/Core>

#include "core/nav/filters/fix_gate.h"

namespace leadline::nav {

struct Fused {
  Eigen::Vector2d x;
  Eigen::Matrix2d P;
  double w1;  ///< weight of the first source, 0 to 1
};

/// Covariance intersection of two estimates whose correlation is unknown: P^-1 = w1 P1^-1 + (1 - w1) P2^-1.
/// Kim 2010 eq. 5 and 6 as corrected: w1 = tr(P2) / (tr(P1) + tr(P2)) (Niehsen 2002); as printed the worse
/// source would get the greater weight. P1 and P2 symmetric and positive definite. P is never smaller than
/// the smaller of the two. Isotropic P1 = a I, P2 = b I give P = ab(a+b)/(a^2+b^2) I.
[[nodiscard]] Fused ci(const Eigen::Vector2d& x1, const Eigen::Matrix2d& P1, const Eigen::Vector2d& x2,
                       const Eigen::Matrix2d& P2);

/// Kim 2010's fusion of dead reckoning with position fixes, plus a gate that grows and re-acquisition.
///
/// It sees innovations only: the caller keeps the position x, moves it by v dt as it calls predict(), hands
/// in residuals z - x (of the fix brought to now) and adds FixResult::step. North, east; metres.
/// One fix: |residual| < DriftSinceFix::gate_m(gamma) is accepted; if the last accepted one is older than
/// 120 s, P first grows by the drift, sd^2 / 2 an axis; then ci() with R0 = gamma^2 / 2 I. A rejected fix
/// joins RejectedFixes; if those agree, x goes to dead reckoning plus their mean e, P = R0 / count.
/// In steady state the gain is 1/2 and the RMS error gamma / sqrt 3, whatever the quality of dead reckoning.
class PlainCi {
 public:
  /// Starts as if one fix of this gamma had been taken.
  explicit PlainCi(double gamma_m);

  /// Starts anew at a position known with covariance P.
  void reset(const Eigen::Matrix2d& P);

  /// Velocity over ground, m/s; dt_s >= 0, measured, not nominal. P grows by (0.01 m)^2 per second.
  void predict(const Eigen::Vector2d& v_ne_mps, double dt_s);

  /// residual = fix minus position, both now; t_s on any steady scale; gamma_m > 0, the telegram's own
  /// sigma when it has one.
  /// declared_sd_m: one sigma, 2-D, of what the configuration says dead reckoning may have strayed since the
  /// last accepted fix (an uncalibrated mount); beyond the drift of the gate it widens the gate and P.
  FixResult fix(const Eigen::Vector2d& residual, double t_s, double gamma_m, double declared_sd_m = 0.0);

  [[nodiscard]] const Eigen::Matrix2d& P() const { return P_; }
  /// Sum of all steps since the last reset: position minus pure dead reckoning.
  [[nodiscard]] const Eigen::Vector2d& correction() const { return correction_; }
  [[nodiscard]] const DriftSinceFix& drift() const { return drift_; }

 private:
  Eigen::Matrix2d P_;
  Eigen::Vector2d correction_ = Eigen::Vector2d::Zero();
  DriftSinceFix drift_;
  RejectedFixes rejected_;
};

}  // namespace leadline::nav
