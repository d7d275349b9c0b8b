#pragma once

// NMEA that a logging program embeds in PD0 ensembles: 0x2022 (WinRiver II; binary and text) and the older
// text types 0x2100..0x2102 (wire-formats 3, "Embedded NMEA").

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "core/flow/decoder.h"
#include "core/messages/measurements.h"
#include "core/types/time.h"

namespace leadline::decode {

/// One block, judged on its own: at most one of fix, course and depth is there.
struct Pd0Nmea {
  std::string_view kind;
  /// decoded: one fact is below; unused: it says that it has nothing; unknown sentence; refused with a
  /// reason: "nmea size", "nmea body" (it does not begin with `$` or is another sentence), "checksum",
  /// "range".
  ByteClass byte_class = ByteClass::refused;
  std::string_view reason;
  std::size_t length = 0;  ///< of the block, from its type id
  bool binary = false;
  std::optional<Duration> delta;  ///< the ensemble's time minus the block's; the older types give none
  std::optional<std::int64_t> utc_of_day_ns;
  std::optional<GnssFix> fix;
  std::optional<Course> course;
  std::optional<BottomDepth> depth;
};

/// `type`: one data type from its id. Empty when it is no NMEA.
[[nodiscard]] std::optional<Pd0Nmea> read_pd0_nmea(std::span<const std::uint8_t> type);

}  // namespace leadline::decode
