#pragma once

#include <Eigen/Core>
#include <array>

#include "core/nav/filters/fix_gate.h"

namespace leadline::nav {

/// Error-state Kalman filter of dead reckoning against fixes (navigation-fusion 1.6): position, misalignment
/// alpha, scale s and, when asked for, a Gauss-Markov error b of the fixes: pdot = (1 - s) Rot(alpha) v,
/// z = p + b + noise. It sets right what makes dead reckoning drift instead of only pulling it back: RMS
/// 0.60 m where Kim 2010's intersection has 2.84 m (gamma 5 m).
///
/// As PlainCi it sees innovations only: the caller keeps the position, moves it by over_ground(v) dt and adds
/// FixResult::step. North, east; SI; alpha clockwise, added to the direction of the velocity.
/// The fix's gate is on the normalised innovation squared (13.8). With the window detector, every fix inside
/// the growing gate of DriftSinceFix passes as well, and five innovations whose mean is too far off open P:
/// a DVL fault is followed within a minute. Re-acquisition is that of RejectedFixes.
class ErrorState {
 public:
  static constexpr double kGateNis = 13.8;  ///< chi-squared, 2 degrees of freedom, p = 0.001

  /// One sigma throughout.
  struct Settings {
    bool window_detector = true;
    double position_sd_m = 5.0, alpha_sd_deg = 5.0, scale_sd = 0.01;     ///< at the start
    double position_walk_m_sqrt_s = 0.005, alpha_walk_deg_sqrt_h = 0.3;  ///< random walks
    double scale_walk_sqrt_s = 1e-5;
    double fix_bias_m = 0.0, fix_bias_time_s = 300.0;  ///< 2-D RMS of b; 0: b is not carried
  };
  explicit ErrorState(const Settings& settings);

  /// Position anew, known with covariance P; alpha and s stay.
  void reset(const Eigen::Matrix2d& P);
  /// Alpha and s from an alignment; what was known of them is forgotten.
  void align(double alpha_rad, double sd_alpha_rad, double s, double sd_s);

  /// A measured velocity as it is over the ground: (1 - s) Rot(alpha) v.
  [[nodiscard]] Eigen::Vector2d over_ground(const Eigen::Vector2d& v_measured) const;
  /// v_ne: over_ground(), over dt_s > 0. False, and nothing is changed: not finite, or dt_s <= 0.
  bool predict(const Eigen::Vector2d& v_ne_mps, double dt_s);

  /// As PlainCi::fix(). A residual, time or gamma that is not finite (or gamma <= 0) is never accepted and
  /// leaves no trace.
  FixResult fix(const Eigen::Vector2d& residual, double t_s, double gamma_m, double declared_sd_m = 0.0);

  [[nodiscard]] double alpha_rad() const { return alpha_; }
  /// s = 1 - reference distance / DVL distance.
  [[nodiscard]] double s() const { return s_; }
  [[nodiscard]] const Eigen::Vector2d& fix_bias() const { return b_; }
  [[nodiscard]] double sd_alpha_rad() const;
  [[nodiscard]] double sd_s() const;
  [[nodiscard]] Eigen::Matrix2d P() const { return P_.topLeftCorner<2, 2>(); }
  /// P() and, where no b is carried, what consecutive innovations have in common: errors of the fixes that
  /// last longer than the time between two, which P knows nothing of.
  [[nodiscard]] Eigen::Matrix2d stated_covariance() const;
  /// Lag-1 autocorrelation of the innovations over about the last 100; above 0.3 b is worth carrying.
  [[nodiscard]] double innovation_correlation() const;
  /// Of [N, E, alpha, s, bN, bE].
  [[nodiscard]] const Eigen::Matrix<double, 6, 6>& P_all() const { return P_; }
  /// Sum of all steps since the last reset: position minus the velocities summed up.
  [[nodiscard]] const Eigen::Vector2d& correction() const { return correction_; }
  [[nodiscard]] const DriftSinceFix& drift() const { return drift_; }

 private:
  static constexpr int kStates = 6, kWindow = 5;
  using State = Eigen::Matrix<double, kStates, 1>;
  using Covariance = Eigen::Matrix<double, kStates, kStates>;

  void detect(const Eigen::Vector2d& innovation, double R);
  void update(const Eigen::Vector2d& innovation, double R, FixResult& result);
  void reacquire(const RejectedFixes::Agreement& agreement, FixResult& result);
  void learn_correlation(const Eigen::Vector2d& innovation);

  Settings settings_;
  double alpha_ = 0.0, s_ = 0.0;
  Eigen::Vector2d b_ = Eigen::Vector2d::Zero();
  Covariance P_ = Covariance::Zero();
  Eigen::Vector2d correction_ = Eigen::Vector2d::Zero();
  DriftSinceFix drift_;
  RejectedFixes rejected_;
  std::array<Eigen::Vector2d, kWindow> window_{};  // innovations, oldest first
  int size_ = 0;

  Eigen::Vector2d last_innovation_ = Eigen::Vector2d::Zero();
  double innovation_m2_ = 0.0, lagged_m2_ = 0.0;  // means of i'i and i'(the one before)
  int innovations_ = 0;
};

}  // namespace leadline::nav
