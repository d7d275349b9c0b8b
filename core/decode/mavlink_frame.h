#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "core/decode/frame_search.h"
#include "core/types/time.h"

namespace leadline::decode {

/// A message this build knows by name; the extra byte of its checksum.
struct MavlinkKind {
  std::uint32_t id;
  std::uint8_t checksum_extra;
  std::string_view name;
};
[[nodiscard]] const MavlinkKind* find_mavlink(std::uint32_t id);

inline constexpr std::size_t kMavlinkStamp =
    8;  ///< big-endian microseconds since 1970 before each frame of a log

/// The parts of one frame that was found whole.
struct MavlinkFrame {
  std::optional<Time> stamp;
  std::uint8_t version = 2, system = 0, component = 0;
  std::uint32_t id = 0;
  std::span<const std::uint8_t> payload;  ///< version 2: without the zeros it may end in
};

/// Frames of version 1 and 2, with (where stamps may be) a log's stamp before them or bare. One of an unknown
/// message cannot be verified: it counts as a frame where the next one begins right behind it.
[[nodiscard]] FrameStart mavlink_start(std::span<const std::uint8_t> rest, bool stamps, bool ended);
[[nodiscard]] MavlinkFrame read_mavlink_frame(std::span<const std::uint8_t> bytes);

/// X.25 checksum (CRC-16/MCRF4XX) over bytes and the message's extra byte.
[[nodiscard]] std::uint16_t mavlink_checksum(std::span<const std::uint8_t> bytes, std::uint8_t extra);

}  // namespace leadline::decode
