#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <optional>

#include "core/nav/availability/intervals.h"
#include "core/types/position.h"

namespace leadline::nav {

/// A track summed up from velocities (Kim 2010 eq. 3), with the sigma of navigation-fusion 1.2: since the
/// last accepted fix P = P0 + sd_scale^2 d d' + sd_angle^2 d_perp d_perp' + I sum((noise dt)^2), d the net
/// displacement; a constant velocity error (an unknown current) adds I (sum(drift dt))^2.
/// Positions are kept as latitude and longitude; displacements are metres north and east.
class DeadReckoning {
 public:
  /// One sigma of what is left in the velocity: scale (1), angle (rad).
  struct Systematic {
    double scale = 0.0, angle_rad = 0.0;
  };
  explicit DeadReckoning(Systematic systematic) : systematic_(systematic) {}

  /// Begins at a position true at t; velocities heard later than t already move it.
  void start(Time t, const Geodetic& position, const Eigen::Matrix2d& P0);
  [[nodiscard]] bool started() const { return started_; }
  /// Where the body is: a metre at 1500 m of depth is 0.24 mm more of latitude than one at the surface.
  void at_depth(Depth depth) { depth_m_ = depth.m; }

  struct Velocity {
    Eigen::Vector2d v_ne = Eigen::Vector2d::Zero();  ///< north, east, m/s
    double noise_mps = 0.0;                          ///< one sigma, white
    double drift_mps = 0.0;                          ///< one sigma, constant (the current, through the water)
  };
  struct Step {
    double dt_s = 0.0;
    Eigen::Vector2d displacement = Eigen::Vector2d::Zero();
    bool gap = false;  ///< longer than max(1 s, 3 median intervals): bridged by the mean velocity, with a
                       ///< sigma for it
  };
  /// A velocity true at t. Empty when it cannot move the track: not started, the first one, time going back.
  std::optional<Step> velocity(Time t, const Velocity& velocity);
  /// A velocity that is known but does not move the track (another filter does).
  void hear(Time t, const Velocity& velocity);
  /// Moves the track to t by a displacement another filter predicted.
  void advance(Time t, const Eigen::Vector2d& displacement);

  /// A filter's correction: moves the present, not the past displacements.
  void shift(const Eigen::Vector2d& step);
  /// A fix was accepted: from here the sigma starts anew with P.
  void fixed(const Eigen::Matrix2d& P);

  [[nodiscard]] Time time() const { return time_; }
  [[nodiscard]] const Geodetic& position() const { return position_; }
  /// Interpolated on the track; up to 3 s (or three intervals) beyond its end by the last velocity. Empty
  /// when the track does not reach there.
  [[nodiscard]] std::optional<Geodetic> position_at(Time t) const;
  [[nodiscard]] Eigen::Matrix2d covariance() const { return P0_ + grown(); }
  /// What covariance() has grown by since the last accepted fix.
  [[nodiscard]] Eigen::Matrix2d grown() const;
  [[nodiscard]] const Eigen::Vector2d& last_velocity() const { return last_.v_ne; }
  [[nodiscard]] std::optional<Time> last_heard() const { return intervals_.last(); }

 private:
  struct Point {
    Time t;
    Eigen::Vector2d travelled = Eigen::Vector2d::Zero();
  };
  static constexpr std::size_t kPoints = 2048;

  void push(Time t);
  void move(const Eigen::Vector2d& displacement);
  [[nodiscard]] Geodetic from_here(const Eigen::Vector2d& displacement) const;
  [[nodiscard]] double longest_interval_s() const;
  [[nodiscard]] const Point& point(std::size_t i) const { return points_[(first_ + i) % kPoints]; }

  Systematic systematic_;
  bool started_ = false;
  Time time_;
  Geodetic position_;
  double depth_m_ = 0.0;
  Velocity last_;
  Intervals intervals_;

  Eigen::Matrix2d P0_ = Eigen::Matrix2d::Zero();
  Eigen::Vector2d net_ = Eigen::Vector2d::Zero();  // displacement since the last accepted fix
  double noise_var_m2_ = 0.0, drift_m_ = 0.0;

  Eigen::Vector2d travelled_ = Eigen::Vector2d::Zero();
  std::array<Point, kPoints> points_{};
  std::size_t first_ = 0, count_ = 0;
};

}  // namespace leadline::nav
