#include "core/sim/sensors/dvl.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace leadline::sim {

double mean_range_m(const DvlMeasurement& m) {
  double sum_m = 0.0;
  int beams = 0;
  for (std::size_t i = 0; i < 4; i += 2)
    if (m.beam[i] && m.beam[i + 1]) sum_m += m.range_m[i] + m.range_m[i + 1], beams += 2;
  return beams > 0 ? sum_m / beams : 0.0;
}

std::array<Eigen::Vector3d, 4> beam_directions(double beam_angle_rad) {
  const double s = std::sin(beam_angle_rad), c = std::cos(beam_angle_rad);
  return {{{0, s, c}, {0, -s, c}, {s, 0, c}, {-s, 0, c}}};
}

Dvl::Dvl(const DvlOptions& o, const Eigen::Matrix3d& C_bs, Random random)
    : options_(o),
      C_bs_(C_bs),
      random_(random),
      heading_wander_(o.heading_wander_deg * kRadPerDeg, o.heading_wander_s, random_) {}

/// Along the beam to the sloping bottom; 0 when it points away from it.
double Dvl::beam_range_m(const View& view, const Water& water, std::size_t beam) const {
  const Eigen::Vector3d d_n = view.C_ns * beam_directions(options_.beam_angle_deg * kRadPerDeg)[beam];
  const Eigen::Vector2d slope = water.slope();
  const double closing = d_n.z() - slope.dot(d_n.head<2>());
  const double above_m = view.truth.seabed_m + slope.dot(view.lever_n.head<2>()) - view.depth_m;
  return closing > 1e-6 ? above_m / closing : 0.0;
}

DvlMeasurement Dvl::measure(const View& view, const Water& water) {
  const DvlOptions& o = options_;
  const double t_s = view.truth.t_s, dt_s = t_s - last_s_.value_or(t_s);
  last_s_ = t_s;
  DvlMeasurement m;
  m.number = ++number_;
  m.C_bs = C_bs_;
  m.depth_m = view.depth_m;
  m.sound_speed_mps = water.sound_speed_mps();

  const double above_m = view.truth.seabed_m - view.depth_m;
  const bool in_reach = above_m >= o.min_altitude_m && above_m <= o.max_altitude_m;
  const bool ping_lost = random_.chance(o.ping_loss_share);
  for (std::size_t i = 0; i < 4; ++i) {
    const double slant_m = beam_range_m(view, water, i);
    const double noise = 1.0 + 0.01 * o.range_noise_percent * random_.normal();
    const bool lost = random_.chance(o.beam_loss_share);
    m.beam[i] = in_reach && !ping_lost && !lost && slant_m > 0.0;
    if (m.beam[i]) m.range_m[i] = slant_m * std::cos(o.beam_angle_deg * kRadPerDeg) * noise;
  }
  m.bottom = std::count(m.beam.begin(), m.beam.end(), true) >= 3;

  const auto three = [&] {
    const double x = random_.normal(), y = random_.normal();
    return Eigen::Vector3d(x, y, random_.normal());
  };
  const Eigen::Vector3d v_s = view.C_ns.transpose() * view.v_n;
  const Eigen::Vector3d bias(o.bias_x_mps, o.bias_y_mps, o.bias_z_mps);
  const double noise_mps = std::hypot(o.noise_mps, 0.01 * o.noise_percent * v_s.norm());
  m.v_s = v_s * (1.0 + 0.01 * o.scale_percent) + bias + three() * noise_mps;
  const Eigen::Vector3d water_noise = three() * o.water_noise_mps;
  if (o.water_track) {
    const Eigen::Vector2d current = water.current(t_s, view.depth_m + o.water_layer_m);
    const Eigen::Vector3d past_n = view.v_n - Eigen::Vector3d(current.x(), current.y(), 0.0);
    m.water_s = view.C_ns.transpose() * past_n * (1.0 + 0.01 * o.scale_percent) + water_noise;
  }

  const Eigen::Vector3d tilt_noise = three() * o.tilt_noise_deg * kRadPerDeg;
  const double heading_error =
      heading_wander_.advance(dt_s, random_) + random_.normal() * o.heading_noise_deg * kRadPerDeg;
  m.attitude = plus(view.attitude, {tilt_noise.x(), tilt_noise.y(), heading_error});
  return m;
}

std::span<const Key<DvlOptions>> dvl_keys() {
  using O = DvlOptions;
  static const std::array<Key<O>, 23> keys{{
      {"noise_mps", &O::noise_mps, "one sigma of each axis and ping", 0, 10},
      {"noise_percent", &O::noise_percent, "of the speed, added to that", 0, 100},
      {"scale_percent", &O::scale_percent, "reads this much too high", -50, 50},
      {"bias_x_mps", &O::bias_x_mps, "forward, constant", -10, 10},
      {"bias_y_mps", &O::bias_y_mps, "to starboard", -10, 10},
      {"bias_z_mps", &O::bias_z_mps, "down", -10, 10},
      {"beam_angle_deg", &O::beam_angle_deg, "from the vertical", 1, 60},
      {"beam_loss_share", &O::beam_loss_share, "of each beam's pings without an echo", 0, 1},
      {"ping_loss_share", &O::ping_loss_share, "of the pings without any echo", 0, 1},
      {"min_altitude_m", &O::min_altitude_m, "no bottom lock below", 0, 12000},
      {"max_altitude_m", &O::max_altitude_m, "no bottom lock above", 0, 12000},
      {"range_noise_percent", &O::range_noise_percent, "of each beam's range, one sigma", 0, 50},
      {"water_track", &O::water_track, "velocity through the water too"},
      {"water_layer_m", &O::water_layer_m, "how far below the reference layer is", 0, 1000},
      {"water_noise_mps", &O::water_noise_mps, "one sigma of each axis of that", 0, 10},
      {"heading_noise_deg", &O::heading_noise_deg, "of the device's own compass, white, one sigma", 0, 180},
      {"heading_wander_deg", &O::heading_wander_deg, "correlated, one sigma", 0, 180},
      {"heading_wander_s", &O::heading_wander_s, "its time constant; 0: constant", 0, 1e6},
      {"tilt_noise_deg", &O::tilt_noise_deg, "of its roll and pitch, one sigma", 0, 90},
      {"coordinates", &O::coordinates, "of a PD0 ensemble", 0, 0, {"beam", "instrument", "ship", "earth"}},
      {"high_resolution", &O::high_resolution, "PD0 type 0x5803, 0.01 mm/s"},
      {"attitude_told", &O::attitude_told, "the telegram holds heading, roll and pitch"},
      {"depth_told", &O::depth_told, "the telegram holds a measured depth"},
  }};
  return keys;
}

}  // namespace leadline::sim
