#include "core/sim/sensors/gnss.h"

#include <array>
#include <cmath>

#include "core/geo/geodesy.h"

namespace leadline::sim {

Gnss::Gnss(const GnssOptions& o, Random random)
    : options_(o),
      random_(random),
      north_(o.correlated_drms_m * std::sqrt(0.5), o.correlation_s, random_),
      east_(o.correlated_drms_m * std::sqrt(0.5), o.correlation_s, random_) {}

GnssMeasurement Gnss::measure(const View& view) {
  const GnssOptions& o = options_;
  const double t_s = view.truth.t_s, dt_s = t_s - last_s_.value_or(t_s);
  last_s_ = t_s;
  GnssMeasurement m;
  m.hdop = o.hdop * (1.0 + o.hdop_variation * std::sin(2.0 * kPi * t_s / o.hdop_period_s));
  m.satellites = static_cast<int>(o.satellites);
  m.quality = static_cast<int>(o.quality);
  const double grown = m.hdop / o.hdop;
  m.sd_axis_m = std::sqrt(0.5) * std::hypot(o.drms_m * grown, o.correlated_drms_m);
  m.sd_height_m = o.height_noise_m * grown;

  // Every number is drawn whether it is used or not: what is lost does not move what comes after.
  // One draw a statement: the order of draws within one is the compiler's.
  const double white_m = o.drms_m * std::sqrt(0.5) * grown;
  double n = random_.normal() * white_m;
  n += north_.advance(dt_s, random_);
  double e = random_.normal() * white_m;
  e += east_.advance(dt_s, random_);
  const double up = random_.normal() * m.sd_height_m;
  const Eigen::Vector2d v = view.v_n.head<2>() + random_.normal2() * o.speed_noise_mps;
  const double chance = random_.uniform(), length = random_.uniform();
  if (t_s >= lost_until_s_ && o.dropout_share > 0.0) {
    // Lost for a share of the time: outages of this mean length begin at this rate.
    const double begins = o.dropout_share / (1.0 - o.dropout_share) * dt_s / o.dropout_mean_s;
    if (chance < begins) lost_until_s_ = t_s - o.dropout_mean_s * std::log(length);
  }
  m.fix = t_s >= lost_until_s_ && view.depth_m <= o.deepest_m;
  m.position = geo::displaced(view.position(), n, e);
  m.height_m = -view.depth_m + up;
  m.vel_north_mps = v.x(), m.vel_east_mps = v.y();
  m.speed_mps = v.norm();
  if (m.speed_mps > 1e-3) m.course = Angle::rad(std::atan2(v.y(), v.x())).wrapped_2pi();
  return m;
}

std::span<const Key<GnssOptions>> gnss_keys() {
  using O = GnssOptions;
  static const std::array<Key<O>, 15> keys{{
      {"drms_m", &O::drms_m, "white error, horizontal 2-D RMS, at the nominal HDOP", 0, 1000},
      {"correlated_drms_m", &O::correlated_drms_m, "correlated error, horizontal 2-D RMS", 0, 1000},
      {"correlation_s", &O::correlation_s, "its time constant; 0: constant", 0, 1e6},
      {"height_noise_m", &O::height_noise_m, "one sigma, white", 0, 1000},
      {"speed_noise_mps", &O::speed_noise_mps, "one sigma of each axis, white", 0, 100},
      {"hdop", &O::hdop, "nominal", 0.1, 99},
      {"hdop_variation", &O::hdop_variation, "share of it that comes and goes", 0, 0.95},
      {"hdop_period_s", &O::hdop_period_s, "of that", 1, 1e6},
      {"satellites", &O::satellites, "as reported", 0, 99},
      {"quality", &O::quality, "GGA quality: 1 autonomous, 2 differential, 4 RTK fixed, 5 RTK float", 1, 5},
      {"dropout_share", &O::dropout_share, "of the time without a position", 0, 0.95},
      {"dropout_mean_s", &O::dropout_mean_s, "mean length of a dropout", 0.01, 1e6},
      {"deepest_m", &O::deepest_m, "no position when the antenna is deeper", -100, 12000},
      {"position_decimals", &O::position_decimals, "of the minutes of arc: 5 is 19 mm", 0, 9},
      {"sigmas_told", &O::sigmas_told, "a GST sentence with the true sigmas"},
  }};
  return keys;
}

}  // namespace leadline::sim
