#pragma once

#include <optional>
#include <span>

#include "core/messages/measurements.h"
#include "core/sim/random.h"
#include "core/sim/sensors/view.h"
#include "core/types/option_key.h"

namespace leadline::sim {

/// A GNSS receiver: white and correlated error, grown by the HDOP, dropouts, nothing under water.
struct GnssOptions {
  double drms_m = 0.0, correlated_drms_m = 0.0, correlation_s = 300.0;
  double height_noise_m = 0.0, speed_noise_mps = 0.0;
  double hdop = 0.9, hdop_variation = 0.0, hdop_period_s = 900.0;
  std::int64_t satellites = 12, quality = 1;
  double dropout_share = 0.0, dropout_mean_s = 10.0;
  double deepest_m = 0.5;
  std::int64_t position_decimals = 5;
  bool sigmas_told = false;
};
[[nodiscard]] std::span<const Key<GnssOptions>> gnss_keys();

struct GnssMeasurement {
  bool fix = false;  ///< false: the receiver speaks and has no position
  Geodetic position;
  double height_m = 0.0;  ///< above the ellipsoid
  double speed_mps = 0.0;
  std::optional<Angle> course;
  double vel_north_mps = 0.0, vel_east_mps = 0.0;
  double hdop = 1.0;
  int satellites = 0, quality = 1;
  double sd_axis_m = 0.0, sd_height_m = 0.0;
};

class Gnss {
 public:
  Gnss(const GnssOptions& options, Random random);
  [[nodiscard]] GnssMeasurement measure(const View& view);

 private:
  GnssOptions options_;
  Random random_;
  GaussMarkov north_, east_;
  std::optional<double> last_s_;
  double lost_until_s_ = -1.0;
};

}  // namespace leadline::sim
