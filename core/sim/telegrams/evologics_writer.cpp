#include "core/sim/telegrams/evologics_writer.h"

#include <fmt/format.h>

#include <cmath>

namespace leadline::sim {

void write_evologics(Time device, const UsblMeasurement& m, Telegrams& out) {
  if (!m.reply) return;
  constexpr double kSoundSpeed_mps = 1500.0;
  constexpr Duration kAge = std::chrono::milliseconds(4);
  const auto stamp = [](Time t) {
    const std::int64_t us = (t.ns + 500) / 1000;
    return fmt::format("{}.{:06d}", us / 1'000'000, us % 1'000'000);
  };
  const double north = m.ne_m.x(), east = m.ne_m.y(), up = -m.depth_m;
  const double yaw = -m.heading.wrapped_pi().rad(), c = std::cos(yaw), s = std::sin(yaw);  // in ENU
  const double range_m = std::hypot(north, east, up);
  const std::string body = fmt::format(
      "USBLLONG,{},{},{},{:.4f},{:.4f},{:.4f},{:.4f},{:.4f},{:.4f},0.0000,0.0000,{:.4f},{},-42,130,{:.4f}",
      stamp(device + kAge), stamp(device), m.transponder, c * east + s * north, c * north - s * east, up,
      east, north, up, yaw, std::llround(range_m / kSoundSpeed_mps * 1e6), m.sd_m);
  out.bytes += fmt::format("+++AT:{}:{}\r\n", body.size(), body);
  out.end();
}

}  // namespace leadline::sim
