#pragma once

#include <optional>
#include <span>

#include "core/sim/random.h"
#include "core/sim/sensors/view.h"
#include "core/types/option_key.h"

namespace leadline::sim {

/// An AHRS or a gyrocompass with a motion sensor: true heading, roll, pitch, heave, turn rate.
struct AhrsOptions {
  double heading_noise_deg = 0.0, heading_wander_deg = 0.0, heading_wander_s = 1800.0, heading_bias_deg = 0.0;
  double tilt_noise_deg = 0.0, tilt_wander_deg = 0.0, tilt_wander_s = 600.0;
  double rate_noise_dps = 0.0, rate_bias_dps = 0.0, heave_noise_m = 0.0;
  std::int64_t heading_decimals = 2, tilt_decimals = 2;
  bool sigmas_told = false;
};
[[nodiscard]] std::span<const Key<AhrsOptions>> ahrs_keys();

struct AttitudeMeasurement {
  EulerAngles attitude;
  double heave_up_m = 0.0;
  double rate_z_rps = 0.0;
  double sd_heading_rad = 0.0, sd_tilt_rad = 0.0;
};

class Ahrs {
 public:
  Ahrs(const AhrsOptions& options, Random random);
  [[nodiscard]] AttitudeMeasurement measure(const View& view);

 private:
  AhrsOptions options_;
  Random random_;
  GaussMarkov heading_, roll_, pitch_;
  std::optional<double> last_s_;
};

}  // namespace leadline::sim
