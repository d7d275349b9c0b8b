#pragma once

#include <optional>
#include <span>

#include "core/sim/random.h"
#include "core/sim/sensors/view.h"
#include "core/types/option_key.h"

namespace leadline::sim {

/// A pressure sensor that gives depth.
struct DepthOptions {
  double noise_m = 0.0, bias_m = 0.0, wander_m = 0.0, wander_s = 1800.0, scale_percent = 0.0;
};
[[nodiscard]] std::span<const Key<DepthOptions>> depth_keys();

/// An echo sounder that looks straight down.
struct AltitudeOptions {
  double noise_m = 0.0, noise_percent = 0.0, min_m = 0.2, max_m = 200.0, miss_share = 0.0;
};
[[nodiscard]] std::span<const Key<AltitudeOptions>> altitude_keys();

struct DepthMeasurement {
  double depth_m = 0.0;
};
struct AltitudeMeasurement {
  std::optional<double> above_bottom_m;
};

class DepthSensor {
 public:
  DepthSensor(const DepthOptions& options, Random random);
  [[nodiscard]] DepthMeasurement measure(const View& view);

 private:
  DepthOptions options_;
  Random random_;
  GaussMarkov wander_;
  std::optional<double> last_s_;
};

class EchoSounder {
 public:
  EchoSounder(const AltitudeOptions& options, Random random) : options_(options), random_(random) {}
  [[nodiscard]] AltitudeMeasurement measure(const View& view);

 private:
  AltitudeOptions options_;
  Random random_;
};

}  // namespace leadline::sim
