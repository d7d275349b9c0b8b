#pragma once

#include <optional>
#include <span>

#include "core/geo/magnetic.h"
#include "core/sim/random.h"
#include "core/sim/sensors/view.h"
#include "core/types/option_key.h"

namespace leadline::sim {

/// A magnetic compass: true heading = magnetic + declination, magnetic = compass + deviation, the deviation
/// A + B sin h + C cos h + D sin 2h + E cos 2h of the compass's own heading h.
struct CompassOptions {
  std::optional<double> declination_deg;
  double deviation_a_deg = 0.0, deviation_b_deg = 0.0, deviation_c_deg = 0.0, deviation_d_deg = 0.0,
         deviation_e_deg = 0.0;
  double noise_deg = 0.0, wander_deg = 0.0, wander_s = 600.0;
  std::int64_t heading_decimals = 1;
  bool variation_told = false;
};
[[nodiscard]] std::span<const Key<CompassOptions>> compass_keys();

struct CompassMeasurement {
  Angle heading;                   ///< from magnetic north, of the instrument, deviation not applied
  std::optional<Angle> variation;  ///< as the telegram tells it
};

class Compass {
 public:
  /// magnetic may be null when declination_deg is given; start: the scenario's.
  Compass(const CompassOptions& options, const geo::MagneticModel* magnetic, Time start, Random random);
  [[nodiscard]] CompassMeasurement measure(const View& view);

 private:
  CompassOptions options_;
  const geo::MagneticModel* magnetic_;
  Time start_;
  Random random_;
  GaussMarkov wander_;
  std::optional<double> last_s_;
};

}  // namespace leadline::sim
