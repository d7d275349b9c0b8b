#include "core/sim/truth/earth.h"

#include <cmath>

#include "core/geo/geodesy.h"

namespace leadline::sim {

EarthAt earth_at(double lat_rad, double height_m) {
  constexpr double kA = 6378137.0, kE2 = 6.69437999014e-3, kF = 3.352810665e-3, kM = 3.449786507e-3;
  constexpr double kRate = 7.292115e-5;
  const double s = std::sin(lat_rad), c = std::cos(lat_rad), s2 = s * s;
  const geo::Radii radii = geo::radii(Angle::rad(lat_rad));
  const double g0 = 9.7803253359 * (1.0 + 0.00193185265241 * s2) / std::sqrt(1.0 - kE2 * s2);
  const double g = g0 * (1.0 - 2.0 / kA * (1.0 + kF + kM - 2.0 * kF * s2) * height_m +
                         3.0 * height_m * height_m / (kA * kA));
  return {radii.meridian_m + height_m,
          radii.prime_vertical_m + height_m,
          {kRate * c, 0.0, -kRate * s},
          {0.0, 0.0, g}};
}

Eigen::Vector3d transport_rate(const EarthAt& earth, double lat_rad, const Eigen::Vector3d& v_n) {
  return {v_n.y() / earth.prime_vertical_m, -v_n.x() / earth.meridian_m,
          -v_n.y() * std::tan(lat_rad) / earth.prime_vertical_m};
}

}  // namespace leadline::sim
