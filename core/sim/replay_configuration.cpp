#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "core/sim/scenario.h"
#include "core/sim/telegrams/table_writer.h"

namespace leadline::sim {
namespace {

class Toml {
 public:
  std::string text;

  void table(std::string_view header) { fmt::format_to(std::back_inserter(text), "\n{}\n", header); }
  void key(std::string_view name, double value) {
    fmt::format_to(std::back_inserter(text), "{} = {}\n", name, value);
  }
  void key(std::string_view name, std::string_view value) {
    fmt::format_to(std::back_inserter(text), "{} = \"{}\"\n", name, value);
  }
  void known(std::string_view name, double value) {
    if (value != 0.0) key(name, value);
  }
};

/// A sigma that an engine may take: what is simulated without error still has some.
double sigma(double value, double least) { return std::max(value, least); }

void write_aiding(const Scenario& scenario, Toml& toml) {
  toml.table("[navigation.aiding]");
  bool gnss = false, usbl = false, dvl = false, depth = false, heading = false;
  for (const auto& sensor : scenario.sensors) {
    if (const auto* o = std::get_if<GnssOptions>(&sensor.errors); o && !std::exchange(gnss, true)) {
      toml.key("gnss_drms_m", sigma(std::hypot(o->drms_m, o->correlated_drms_m), 0.01));
      toml.key("gnss_height_noise_m", sigma(o->height_noise_m, 0.01));
    } else if (const auto* u = std::get_if<UsblOptions>(&sensor.errors); u && !std::exchange(usbl, true)) {
      toml.key("usbl_drms_m", sigma(std::hypot(u->drms_m, u->correlated_drms_m), 0.01));
    } else if (const auto* d = std::get_if<DvlOptions>(&sensor.errors); d && !std::exchange(dvl, true)) {
      toml.key("dvl_noise_mps", sigma(d->noise_mps, 0.001));
    } else if (const auto* p = std::get_if<DepthOptions>(&sensor.errors); p && !std::exchange(depth, true)) {
      toml.key("depth_noise_m", sigma(p->noise_m, 0.01));
    } else if (const auto* a = std::get_if<AhrsOptions>(&sensor.errors);
               a && sensor.options.body == scenario.options.body && !std::exchange(heading, true)) {
      toml.key("heading_noise_deg", sigma(std::hypot(a->heading_noise_deg, a->heading_wander_deg), 0.01));
    }
  }
}

void write_imu(const Scenario& scenario, Toml& toml) {
  for (const auto& sensor : scenario.sensors) {
    const auto* o = std::get_if<ImuOptions>(&sensor.errors);
    if (!o) continue;
    toml.table("[navigation.imu]");
    toml.key("gyro_bias_deg_h", o->gyro_bias_deg_h);
    toml.key("gyro_noise_deg_sqrt_h", o->gyro_noise_deg_sqrt_h);
    toml.key("gyro_scale_ppm", o->gyro_scale_ppm);
    toml.key("accel_bias_mg", o->accel_bias_mg);
    toml.key("accel_noise_ug_sqrt_hz", o->accel_noise_ug_sqrt_hz);
    toml.key("accel_scale_ppm", o->accel_scale_ppm);
    return;
  }
}

void write_initial(const Truth& truth, Toml& toml) {
  toml.table("[navigation.initial]");
  toml.key("lat_deg", truth.position.lat.deg());
  toml.key("lon_deg", truth.position.lon.deg());
  toml.key("depth_m", truth.depth_m);
  toml.key("vel_north_mps", truth.v_n.x());
  toml.key("vel_east_mps", truth.v_n.y());
  toml.key("vel_down_mps", truth.v_n.z());
  toml.key("roll_deg", truth.attitude.roll.deg());
  toml.key("pitch_deg", truth.attitude.pitch.deg());
  toml.key("heading_deg", truth.attitude.heading.deg());
}

void write_source(const SensorSetup& sensor, const std::string& link, Toml& toml) {
  const SensorOptions& o = sensor.options;
  toml.table("[[source]]");
  toml.key("name", o.name);
  if (!link.empty()) toml.key("link", link);
  toml.key("decoder", format_of(sensor));
  const auto* const usbl = std::get_if<UsblOptions>(&sensor.errors);
  toml.key("body", usbl ? usbl->of : o.body);  // a fix is its transponder's, whoever hears it
  const MountOptions& m = sensor.mount;
  if (m.roll_deg != 0 || m.pitch_deg != 0 || m.yaw_deg != 0 || m.x_m != 0 || m.y_m != 0 || m.z_m != 0)
    toml.text += fmt::format(
        "mount = {{ roll_deg = {}, pitch_deg = {}, yaw_deg = {}, x_m = {}, y_m = {}, z_m = {} }}\n",
        m.roll_deg, m.pitch_deg, m.yaw_deg, m.x_m, m.y_m, m.z_m);
  if (usbl) toml.key("address", usbl->transponder);
  if (const auto* compass = std::get_if<CompassOptions>(&sensor.errors); compass && compass->declination_deg)
    toml.key("declination_deg", *compass->declination_deg);
  toml.known("latency_s", o.latency_s);
  if (o.clock_known) toml.known("time_offset_s", -o.clock_offset_s);
  if (format_of(sensor) == "table")
    toml.text += fmt::format("columns = [\"{}\"]\n", fmt::join(table_columns_of(sensor), "\", \""));
}

}  // namespace

std::string replay_configuration(const Scenario& scenario, const Truth& at_start,
                                 std::span<const std::string> links) {
  Toml toml;
  toml.text = fmt::format(
      "# Replays what the scenario \"{}\" says: leadline replay telegrams.tlog --config leadline.toml\n",
      scenario.options.name);
  toml.text += "version = 1\n";
  toml.table("[vehicle]");
  toml.key("name", scenario.options.name);
  toml.table("[navigation]");
  toml.key("engine", scenario.options.engine);
  toml.key("body", scenario.options.body);
  write_aiding(scenario, toml);
  write_imu(scenario, toml);
  if (scenario.options.initial_known) write_initial(at_start, toml);
  for (std::size_t i = 0; i < scenario.sensors.size(); ++i)
    write_source(scenario.sensors[i], i < links.size() ? links[i] : std::string(), toml);
  return std::move(toml.text);
}

}  // namespace leadline::sim
