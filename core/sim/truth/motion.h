#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <utility>

#include "core/sim/truth/route.h"
#include "core/sim/truth/water.h"
#include "core/types/expect.h"
#include "core/types/position.h"
#include "core/types/rotation.h"

namespace leadline::sim {

/// What is true of one body's reference point at one instant. Letters as in navigation-ins 1.1: n is
/// north-east-down on the ellipsoid, b forward-starboard-down; the depth is minus the ellipsoid height.
struct Truth {
  double t_s = 0.0;
  Geodetic position;
  double depth_m = 0.0;
  Eigen::Vector3d v_n, a_n;  ///< over ground, and its rate of change in n
  EulerAngles attitude;
  Eigen::Matrix3d C_nb;
  Eigen::Vector3d w_nb_b, alpha_nb_b;  ///< turn rate against n, and its rate of change
  Eigen::Vector3d w_ib_b;              ///< what ideal gyros sense
  Eigen::Vector3d f_b;                 ///< what ideal accelerometers sense
  Eigen::Vector2d current_ne = Eigen::Vector2d::Zero();
  double seabed_m = 0.0;
};

/// A body that follows its route: set points are worked out on a grid of step_s, and between two points of
/// the grid the accelerations ahead, about the vertical and down are constant. So within a step the motion
/// is analytic and everything in Truth is exact, not a difference of samples.
class Motion {
 public:
  Motion(const Route& route, const Water& water, Geodetic origin, double step_s);

  /// The step that is under way; at() may be asked between its ends, both included.
  [[nodiscard]] double from_s() const { return start_.t_s; }
  [[nodiscard]] double to_s() const { return end_.t_s; }
  /// Goes on to the next step.
  void step();
  [[nodiscard]] Truth at(double t_s) const;
  /// The same for the inertial sensors alone, at a fraction of the work: no seabed, no current, and a
  /// position interpolated to a micrometre, which moves neither gravity nor the Earth's rate.
  [[nodiscard]] Truth inertial_at(double t_s) const;

 private:
  struct State {
    double t_s = 0.0;
    double lat = 0.0, lon = 0.0;           // rad
    double depth_m = 0.0, down_mps = 0.0;  // without heave
    double speed_mps = 0.0;
    double heading = 0.0, turn_rps = 0.0;  // without weave
  };
  struct Kinematics {
    Eigen::Vector3d v_n, a_n;
    double depth_m = 0.0;
    Eigen::Vector2d current_ne;
    Eigen::Vector3d euler, rate, acceleration;  // roll, pitch, heading
  };
  struct SetPoints {
    double speed_mps = 0.0, heading = 0.0, depth_m = 0.0, acceleration_mps2 = 0.0;
  };

  void plan();
  [[nodiscard]] bool leg_done(const LegOptions& leg) const;
  void next_leg();
  [[nodiscard]] double heading_to(const LegOptions& leg, double speed_mps) const;
  [[nodiscard]] Kinematics kinematics(double s) const;
  [[nodiscard]] std::pair<double, double> place(double s) const;
  [[nodiscard]] State state(double s) const;
  [[nodiscard]] static Truth sensed(const Kinematics& k, double lat);

  Route route_;
  Water water_;
  Geodetic origin_;
  double step_s_;
  std::int64_t steps_ = 0;

  State start_, end_;
  double speed_change_ = 0.0, turn_change_ = 0.0, down_change_ = 0.0;  // per second, in the step

  std::size_t leg_ = 0;
  std::int64_t rounds_ = 0;
  bool done_ = false;
  double leg_from_s_ = 0.0, leg_run_m_ = 0.0;
  SetPoints wanted_;
};

}  // namespace leadline::sim
