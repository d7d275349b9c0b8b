#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "core/decode/frame_search.h"
#include "core/types/time.h"

namespace leadline::decode {

/// One ping of a Nortek DVL, whatever form it was sent in. What the device marks as invalid is empty or 0.
struct NortekPing {
  bool water = false;
  std::optional<Time> trigger;  ///< of the device's clock
  double delay_s = 0.0;         ///< DT1: from the trigger to the middle of the echo
  struct Velocity {
    double x_mps = 0.0, y_mps = 0.0, z_mps = 0.0;
  };
  std::optional<Velocity> velocity;
  std::optional<double> sd_mps;        ///< figure of merit
  std::array<double, 4> distance_m{};  ///< vertical, 0: no echo
  std::optional<double> sound_speed_mps, pressure_bar;
};

/// What became of one telegram: a ping, or why there is none.
struct NortekVerdict {
  ByteClass byte_class = ByteClass::refused;
  std::string_view reason;
  NortekPing ping{};
};

inline constexpr std::size_t kNortekHeader = 10, kNortekRecord = 212;
inline constexpr std::uint8_t kNortekBottomTrack = 0x1B, kNortekWaterTrack = 0x1D;
/// Where the fields of a DF21 record are, from its data's start (36 in all known versions).
inline constexpr std::size_t kNortekDataStart = 36;

/// 0xB58C plus the little-endian words; an odd last byte counts as the upper half of one.
[[nodiscard]] std::uint16_t nortek_checksum(std::span<const std::uint8_t> bytes);

/// AD2CP frames (`A5 0A`), both checksums verified, and lines that begin with $PNOR.
[[nodiscard]] FrameStart nortek_start(std::span<const std::uint8_t> rest, bool ended);

/// frame: a whole AD2CP frame whose checksums hold. Only bottom and water track (DF21, DF22) make pings.
[[nodiscard]] NortekVerdict read_nortek_record(std::span<const std::uint8_t> frame);

/// fields: a sentence between its $ and its checksum. PNORBT6 to 9 and PNORWT6 to 9 make pings.
[[nodiscard]] NortekVerdict read_nortek_sentence(std::string_view fields);

}  // namespace leadline::decode
