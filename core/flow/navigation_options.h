#pragma once

#include <optional>
#include <span>
#include <string>

#include "core/types/option_key.h"

namespace leadline {

/// [navigation]
struct NavigationOptions {
  std::string engine = "fusion";
  std::string body = "vehicle";
  double output_hz = 10.0;
};
[[nodiscard]] std::span<const Key<NavigationOptions>> navigation_keys();

/// [navigation.aiding]: one sigma a sample where the telegram does not say better. A telegram's own sigma
/// wins, never below a tenth of this.
struct AidingOptions {
  double gnss_drms_m = 2.0;
  double gnss_height_noise_m = 4.0;
  double usbl_drms_m = 5.0;
  double dvl_noise_mps = 0.005;
  double dvl_scale_ppm = 0.0;
  double dvl_misalignment_deg = 0.0;
  double depth_noise_m = 0.1;
  double heading_noise_deg = 0.3;
  double water_current_mps = 0.5;
};
[[nodiscard]] std::span<const Key<AidingOptions>> aiding_keys();

/// [navigation.initial]: when its position is given, engines start from it at the first fact they can use.
struct InitialOptions {
  std::optional<double> lat_deg, lon_deg;
  std::optional<double> depth_m, ellipsoid_height_m;
  std::optional<double> vel_north_mps, vel_east_mps, vel_down_mps;
  std::optional<double> roll_deg, pitch_deg, heading_deg;
  double sd_position_m = 10.0;
  double sd_depth_m = 1.0;
  double sd_velocity_mps = 0.5;
  double sd_roll_pitch_deg = 0.1;
  double sd_heading_deg = 0.1;
};
[[nodiscard]] std::span<const Key<InitialOptions>> initial_keys();

/// What every engine is given of the configuration; an engine's own tables are its plugin's.
struct NavigationSettings {
  NavigationOptions navigation;
  AidingOptions aiding;
  InitialOptions initial;
};

}  // namespace leadline
