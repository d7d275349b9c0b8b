#pragma once

#include <Eigen/Core>

namespace leadline::nav {

/// Kang, Lee, Yoon 2017's filter of seven states [X north, Y east, psi, u, v, r, b] for a vehicle with a
/// compass, a rate gyro, a DVL and GNSS on the surface (navigation-fusion 3.1, errata applied): psi is the
/// true heading, b what has to be added to the measured one (declination, mount, the DVL's own misalignment).
///
/// Each sensor is a row of its own, taken when it speaks (eqs. 4 and 5; table 2 takes all six always).
/// Innovations of angles are wrapped; Joseph form. A position is used only at 0.15 m/s or more: standing
/// still it would turn b by its own wander. u, v in level axes, forward and starboard; SI. Every
/// measurement: false, and nothing is changed, when it is not finite, or refused by a gate.
class HeadingBiasFilter {
 public:
  static constexpr int kStates = 7;
  using State = Eigen::Matrix<double, kStates, 1>;
  using Covariance = Eigen::Matrix<double, kStates, kStates>;
  enum Index { X, Y, psi, u, v, r, b };

  static constexpr double kGateNis = 13.8;  ///< positions: 2 degrees of freedom, p = 0.001
  static constexpr double kSlowestForPosition_mps = 0.15;

  /// One sigma throughout; q_: a random walk's, per square root of a second.
  struct Settings {
    double q_velocity_mps = 0.05, q_rate_rps = 0.02, q_bias_rad = 0.0;
    double sd_position_m = 0.3, sd_heading_deg = 10.0, sd_velocity_mps = 0.3, sd_cross_mps = 0.1;
    double sd_rate_deg_s = 2.0, sd_bias_deg = 15.0;     ///< these and the ones before: at the start
    Eigen::Vector2d lever_m = Eigen::Vector2d::Zero();  ///< of the antenna: forward, starboard
    bool position_gate = true;
  };
  explicit HeadingBiasFilter(const Settings& settings) : settings_(settings) {}

  /// The antenna of the first position is at x, y; psi = measured heading + bias.
  void start(const Eigen::Vector2d& antenna_m, double heading_rad, double bias_rad);
  [[nodiscard]] bool started() const { return started_; }

  /// Of the antenna the next positions are of: forward, starboard.
  void lever(const Eigen::Vector2d& lever_m) { settings_.lever_m = lever_m; }
  /// Sets the position anew, moved by `step` and known to `variance` an axis.
  void moved(const Eigen::Vector2d& step, double variance);

  bool predict(double dt_s);  ///< eq. 4, dt_s > 0
  bool heading(double measured_rad, double sd_rad);
  bool rate(double rate_rps, double sd_rps);
  /// sd as the paper has it is velocity_sd_mps() of each component.
  bool velocity(const Eigen::Vector2d& uv_mps, const Eigen::Vector2d& sd_mps);
  /// residual: measured antenna minus antenna(); sd_m an axis.
  bool position(const Eigen::Vector2d& residual_m, double sd_m);

  /// 1 % of the component plus 1 mm/s, at least 3 mm/s.
  [[nodiscard]] static double velocity_sd_mps(double component_mps);

  [[nodiscard]] Eigen::Vector2d antenna() const;
  [[nodiscard]] bool fast_enough() const;
  /// The gate on a position along a direction, m.
  [[nodiscard]] double gate_m(const Eigen::Vector2d& residual_m, double sd_m) const;
  [[nodiscard]] const State& x() const { return x_; }
  [[nodiscard]] const Covariance& P() const { return P_; }

 private:
  using Rows = Eigen::Matrix<double, 2, kStates>;
  [[nodiscard]] Rows position_rows() const;
  void scalar(const Eigen::Matrix<double, 1, kStates>& H, double innovation, double R);
  void pair(const Rows& H, const Eigen::Vector2d& innovation, const Eigen::Matrix2d& R);
  void correct(const State& correction);

  Settings settings_;
  bool started_ = false;
  State x_ = State::Zero();
  Covariance P_ = Covariance::Zero();
};

}  // namespace leadline::nav
