#include "core/sim/sensors/ahrs.h"

#include <array>
#include <cmath>

namespace leadline::sim {

Ahrs::Ahrs(const AhrsOptions& o, Random random)
    : options_(o),
      random_(random),
      heading_(o.heading_wander_deg * kRadPerDeg, o.heading_wander_s, random_),
      roll_(o.tilt_wander_deg * kRadPerDeg, o.tilt_wander_s, random_),
      pitch_(o.tilt_wander_deg * kRadPerDeg, o.tilt_wander_s, random_) {}

AttitudeMeasurement Ahrs::measure(const View& view) {
  const AhrsOptions& o = options_;
  const double t_s = view.truth.t_s, dt_s = t_s - last_s_.value_or(t_s);
  last_s_ = t_s;
  const double tilt = o.tilt_noise_deg * kRadPerDeg;
  Eigen::Vector3d error;
  error.x() = roll_.advance(dt_s, random_) + random_.normal() * tilt;
  error.y() = pitch_.advance(dt_s, random_) + random_.normal() * tilt;
  error.z() = heading_.advance(dt_s, random_) +
              (random_.normal() * o.heading_noise_deg + o.heading_bias_deg) * kRadPerDeg;
  AttitudeMeasurement m;
  m.attitude = plus(view.attitude, error);
  m.heave_up_m = -view.depth_m + random_.normal() * o.heave_noise_m;
  const Eigen::Vector3d w_s = view.C_bs.transpose() * view.truth.w_nb_b;
  m.rate_z_rps = w_s.z() + (random_.normal() * o.rate_noise_dps + o.rate_bias_dps) * kRadPerDeg;
  m.sd_heading_rad = std::hypot(o.heading_noise_deg, o.heading_wander_deg) * kRadPerDeg;
  m.sd_tilt_rad = std::hypot(o.tilt_noise_deg, o.tilt_wander_deg) * kRadPerDeg;
  return m;
}

std::span<const Key<AhrsOptions>> ahrs_keys() {
  using O = AhrsOptions;
  static const std::array<Key<O>, 13> keys{{
      {"heading_noise_deg", &O::heading_noise_deg, "white, one sigma", 0, 180},
      {"heading_wander_deg", &O::heading_wander_deg, "correlated, one sigma", 0, 180},
      {"heading_wander_s", &O::heading_wander_s, "its time constant; 0: constant", 0, 1e6},
      {"heading_bias_deg", &O::heading_bias_deg, "constant", -180, 180},
      {"tilt_noise_deg", &O::tilt_noise_deg, "of roll and pitch, white, one sigma", 0, 90},
      {"tilt_wander_deg", &O::tilt_wander_deg, "correlated, one sigma", 0, 90},
      {"tilt_wander_s", &O::tilt_wander_s, "its time constant; 0: constant", 0, 1e6},
      {"rate_noise_dps", &O::rate_noise_dps, "of the turn rate, white, one sigma", 0, 1000},
      {"rate_bias_dps", &O::rate_bias_dps, "of the turn rate, constant", -100, 100},
      {"heave_noise_m", &O::heave_noise_m, "one sigma", 0, 100},
      {"heading_decimals", &O::heading_decimals, "in degrees, in NMEA sentences", 0, 9},
      {"tilt_decimals", &O::tilt_decimals, "in degrees, in NMEA sentences", 0, 9},
      {"sigmas_told", &O::sigmas_told, "PASHR states the true sigmas"},
  }};
  return keys;
}

}  // namespace leadline::sim
