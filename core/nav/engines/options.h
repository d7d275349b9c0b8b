#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "core/flow/navigation_options.h"
#include "core/types/option_key.h"

namespace leadline::nav {

/// [navigation.fusion]
struct FusionOptions {
  std::string variant = "error-state";
};
[[nodiscard]] std::span<const Key<FusionOptions>> fusion_keys();

/// [navigation.imu]: the sensor model of the inertial engines.
struct ImuOptions {
  double gyro_bias_deg_h = 0.1;
  double gyro_noise_deg_sqrt_h = 0.01;
  double gyro_scale_ppm = 0.0;
  double accel_bias_mg = 0.1;
  double accel_noise_ug_sqrt_hz = 1.0;
  double accel_scale_ppm = 0.0;
  double bias_time_constant_s = 0.0;
};
[[nodiscard]] std::span<const Key<ImuOptions>> imu_keys();

/// All of [navigation].
struct Options : NavigationSettings {
  FusionOptions fusion;
  ImuOptions imu;
};

}  // namespace leadline::nav
