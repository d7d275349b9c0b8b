#include "core/nav/engines/options.h"

#include <array>

namespace leadline::nav {

std::span<const Key<FusionOptions>> fusion_keys() {
  using O = FusionOptions;
  static const std::array<Key<O>, 1> keys{{
      {"variant",
       &O::variant,
       "error-state: estimates the DVL's misalignment and scale too; windowed-ci: covariance intersection "
       "weighted by what the latest fixes did; plain-ci: that of Kim 2010 with corrected weights",
       0,
       0,
       {"error-state", "windowed-ci", "plain-ci"}},
  }};
  return keys;
}

std::span<const Key<ImuOptions>> imu_keys() {
  using O = ImuOptions;
  static const std::array<Key<O>, 7> keys{{
      {"gyro_bias_deg_h", &O::gyro_bias_deg_h, "one sigma", 0, 1e6},
      {"gyro_noise_deg_sqrt_h", &O::gyro_noise_deg_sqrt_h, "angle random walk", 0, 1e4},
      {"gyro_scale_ppm", &O::gyro_scale_ppm, "0: not estimated", 0, 1e6},
      {"accel_bias_mg", &O::accel_bias_mg, "one sigma", 0, 1e4},
      {"accel_noise_ug_sqrt_hz", &O::accel_noise_ug_sqrt_hz, "velocity random walk", 0, 1e7},
      {"accel_scale_ppm", &O::accel_scale_ppm, "0: not estimated", 0, 1e6},
      {"bias_time_constant_s", &O::bias_time_constant_s, "0: constant", 0, 1e9},
  }};
  return keys;
}

}  // namespace leadline::nav
