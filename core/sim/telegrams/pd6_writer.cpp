#include "core/sim/telegrams/pd6_writer.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

#include "core/sim/telegrams/sentence.h"
#include "core/types/rotation.h"

namespace leadline::sim {
namespace {

constexpr int kMissing_mmps = -32768;

template <class... Args>
void line(Telegrams& out, fmt::format_string<Args...> format, Args&&... args) {
  fmt::format_to(std::back_inserter(out.bytes), format, std::forward<Args>(args)...);
  out.bytes += "\r\n";
  out.end();
}

/// Forward-starboard-down (north-east-down) as PD6 has it: starboard (east), forward (north), up.
std::array<int, 3> in_mmps(const Eigen::Vector3d& v) {
  const auto mmps = [](double mps) {
    return static_cast<int>(std::clamp<long long>(std::llround(mps * 1e3), -15999, 15999));
  };
  return {mmps(v.y()), mmps(v.x()), mmps(-v.z())};
}

/// The three lines of one velocity, those that the coordinates name; without lock all missing.
void write_velocity(char reference, const DvlOptions& o, const DvlMeasurement& m, const Eigen::Vector3d& v_s,
                    bool good, bool all_beams, Telegrams& out) {
  constexpr std::array<int, 3> kNone{kMissing_mmps, kMissing_mmps, kMissing_mmps};
  const char status = good ? 'A' : 'V';
  if (o.coordinates == "instrument") {
    const auto v = good ? in_mmps(v_s) : kNone;
    const int error = good && all_beams ? 0 : kMissing_mmps;
    line(out, ":{}I,{:+6d},{:+6d},{:+6d},{:+6d},{}", reference, v[0], v[1], v[2], error, status);
  }
  if (o.coordinates != "earth") {
    const Angle yaw = Angle::rad(std::atan2(m.C_bs(1, 0), m.C_bs(0, 0)));
    const Eigen::Vector3d level =
        Rotation<Ned, Instrument>::zyx({m.attitude.roll, m.attitude.pitch, yaw}).matrix() * v_s;
    const auto v = good ? in_mmps(level) : kNone;
    line(out, ":{}S,{:+6d},{:+6d},{:+6d},{}", reference, v[0], v[1], v[2], status);
  }
  const Eigen::Vector3d v_n = Rotation<Ned, Instrument>::zyx(m.attitude).matrix() * v_s;
  const auto v = good ? in_mmps(v_n) : kNone;
  line(out, ":{}E,{:+6d},{:+6d},{:+6d},{}", reference, v[0], v[1], v[2], status);
}

double in_deg(Angle angle) { return std::round(angle.deg() * 100.0) / 100.0 + 0.0; }

}  // namespace

void write_pd6(const DvlOptions& o, Time device, const DvlMeasurement& m, Telegrams& out) {
  if (o.attitude_told)
    line(out, ":SA,{:+6.2f},{:+6.2f},{:6.2f}", in_deg(m.attitude.pitch), in_deg(m.attitude.roll),
         std::fmod(in_deg(m.attitude.heading.wrapped_2pi()), 360.0));
  const Civil c = to_civil(rounded(device, 2));
  line(out, ":TS,{:02d}{:02d}{:02d}{:02d}{:02d}{:02d}{:02d},35.0,+10.0,{:6.1f},{:6.1f},  0", c.year % 100,
       c.month, c.day, c.hour, c.minute, c.second, c.nanosecond / 10'000'000,
       o.depth_told ? std::max(m.depth_m, 0.0) : 0.0, m.sound_speed_mps);
  if (m.water_s) write_velocity('W', o, m, *m.water_s, true, true, out);
  const bool all_beams = std::all_of(m.beam.begin(), m.beam.end(), [](bool b) { return b; });
  write_velocity('B', o, m, m.v_s, m.bottom, all_beams, out);
  line(out, ":BD,{:+12.2f},{:+12.2f},{:+12.2f},{:7.2f},{:6.2f}", 0.0, 0.0, 0.0, mean_range_m(m),
       m.bottom ? 0.0 : 1.0);
}

}  // namespace leadline::sim
