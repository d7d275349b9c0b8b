#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>
#include <string>

#include "core/sim/random.h"
#include "core/sim/sensors/view.h"
#include "core/types/option_key.h"

namespace leadline::sim {

/// A USBL transceiver under a ship, which levels and turns its fixes by the ship's attitude.
struct UsblOptions {
  std::string of = "vehicle", transponder = "B01";
  double transponder_x_m = 0.0, transponder_y_m = 0.0, transponder_z_m = 0.0;
  double drms_m = 0.0, range_noise_percent = 0.0;
  double correlated_drms_m = 0.0, correlation_s = 300.0, sound_speed_error_percent = 0.0;
  double heading_noise_deg = 0.0, tilt_noise_deg = 0.0, depth_noise_m = 0.0;
  double outlier_share = 0.0, outlier_from_m = 15.0, outlier_to_m = 200.0;
  double miss_share = 0.0, max_range_m = 10000.0;
  bool sigma_told = false;
};
[[nodiscard]] std::span<const Key<UsblOptions>> usbl_keys();

struct UsblMeasurement {
  bool reply = false;
  std::string transponder;
  bool outlier = false;
  Eigen::Vector2d ne_m = Eigen::Vector2d::Zero();  ///< from the transceiver, north and east
  Angle heading;  ///< of the transceiver, as the device knows it: the hull's plus its mount's yaw
  Geodetic position;
  double depth_m = 0.0;  ///< of the transponder
  double sd_m = 0.0;

  /// From the transceiver, forward and starboard.
  [[nodiscard]] Eigen::Vector2d ahead_m() const;
};

class Usbl {
 public:
  Usbl(const UsblOptions& options, Random random);
  /// transceiver: the instrument under the ship; other: the body that carries the transponder.
  [[nodiscard]] UsblMeasurement measure(const View& transceiver, const Truth& other);

 private:
  UsblOptions options_;
  Random random_;
  GaussMarkov north_, east_;
  std::optional<double> last_s_;
};

}  // namespace leadline::sim
