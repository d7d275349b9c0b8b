#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "core/sim/random.h"
#include "core/sim/sensors/view.h"
#include "core/sim/truth/water.h"
#include "core/types/option_key.h"

namespace leadline::sim {

/// A four-beam DVL with a compass and inclinometers of its own.
struct DvlOptions {
  double noise_mps = 0.0, noise_percent = 0.0, scale_percent = 0.0;
  double bias_x_mps = 0.0, bias_y_mps = 0.0, bias_z_mps = 0.0;
  double beam_angle_deg = 30.0, beam_loss_share = 0.0, ping_loss_share = 0.0;
  double min_altitude_m = 0.5, max_altitude_m = 110.0, range_noise_percent = 0.0;
  bool water_track = false;
  double water_layer_m = 10.0, water_noise_mps = 0.0;
  double heading_noise_deg = 0.0, heading_wander_deg = 0.0, heading_wander_s = 1800.0, tilt_noise_deg = 0.0;
  std::string coordinates = "instrument";
  bool high_resolution = false, attitude_told = true, depth_told = false;
};
[[nodiscard]] std::span<const Key<DvlOptions>> dvl_keys();

/// Velocities are of the instrument, forward-starboard-down of its own axes.
struct DvlMeasurement {
  bool bottom = false;         ///< lock: at least three beams see the bottom
  std::array<bool, 4> beam{};  ///< which of them do
  Eigen::Vector3d v_s = Eigen::Vector3d::Zero();
  std::optional<Eigen::Vector3d> water_s;
  std::array<double, 4> range_m{};                     ///< vertical, 0: none
  EulerAngles attitude;                                ///< of the instrument, as its own sensors have it
  Eigen::Matrix3d C_bs = Eigen::Matrix3d::Identity();  ///< the alignment the device was told
  double depth_m = 0.0, sound_speed_mps = 1500.0;
  std::uint32_t number = 0;
};

/// Mean over the pairs of opposite beams that both see the bottom; 0 without one.
[[nodiscard]] double mean_range_m(const DvlMeasurement& measurement);

class Dvl {
 public:
  /// C_bs: the mount as the device knows it, for ship coordinates.
  Dvl(const DvlOptions& options, const Eigen::Matrix3d& C_bs, Random random);
  [[nodiscard]] DvlMeasurement measure(const View& view, const Water& water);

 private:
  [[nodiscard]] double beam_range_m(const View& view, const Water& water, std::size_t beam) const;

  DvlOptions options_;
  Eigen::Matrix3d C_bs_;
  Random random_;
  GaussMarkov heading_wander_;
  std::optional<double> last_s_;
  std::uint32_t number_ = 0;
};

/// Unit vectors of the beams in the instrument's axes: 1 starboard, 2 port, 3 forward, 4 aft, all down.
[[nodiscard]] std::array<Eigen::Vector3d, 4> beam_directions(double beam_angle_rad);

}  // namespace leadline::sim
