#pragma once

#include <Eigen/Core>
#include <array>

#include "core/nav/filters/fix_gate.h"

namespace leadline::nav {

/// Kalman filter on [N, E, vN, vE] for when there are fixes but no velocity (availability C and D).
///
/// As in PlainCi the position itself stays with the caller: it adds what predict() and fix() return. North,
/// east; SI. White acceleration of density sigma_a, discretised exactly; gate on the normalised innovation
/// squared; Joseph form. State D on a 0.5 m/s lawn-mower, gamma 5 m: RMS 3.8 m, 4.1 m with 6.65 % outliers,
/// but up to 50 m for a minute where outliers hide a turn.
/// Re-acquisition: when five fixes in a row were rejected and all lie within 2 gamma of one straight run
/// (a least-squares position and velocity, velocity a priori 0 +- 2 m/s an axis), the filter starts anew
/// from that run. Without bottom lock a jump cannot be told from motion, so its size is not limited.
class ConstantVelocity {
 public:
  static constexpr double kGateNis = 13.8;  ///< chi-squared, 2 degrees of freedom, p = 0.001

  /// sigma_a in m/s^2/sqrt(Hz). Starts knowing nothing: 100 m and 2 m/s an axis, at rest.
  explicit ConstantVelocity(double sigma_a = 0.03);

  void reset(const Eigen::Matrix2d& P_position, const Eigen::Vector2d& velocity,
             const Eigen::Matrix2d& P_velocity);

  /// The displacement to add to the position; dt_s >= 0.
  [[nodiscard]] Eigen::Vector2d predict(double dt_s);

  /// residual = fix minus position, both now; R its covariance, positive definite (gamma^2 = tr R).
  FixResult fix(const Eigen::Vector2d& residual, const Eigen::Matrix2d& R, double gate_nis = kGateNis);

  [[nodiscard]] const Eigen::Vector2d& velocity() const { return v_; }
  /// Of [N, E, vN, vE].
  [[nodiscard]] const Eigen::Matrix4d& P() const { return P_; }
  [[nodiscard]] Eigen::Matrix2d P_position() const { return P_.topLeftCorner<2, 2>(); }

 private:
  static constexpr int kStreak = 5;
  struct Rejected {
    double t_s;         // since the streak began
    Eigen::Vector2d z;  // from where the position was when the streak began
    Eigen::Matrix2d R;
  };
  [[nodiscard]] Eigen::Matrix4d process_noise(double dt_s) const;
  void keep_rejected(const Eigen::Vector2d& residual, const Eigen::Matrix2d& R);
  bool restart_from_streak(FixResult& result);
  void forget_streak();

  double q_;  // sigma_a^2
  Eigen::Vector2d v_ = Eigen::Vector2d::Zero();
  Eigen::Matrix4d P_;
  std::array<Rejected, kStreak> streak_{};  // oldest first
  int streak_size_ = 0;
  double streak_s_ = 0.0;
  Eigen::Vector2d moved_ = Eigen::Vector2d::Zero();  // of the position since the streak began
};

}  // namespace leadline::nav
