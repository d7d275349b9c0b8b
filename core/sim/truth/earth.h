#pragma once

#include <Eigen/Core>

#include "core/types/angle.h"

namespace leadline::sim {

/// The turning Earth at a place (navigation-ins 1.1): WGS-84, north-east-down, height_m above the ellipsoid.
struct EarthAt {
  double meridian_m, prime_vertical_m;  ///< radii of curvature plus height
  Eigen::Vector3d w_ie_n;               ///< the Earth's rate
  Eigen::Vector3d g_n;                  ///< gravity, down
};
[[nodiscard]] EarthAt earth_at(double lat_rad, double height_m);

/// Rate of the north-east-down axes over the Earth at a velocity.
[[nodiscard]] Eigen::Vector3d transport_rate(const EarthAt& earth, double lat_rad,
                                             const Eigen::Vector3d& v_n);

}  // namespace leadline::sim
