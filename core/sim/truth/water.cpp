#include "core/sim/truth/water.h"

#include <array>
#include <cmath>

#include "core/types/angle.h"

namespace leadline::sim {
namespace {

Eigen::Vector2d towards(double deg, double size) {
  return {size * std::cos(deg * kRadPerDeg), size * std::sin(deg * kRadPerDeg)};
}

}  // namespace

std::span<const Key<WaterOptions>> water_keys() {
  using O = WaterOptions;
  static const std::array<Key<O>, 12> keys{{
      {"current_mps", &O::current_mps, "constant current", 0, 10},
      {"current_towards_deg", &O::current_towards_deg, "where it flows to, from true north", -360, 360},
      {"tide_mps", &O::tide_mps, "amplitude of the tidal current", 0, 10},
      {"tide_towards_deg", &O::tide_towards_deg, "where the flood flows to", -360, 360},
      {"tide_period_s", &O::tide_period_s, "of the tide", 1, 1e6},
      {"tide_phase_deg", &O::tide_phase_deg, "at the start; 0: slack water before the flood", -360, 360},
      {"shear_mps_per_m", &O::shear_mps_per_m, "what the current grows by for each metre of depth", 0, 1},
      {"shear_towards_deg", &O::shear_towards_deg, "where that part flows to", -360, 360},
      {"sound_speed_mps", &O::sound_speed_mps, "as the instruments report it", 1400, 1600},
      {"seabed_m", &O::seabed_m, "depth of the bottom at the origin", 0.1, 12000},
      {"seabed_slope_north", &O::seabed_slope_north, "metres deeper for a metre north", -1, 1},
      {"seabed_slope_east", &O::seabed_slope_east, "metres deeper for a metre east", -1, 1},
  }};
  return keys;
}

Water::Water(const WaterOptions& o)
    : options_(o),
      constant_(towards(o.current_towards_deg, o.current_mps)),
      tide_(towards(o.tide_towards_deg, o.tide_mps)),
      shear_(towards(o.shear_towards_deg, o.shear_mps_per_m)),
      tide_rate_(2.0 * kPi / o.tide_period_s),
      tide_phase_(o.tide_phase_deg * kRadPerDeg) {}

Eigen::Vector2d Water::current(double t_s, double depth_m) const {
  return constant_ + tide_ * std::sin(tide_rate_ * t_s + tide_phase_) + shear_ * depth_m;
}

Eigen::Vector2d Water::current_change(double t_s, double vel_down_mps) const {
  return tide_ * (tide_rate_ * std::cos(tide_rate_ * t_s + tide_phase_)) + shear_ * vel_down_mps;
}

double Water::strongest_mps(double depth_m) const {
  return constant_.norm() + tide_.norm() + shear_.norm() * depth_m;
}

}  // namespace leadline::sim
