#pragma once

#include <Eigen/Core>
#include <span>

#include "core/types/option_key.h"

namespace leadline::sim {

/// [water]: a constant current, a tide and a shear that grows with depth; a seabed that slopes.
struct WaterOptions {
  double current_mps = 0.0, current_towards_deg = 0.0;
  double tide_mps = 0.0, tide_towards_deg = 0.0, tide_period_s = 44712.0, tide_phase_deg = 0.0;
  double shear_mps_per_m = 0.0, shear_towards_deg = 0.0;
  double sound_speed_mps = 1500.0;
  double seabed_m = 100.0, seabed_slope_north = 0.0, seabed_slope_east = 0.0;
};
[[nodiscard]] std::span<const Key<WaterOptions>> water_keys();

class Water {
 public:
  explicit Water(const WaterOptions& options);

  /// North, east, m/s, t_s after the scenario's start.
  [[nodiscard]] Eigen::Vector2d current(double t_s, double depth_m) const;
  /// Its change as felt by a body that sinks with vel_down_mps.
  [[nodiscard]] Eigen::Vector2d current_change(double t_s, double vel_down_mps) const;
  /// The strongest there can be down to a depth.
  [[nodiscard]] double strongest_mps(double depth_m) const;
  /// Depth of the bottom, by the place north and east of the scenario's origin.
  [[nodiscard]] double seabed_m(double north_m, double east_m) const {
    return options_.seabed_m + options_.seabed_slope_north * north_m + options_.seabed_slope_east * east_m;
  }
  /// Downwards slopes towards north and east.
  [[nodiscard]] Eigen::Vector2d slope() const {
    return {options_.seabed_slope_north, options_.seabed_slope_east};
  }
  [[nodiscard]] double sound_speed_mps() const { return options_.sound_speed_mps; }

 private:
  WaterOptions options_;
  Eigen::Vector2d constant_, tide_, shear_;
  double tide_rate_, tide_phase_;
};

}  // namespace leadline::sim
