#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

#include "core/types/time.h"

namespace leadline::decode {

/// The lines of PD6 and PD13, in their order inside a ping.
enum class Pd6Line : std::uint8_t { SA, TS, RA, WI, WS, WE, WD, BI, BS, BE, BD, HM };
[[nodiscard]] std::string_view pd6_name(Pd6Line line);
/// Which line begins with this text; empty when none does.
[[nodiscard]] std::optional<Pd6Line> pd6_line(std::string_view text);

/// BI BS BE, WI WS WE: as sent, mm/s of the vehicle; the third axis away from the bottom.
struct Pd6Velocity {
  std::array<double, 3> mmps{};
  std::optional<double> error_mmps;  ///< empty in a three-beam solution
  bool good = false;                 ///< status A and no component missing
  [[nodiscard]] bool blank() const { return mmps == std::array<double, 3>{}; }
  [[nodiscard]] double size_mmps() const;
};

/// What the lines of one ping said; empty: not sent.
struct Pd6Ping {
  struct Attitude {
    double pitch_deg = 0.0, roll_deg = 0.0, heading_deg = 0.0;
  };
  struct Ranges {
    double pressure_kpa = 0.0;
    std::array<double, 4> range_dm{};
  };
  struct Distance {
    double range_m = 0.0, since_good_s = 0.0;
  };
  struct Timing {
    std::optional<Civil> clock;  ///< year 0 to 99; empty: no clock
    double depth_m = 0.0, sound_speed_mps = 0.0;
    std::uint32_t built_in_test = 0;
  };
  std::optional<Attitude> attitude;
  std::optional<Timing> timing;
  std::optional<Ranges> ranges;
  std::array<std::optional<Pd6Velocity>, 3> water, bottom;  ///< instrument, ship, earth
  std::optional<Distance> distance;                         ///< over the bottom
  std::array<char, 2> leak{};                               ///< HM: 'L' is a leak
};

/// Reads one line into the ping. Returns why it may not be used: "fields" (their number or form), "range" (a
/// value no device sends); empty when it was read.
[[nodiscard]] std::string_view read_pd6_line(Pd6Line line, std::string_view text, Pd6Ping& ping);

}  // namespace leadline::decode
