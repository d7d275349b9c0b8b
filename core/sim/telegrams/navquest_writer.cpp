#include "core/sim/telegrams/navquest_writer.h"

#include <fmt/format.h>

#include <cmath>
#include <iterator>

namespace leadline::sim {
namespace {

/// Nearest hundredth, never -0.
double hundredths(double value) { return std::round(value * 100.0) / 100.0 + 0.0; }

}  // namespace

void write_navquest(const DvlOptions& o, Time, const DvlMeasurement& m, Telegrams& out) {
  auto to = std::back_inserter(out.bytes);
  fmt::format_to(to, "$#NQ.RES 0X0000");
  for (const double range : m.range_m) fmt::format_to(to, " {}", range > 0.0 ? 1 : 0);
  for (const double range : m.range_m) fmt::format_to(to, " {:.2f}", range > 0.0 ? range : -1.0);
  fmt::format_to(to, " 0 0 0 0 0 0 0 0 0 0 0 0");
  const int flag = m.bottom ? 1 : m.water_s ? 2 : 0;
  const Eigen::Vector3d v = flag == 1 ? m.v_s : flag == 2 ? *m.water_s : Eigen::Vector3d::Zero();
  fmt::format_to(to, " {:.1f} {:.1f} {:.1f} {}", -v.x() * 1e3, -v.y() * 1e3, -v.z() * 1e3, flag);
  fmt::format_to(to, " 0 0 0 0 0 0 0 0 0 0 0 0");
  const bool told = o.attitude_told;
  fmt::format_to(to, " {:.2f} {:.2f} {:.2f}", told ? hundredths(m.attitude.roll.deg()) : 0.0,
                 told ? hundredths(m.attitude.pitch.deg()) : 0.0,
                 told ? std::fmod(hundredths(m.attitude.heading.wrapped_2pi().deg()), 360.0) : 0.0);
  const double range_m = mean_range_m(m);
  fmt::format_to(to, " {:.2f} 10.0 0.000 35.0 {:.1f} 0\r\n", range_m > 0.0 ? range_m : -1.0,
                 m.sound_speed_mps);
  out.end();
}

}  // namespace leadline::sim
