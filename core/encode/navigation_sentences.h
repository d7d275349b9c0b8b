#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "core/encode/telegrams.h"
#include "core/messages/navigation.h"
#include "core/types/time.h"

namespace leadline::encode {

/// What is told of one body. A part that is unknown or too old is left empty by whoever fills this in: it is
/// then told as void, never as good.
struct Told {
  Time now;    ///< of ZDA, and of what is void
  Time valid;  ///< of the solution
  std::optional<Solution> solution;
  std::optional<double> below_transducer_m;  ///< water below an instrument of the body (altitude or sounder)
  std::optional<double> transducer_depth_m;  ///< of that instrument below the surface
  std::optional<double> rate_z_rps;          ///< clockwise positive
};

/// GGA RMC GLL VTG HDT THS ZDA DPT ROT GST.
[[nodiscard]] std::span<const std::string_view> navigation_sentences();

/// One sentence (IEC 61162-1) of talker IN; false: there is no such sentence. Positions to 1e-7 minutes
/// (0.2 mm), speeds to 0.001 kn, headings to 0.01 deg, times to 1 ms.
///
/// A position is good ("A", quality 1) while GNSS or USBL fix it (modes A to D; NMEA has no word for USBL),
/// estimated ("V" with mode E, quality 6, as the standard has it) when dead reckoned (E1), void (V, N, 0, no
/// position) when held (E0) or unknown; quality is empty where the engine does not say how it got it.
/// Satellites, HDOP, height above sea level and geoid are not a solution's and stay empty; course is empty
/// below 0.05 m/s. DPT is the water below the transducer and, as its offset, the transducer's depth: the sum
/// is the depth of the water. GST is the 1-sigma ellipse.
bool write_sentence(std::string_view name, const Told& told, Telegrams& out);

}  // namespace leadline::encode
