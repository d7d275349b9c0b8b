#include "core/flow/navigation_options.h"

#include <array>

namespace leadline {

std::span<const Key<NavigationOptions>> navigation_keys() {
  using O = NavigationOptions;
  static const std::array<Key<O>, 3> keys{{
      {"engine", &O::engine, "which engine makes the solution, see `leadline list engines`"},
      {"body",
       &O::body,
       "whose solution; \"ship\" where all sources are the ship's",
       0,
       0,
       {"vehicle", "ship"}},
      {"output_hz", &O::output_hz, "rows a second at most; one row an engine epoch", 0.001, 10000},
  }};
  return keys;
}

std::span<const Key<AidingOptions>> aiding_keys() {
  using O = AidingOptions;
  static const std::array<Key<O>, 9> keys{{
      {"gnss_drms_m", &O::gnss_drms_m, "horizontal 2-D RMS error of one GNSS fix", 0.001, 1000},
      {"gnss_height_noise_m", &O::gnss_height_noise_m, "one sigma of one GNSS height", 0.001, 1000},
      {"usbl_drms_m", &O::usbl_drms_m, "horizontal 2-D RMS error of one USBL fix", 0.001, 1000},
      {"dvl_noise_mps", &O::dvl_noise_mps, "one sigma of one ping", 0, 10},
      {"dvl_scale_ppm", &O::dvl_scale_ppm, "one sigma of what a calibration left; 0: not estimated", 0, 1e6},
      {"dvl_misalignment_deg", &O::dvl_misalignment_deg,
       "one sigma of what a calibration left; 0: not estimated", 0, 180},
      {"depth_noise_m", &O::depth_noise_m, "one sigma of one depth", 0, 100},
      {"heading_noise_deg", &O::heading_noise_deg, "one sigma of the heading", 0, 180},
      {"water_current_mps", &O::water_current_mps,
       "one sigma of the current, where only the velocity through the water is known", 0, 10},
  }};
  return keys;
}

std::span<const Key<InitialOptions>> initial_keys() {
  using O = InitialOptions;
  static const std::array<Key<O>, 15> keys{{
      {"lat_deg", &O::lat_deg, "north positive; with lon_deg: where to start", -90, 90},
      {"lon_deg", &O::lon_deg, "east positive", -360, 360},
      {"depth_m", &O::depth_m, "down from the surface", -500, 12000},
      {"ellipsoid_height_m", &O::ellipsoid_height_m, "instead of depth_m", -12000, 500},
      {"vel_north_mps", &O::vel_north_mps, "velocity over ground", -100, 100},
      {"vel_east_mps", &O::vel_east_mps, "velocity over ground", -100, 100},
      {"vel_down_mps", &O::vel_down_mps, "velocity over ground", -100, 100},
      {"roll_deg", &O::roll_deg, "starboard down positive", -180, 180},
      {"pitch_deg", &O::pitch_deg, "bow up positive", -90, 90},
      {"heading_deg", &O::heading_deg, "clockwise from true north", -360, 360},
      {"sd_position_m", &O::sd_position_m, "one sigma of each horizontal axis", 0.001, 1e6},
      {"sd_depth_m", &O::sd_depth_m, "one sigma", 0.001, 1e4},
      {"sd_velocity_mps", &O::sd_velocity_mps, "one sigma of each axis", 0, 100},
      {"sd_roll_pitch_deg", &O::sd_roll_pitch_deg, "one sigma of each", 0, 90},
      {"sd_heading_deg", &O::sd_heading_deg, "one sigma", 0, 180},
  }};
  return keys;
}

}  // namespace leadline
