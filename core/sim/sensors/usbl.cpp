#include "core/sim/sensors/usbl.h"

#include <Eigen/Geometry>
#include <array>
#include <cmath>

#include "core/geo/geodesy.h"
#include "core/geo/local_level.h"

namespace leadline::sim {
namespace {

/// The straight line to the transponder in the transceiver's north, east and down.
Eigen::Vector3d line_of_sight(const View& transceiver, const View& transponder) {
  const geo::LocalLevel here(transceiver.position(), EllipsoidHeight{-transceiver.depth_m});
  const auto p = here.forward(transponder.position(), EllipsoidHeight{-transponder.depth_m});
  return {p.x, p.y, p.z};
}

}  // namespace

Eigen::Vector2d UsblMeasurement::ahead_m() const {
  const double c = cos(heading), s = sin(heading);
  return {c * ne_m.x() + s * ne_m.y(), c * ne_m.y() - s * ne_m.x()};
}

Usbl::Usbl(const UsblOptions& o, Random random)
    : options_(o),
      random_(random),
      north_(o.correlated_drms_m * std::sqrt(0.5), o.correlation_s, random_),
      east_(o.correlated_drms_m * std::sqrt(0.5), o.correlation_s, random_) {}

UsblMeasurement Usbl::measure(const View& transceiver, const Truth& other) {
  const UsblOptions& o = options_;
  const double t_s = transceiver.truth.t_s, dt_s = t_s - last_s_.value_or(t_s);
  last_s_ = t_s;
  const View transponder(
      other, {Eigen::Matrix3d::Identity(), {o.transponder_x_m, o.transponder_y_m, o.transponder_z_m}});
  const Eigen::Vector3d line_n = line_of_sight(transceiver, transponder);
  const double range_m = line_n.norm();

  UsblMeasurement m;
  m.transponder = o.transponder;
  const double white_m = std::hypot(o.drms_m, 0.01 * o.range_noise_percent * range_m);
  m.sd_m = std::hypot(white_m, o.correlated_drms_m);

  // The device levels by a motion sensor of its own, whose errors tilt the line of sight.
  const double tilt_rad = o.tilt_noise_deg * kRadPerDeg;
  const Eigen::Vector3d tilt =
      random_.normal3().cwiseProduct(Eigen::Vector3d(tilt_rad, tilt_rad, o.heading_noise_deg * kRadPerDeg));
  const Eigen::Vector3d seen_n = (line_n + tilt.cross(line_n)) * (1.0 + 0.01 * o.sound_speed_error_percent);
  const double sd_axis_m = white_m * std::sqrt(0.5);
  const Eigen::Vector2d white = random_.normal2() * sd_axis_m;
  Eigen::Vector2d wander;
  wander.x() = north_.advance(dt_s, random_);
  wander.y() = east_.advance(dt_s, random_);
  m.outlier = random_.chance(o.outlier_share);
  const double away_m = random_.uniform(o.outlier_from_m, o.outlier_to_m);
  const double towards = random_.uniform(0.0, 2.0 * kPi);
  const double down_error_m = random_.normal() * o.depth_noise_m;
  m.reply = !random_.chance(o.miss_share) && range_m <= o.max_range_m;

  m.ne_m =
      m.outlier
          ? Eigen::Vector2d(line_n.head<2>() + away_m * Eigen::Vector2d(std::cos(towards), std::sin(towards)))
          : Eigen::Vector2d(seen_n.head<2>() + white + wander);
  m.heading = transceiver.truth.attitude.heading +
              Angle::rad(std::atan2(transceiver.C_bs(1, 0), transceiver.C_bs(0, 0)));
  m.depth_m = transponder.depth_m + down_error_m;
  const auto exact = line_n.head<2>();
  const Eigen::Vector2d error = m.ne_m - exact;
  m.position = geo::displaced(transponder.position(), error.x(), error.y(), -transponder.depth_m);
  return m;
}

std::span<const Key<UsblOptions>> usbl_keys() {
  using O = UsblOptions;
  static const std::array<Key<O>, 19> keys{{
      {"of", &O::of, "who carries the transponder", 0, 0, {"vehicle", "target"}},
      {"transponder", &O::transponder, "its name in the telegrams; a number for PTSAG and PTSAX"},
      {"transponder_x_m", &O::transponder_x_m, "forward of that body's reference point", -1000, 1000},
      {"transponder_y_m", &O::transponder_y_m, "to starboard of it", -1000, 1000},
      {"transponder_z_m", &O::transponder_z_m, "below it", -1000, 1000},
      {"drms_m", &O::drms_m, "white error, horizontal 2-D RMS", 0, 1000},
      {"range_noise_percent", &O::range_noise_percent, "white error that grows with the range, 2-D RMS", 0,
       100},
      {"correlated_drms_m", &O::correlated_drms_m, "correlated error (sound speed), 2-D RMS", 0, 1000},
      {"correlation_s", &O::correlation_s, "its time constant; 0: constant", 0, 1e6},
      {"sound_speed_error_percent", &O::sound_speed_error_percent, "of the range, constant", -10, 10},
      {"heading_noise_deg", &O::heading_noise_deg, "of the ship's heading in the device, one sigma", 0, 180},
      {"tilt_noise_deg", &O::tilt_noise_deg, "of the ship's roll and pitch in the device, one sigma", 0, 90},
      {"depth_noise_m", &O::depth_noise_m, "of the transponder's depth, one sigma", 0, 1000},
      {"outlier_share", &O::outlier_share, "of the fixes that are thrown off", 0, 1},
      {"outlier_from_m", &O::outlier_from_m, "outliers are uniform in radius from here", 0, 1e5},
      {"outlier_to_m", &O::outlier_to_m, "to here", 0, 1e5},
      {"miss_share", &O::miss_share, "of the interrogations without a reply", 0, 1},
      {"max_range_m", &O::max_range_m, "no reply from farther away", 1, 1e5},
      {"sigma_told", &O::sigma_told, "the telegram states the true sigma"},
  }};
  return keys;
}

}  // namespace leadline::sim
