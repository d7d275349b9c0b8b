#include "core/sim/telegrams/table_writer.h"

#include <fmt/format.h>

#include <cstdlib>
#include <iterator>

namespace leadline::sim {
namespace {

class Row {
 public:
  Row(Telegrams& out, Time t) : out_(out) {
    const std::int64_t s = t.ns / 1'000'000'000, ns = t.ns % 1'000'000'000;
    fmt::format_to(std::back_inserter(out_.bytes), "{}.{:09d}", s, std::abs(ns));
  }
  ~Row() {
    out_.bytes.push_back('\n');
    out_.end();
  }
  Row(const Row&) = delete;
  Row& operator=(const Row&) = delete;

  Row& put(double value) {
    fmt::format_to(std::back_inserter(out_.bytes), ",{}", value);
    return *this;
  }
  template <class Vector>
  Row& put3(const Vector& v) {
    return put(v.x).put(v.y).put(v.z);
  }

 private:
  Telegrams& out_;
};

struct Writer {
  const SensorSetup& sensor;
  Time device;
  Telegrams& out;

  void operator()(const GnssMeasurement& m) const {
    if (!m.fix) return;
    Row row(out, device);
    row.put(m.position.lat.deg()).put(m.position.lon.deg()).put(m.height_m);
    row.put(m.vel_north_mps).put(m.vel_east_mps);
    if (std::get<GnssOptions>(sensor.errors).sigmas_told)
      row.put(m.sd_axis_m).put(m.sd_axis_m).put(m.sd_height_m);
  }
  void operator()(const DvlMeasurement& m) const {
    Row row(out, device);
    row.put(m.bottom ? 1.0 : 0.0).put(m.v_s.x()).put(m.v_s.y()).put(m.v_s.z());
    if (std::get<DvlOptions>(sensor.errors).attitude_told)
      row.put(m.attitude.heading.deg()).put(m.attitude.roll.deg()).put(m.attitude.pitch.deg());
    if (std::get<DvlOptions>(sensor.errors).depth_told) row.put(m.depth_m);
  }
  void operator()(const AttitudeMeasurement& m) const {
    Row row(out, device);
    row.put(m.attitude.heading.deg())
        .put(m.attitude.roll.deg())
        .put(m.attitude.pitch.deg())
        .put(m.rate_z_rps);
    if (std::get<AhrsOptions>(sensor.errors).sigmas_told)
      row.put(m.sd_heading_rad * kDegPerRad).put(m.sd_tilt_rad * kDegPerRad).put(m.sd_tilt_rad * kDegPerRad);
  }
  void operator()(const CompassMeasurement& m) const { Row(out, device).put(m.heading.deg()); }
  void operator()(const ImuSample& m) const { Row(out, device).put3(m.gyro).put3(m.accel); }
  void operator()(const DepthMeasurement& m) const { Row(out, device).put(m.depth_m); }
  void operator()(const AltitudeMeasurement& m) const {
    if (m.above_bottom_m) Row(out, device).put(*m.above_bottom_m);
  }
  void operator()(const UsblMeasurement&) const {}
};

struct Columns {
  using Names = std::vector<std::string>;
  Names operator()(const GnssOptions& o) const {
    Names names{"unix_s", "lat_deg", "lon_deg", "ellipsoid_height_m", "vel_north_mps", "vel_east_mps"};
    if (o.sigmas_told) names.insert(names.end(), {"sd_north_m", "sd_east_m", "sd_down_m"});
    return names;
  }
  Names operator()(const DvlOptions& o) const {
    Names names{"unix_s", "valid", "vel_x_mps", "vel_y_mps", "vel_z_mps"};
    if (o.attitude_told) names.insert(names.end(), {"heading_deg", "roll_deg", "pitch_deg"});
    if (o.depth_told) names.emplace_back("depth_m");
    return names;
  }
  Names operator()(const AhrsOptions& o) const {
    Names names{"unix_s", "heading_deg", "roll_deg", "pitch_deg", "rate_z_rps"};
    if (o.sigmas_told) names.insert(names.end(), {"sd_heading_deg", "sd_roll_deg", "sd_pitch_deg"});
    return names;
  }
  Names operator()(const CompassOptions&) const { return {"unix_s", "magnetic_heading_deg"}; }
  Names operator()(const ImuOptions& o) const {
    if (o.increments)
      return {"unix_s",     "dtheta_x_rad", "dtheta_y_rad", "dtheta_z_rad",
              "dvel_x_mps", "dvel_y_mps",   "dvel_z_mps"};
    return {"unix_s",       "gyro_x_rps",   "gyro_y_rps",  "gyro_z_rps",
            "accel_x_mps2", "accel_y_mps2", "accel_z_mps2"};
  }
  Names operator()(const DepthOptions&) const { return {"unix_s", "depth_m"}; }
  Names operator()(const AltitudeOptions&) const { return {"unix_s", "altitude_above_bottom_m"}; }
  Names operator()(const UsblOptions&) const { return {}; }
};

}  // namespace

std::vector<std::string> table_columns_of(const SensorSetup& sensor) {
  return std::visit(Columns{}, sensor.errors);
}

void write_row(const SensorSetup& sensor, Time device, const Measurement& measurement, Telegrams& out) {
  std::visit(Writer{sensor, device, out}, measurement);
}

}  // namespace leadline::sim
