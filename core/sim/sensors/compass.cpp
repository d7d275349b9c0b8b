#include "core/sim/sensors/compass.h"

#include <array>
#include <cmath>

namespace leadline::sim {
namespace {

double deviation_deg(const CompassOptions& o, double heading_rad) {
  return o.deviation_a_deg + o.deviation_b_deg * std::sin(heading_rad) +
         o.deviation_c_deg * std::cos(heading_rad) + o.deviation_d_deg * std::sin(2.0 * heading_rad) +
         o.deviation_e_deg * std::cos(2.0 * heading_rad);
}

/// The compass heading whose deviation brings it to this magnetic heading.
double compass_heading(const CompassOptions& o, double magnetic_rad) {
  double compass = magnetic_rad;
  for (int i = 0; i < 20; ++i) compass = magnetic_rad - deviation_deg(o, compass) * kRadPerDeg;
  return compass;
}

}  // namespace

Compass::Compass(const CompassOptions& o, const geo::MagneticModel* magnetic, Time start, Random random)
    : options_(o),
      magnetic_(magnetic),
      start_(start),
      random_(random),
      wander_(o.wander_deg * kRadPerDeg, o.wander_s, random_) {
  LL_EXPECT(magnetic_ != nullptr || options_.declination_deg.has_value());
}

CompassMeasurement Compass::measure(const View& view) {
  const CompassOptions& o = options_;
  const double t_s = view.truth.t_s, dt_s = t_s - last_s_.value_or(t_s);
  last_s_ = t_s;
  const Angle declination =
      o.declination_deg
          ? Angle::deg(*o.declination_deg)
          : magnetic_->declination(view.truth.position, EllipsoidHeight{0.0}, start_ + duration(t_s)).east;
  const double error = wander_.advance(dt_s, random_) + random_.normal() * o.noise_deg * kRadPerDeg;
  const double magnetic = (view.attitude.heading - declination).rad();
  CompassMeasurement m;
  m.heading = Angle::rad(compass_heading(o, magnetic) + error).wrapped_2pi();
  if (o.variation_told) m.variation = declination;
  return m;
}

std::span<const Key<CompassOptions>> compass_keys() {
  using O = CompassOptions;
  static const std::array<Key<O>, 11> keys{{
      {"declination_deg", &O::declination_deg, "east positive; left out: the world magnetic model's", -180,
       180},
      {"deviation_a_deg", &O::deviation_a_deg, "constant part of the deviation", -90, 90},
      {"deviation_b_deg", &O::deviation_b_deg, "with the sine of the compass heading", -20, 20},
      {"deviation_c_deg", &O::deviation_c_deg, "with its cosine", -20, 20},
      {"deviation_d_deg", &O::deviation_d_deg, "with the sine of twice the heading", -10, 10},
      {"deviation_e_deg", &O::deviation_e_deg, "with its cosine", -10, 10},
      {"noise_deg", &O::noise_deg, "white, one sigma", 0, 180},
      {"wander_deg", &O::wander_deg, "correlated, one sigma", 0, 180},
      {"wander_s", &O::wander_s, "its time constant; 0: constant", 0, 1e6},
      {"heading_decimals", &O::heading_decimals, "in degrees, in NMEA sentences", 0, 9},
      {"variation_told", &O::variation_told, "HDG holds the declination"},
  }};
  return keys;
}

}  // namespace leadline::sim
