#pragma once

#include <Eigen/Core>

#include "core/sim/truth/motion.h"

namespace leadline::sim {

/// Where an instrument really sits: C_bs takes its axes to the body's, lever_b is its place from the body's
/// reference point.
struct Pose {
  Eigen::Matrix3d C_bs = Eigen::Matrix3d::Identity();
  Eigen::Vector3d lever_b = Eigen::Vector3d::Zero();
};

/// What is true at an instrument.
struct View {
  View(const Truth& truth, const Pose& pose);

  const Truth& truth;
  Eigen::Matrix3d C_bs, C_ns;
  Eigen::Vector3d lever_b, lever_n;
  Eigen::Vector3d v_n;   ///< of the instrument, over ground
  EulerAngles attitude;  ///< of the instrument
  double depth_m;        ///< of the instrument

  [[nodiscard]] Geodetic position() const;
};

/// An attitude with errors added to its angles, the heading in [0, 2 pi).
[[nodiscard]] EulerAngles plus(const EulerAngles& a, const Eigen::Vector3d& roll_pitch_heading_rad);

}  // namespace leadline::sim
