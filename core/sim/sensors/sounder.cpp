#include "core/sim/sensors/sounder.h"

#include <array>
#include <cmath>

namespace leadline::sim {

DepthSensor::DepthSensor(const DepthOptions& o, Random random)
    : options_(o), random_(random), wander_(o.wander_m, o.wander_s, random_) {}

DepthMeasurement DepthSensor::measure(const View& view) {
  const double t_s = view.truth.t_s, dt_s = t_s - last_s_.value_or(t_s);
  last_s_ = t_s;
  return {view.depth_m * (1.0 + 0.01 * options_.scale_percent) + options_.bias_m +
          wander_.advance(dt_s, random_) + random_.normal() * options_.noise_m};
}

AltitudeMeasurement EchoSounder::measure(const View& view) {
  const double above_m = view.truth.seabed_m - view.depth_m;
  const double noise_m = std::hypot(options_.noise_m, 0.01 * options_.noise_percent * above_m);
  const double measured_m = above_m + random_.normal() * noise_m;
  const bool missed = random_.chance(options_.miss_share);
  if (missed || above_m < options_.min_m || above_m > options_.max_m || measured_m < 0.0) return {};
  return {measured_m};
}

std::span<const Key<DepthOptions>> depth_keys() {
  using O = DepthOptions;
  static const std::array<Key<O>, 5> keys{{
      {"noise_m", &O::noise_m, "white, one sigma", 0, 1000},
      {"bias_m", &O::bias_m, "constant", -1000, 1000},
      {"wander_m", &O::wander_m, "correlated, one sigma", 0, 1000},
      {"wander_s", &O::wander_s, "its time constant; 0: constant", 0, 1e6},
      {"scale_percent", &O::scale_percent, "reads this much too deep (density)", -50, 50},
  }};
  return keys;
}

std::span<const Key<AltitudeOptions>> altitude_keys() {
  using O = AltitudeOptions;
  static const std::array<Key<O>, 5> keys{{
      {"noise_m", &O::noise_m, "white, one sigma", 0, 1000},
      {"noise_percent", &O::noise_percent, "of the altitude, added to that", 0, 100},
      {"min_m", &O::min_m, "no echo from nearer", 0, 12000},
      {"max_m", &O::max_m, "no echo from farther", 0, 12000},
      {"miss_share", &O::miss_share, "of the pings without an echo", 0, 1},
  }};
  return keys;
}

}  // namespace leadline::sim
