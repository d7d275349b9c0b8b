#include "core/sim/telegrams/waterlinked_writer.h"

#include <fmt/format.h>

#include <cmath>
#include <iterator>

#include "core/decode/waterlinked_serial.h"
#include "core/sim/telegrams/sentence.h"

namespace leadline::sim {
namespace {

constexpr double kBeamAngle_deg = 22.5;

/// Along the beam; -1: none.
double slant_m(double vertical_m) {
  return vertical_m > 0.0 ? vertical_m / std::cos(kBeamAngle_deg * kRadPerDeg) : -1.0;
}

struct Velocity {
  Eigen::Vector3d v_s;
  bool valid;
  double variance_m2ps2, altitude_m;
};

Velocity bottom_of(const DvlOptions& o, const DvlMeasurement& m) {
  const double altitude_m = mean_range_m(m);
  return {m.bottom ? m.v_s : Eigen::Vector3d::Zero(), m.bottom, o.noise_mps * o.noise_mps,
          m.bottom && altitude_m > 0.0 ? altitude_m : -1.0};
}

Velocity water_of(const DvlOptions& o, const DvlMeasurement& m) {
  return {*m.water_s, true, o.water_noise_mps * o.water_noise_mps, -1.0};
}

std::int64_t microseconds(Time t) { return rounded(t, 6).ns / 1000; }

/// Adds CRC and CR LF to what was written since `begin`.
void seal(Telegrams& out, std::size_t begin) {
  const auto crc = decode::waterlinked_crc(std::string_view(out.bytes).substr(begin));
  fmt::format_to(std::back_inserter(out.bytes), "*{:02x}\r\n", crc);
  out.end();
}

void velocity_line(bool water, const Velocity& v, Time device, Telegrams& out) {
  const std::size_t begin = out.bytes.size();
  const auto us = microseconds(device);
  fmt::format_to(std::back_inserter(out.bytes), "{},{:.3f},{:.3f},{:.3f},{},", water ? "wrs" : "wrz",
                 v.v_s.x() + 0.0, v.v_s.y() + 0.0, v.v_s.z() + 0.0, v.valid ? 'y' : 'n');
  if (!water) fmt::format_to(std::back_inserter(out.bytes), "{:.2f},", v.altitude_m);
  fmt::format_to(std::back_inserter(out.bytes), "{:.3f},{:.3g};0;0;0;{:.3g};0;0;0;{:.3g},{},{},100.00,0",
                 std::sqrt(v.variance_m2ps2), v.variance_m2ps2, v.variance_m2ps2, v.variance_m2ps2, us, us);
  seal(out, begin);
}

void velocity_object(std::string_view type, const Velocity& v, const DvlMeasurement& m, Time device,
                     Telegrams& out) {
  const auto us = microseconds(device);
  auto to = std::back_inserter(out.bytes);
  fmt::format_to(to,
                 R"({{"time":100.0,"vx":{:.3f},"vy":{:.3f},"vz":{:.3f},"fom":{:.3f},)"
                 R"("covariance":[[{:.3g},0,0],[0,{:.3g},0],[0,0,{:.3g}]],"altitude":{:.2f},"transducers":[)",
                 v.v_s.x() + 0.0, v.v_s.y() + 0.0, v.v_s.z() + 0.0, std::sqrt(v.variance_m2ps2),
                 v.variance_m2ps2, v.variance_m2ps2, v.variance_m2ps2, v.altitude_m);
  for (std::size_t i = 0; i < m.range_m.size(); ++i)
    fmt::format_to(to,
                   R"({}{{"id":{},"velocity":0.0,"distance":{:.2f},"rssi":-40,"nsd":-95,"beam_valid":{}}})",
                   i == 0 ? "" : ",", i, slant_m(m.range_m[i]), m.range_m[i] > 0.0);
  fmt::format_to(to,
                 R"(],"velocity_valid":{},"status":0,"time_of_validity":{},"time_of_transmission":{},)"
                 R"("format":"json_v3.1","type":"{}"}})",
                 v.valid, us, us, type);
  out.bytes += "\n";
  out.end();
}

}  // namespace

void write_waterlinked_serial(const DvlOptions& o, Time device, const DvlMeasurement& m, Telegrams& out) {
  velocity_line(false, bottom_of(o, m), device, out);
  for (std::size_t i = 0; i < m.range_m.size(); ++i) {
    const std::size_t begin = out.bytes.size();
    fmt::format_to(std::back_inserter(out.bytes), "wru,{},0.000,{:.2f},-40,-95", i, slant_m(m.range_m[i]));
    seal(out, begin);
  }
  if (m.water_s) velocity_line(true, water_of(o, m), device, out);
  if (!o.attitude_told) return;
  const std::size_t begin = out.bytes.size();
  const auto us = microseconds(device);
  fmt::format_to(std::back_inserter(out.bytes), "wrp,{}.{:06d},0.00,0.00,0.00,0.0,{:.2f},{:.2f},0.00,0",
                 us / 1'000'000, us % 1'000'000, m.attitude.roll.deg(), m.attitude.pitch.deg());
  seal(out, begin);
}

void write_waterlinked_json(const DvlOptions& o, Time device, const DvlMeasurement& m, Telegrams& out) {
  velocity_object("velocity", bottom_of(o, m), m, device, out);
  if (m.water_s) velocity_object("velocity_water", water_of(o, m), m, device, out);
  if (!o.attitude_told) return;
  const auto us = microseconds(device);
  fmt::format_to(std::back_inserter(out.bytes),
                 R"({{"ts":{}.{:06d},"x":0.0,"y":0.0,"z":0.0,"std":0.0,"roll":{:.2f},"pitch":{:.2f},)"
                 R"("yaw":0.0,"type":"position_local","status":0,"format":"json_v3.1"}})",
                 us / 1'000'000, us % 1'000'000, m.attitude.roll.deg(), m.attitude.pitch.deg());
  out.bytes += "\n";
  out.end();
}

}  // namespace leadline::sim
