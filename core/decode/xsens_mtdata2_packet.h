#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "core/decode/frame_search.h"
#include "core/types/position.h"
#include "core/types/rotation.h"
#include "core/types/time.h"

namespace leadline::decode {

/// One MTData2 packet, in forward-starboard-down and north-east-down.
struct XsensPacket {
  std::optional<std::uint16_t> counter;
  std::optional<std::uint32_t> ticks;  ///< of 100 us, wraps after 4.97 days
  std::optional<Time> utc;             ///< only where the device calls it valid
  std::optional<EulerAngles> attitude;
  std::optional<Vec3<Instrument>> rate_rps, specific_force_mps2;
  std::optional<Geodetic> position;
  std::optional<std::uint32_t> status;
};

inline constexpr std::uint32_t kXsensSelfTest = 1, kXsensFilterValid = 2, kXsensGnssFix = 4;
inline constexpr std::uint8_t kXsensMtData2 = 0x36;

/// Xbus messages (`FA FF`), checksum verified; both length forms.
[[nodiscard]] FrameStart xsens_start(std::span<const std::uint8_t> rest);
/// The data of a whole message, without its header and checksum.
[[nodiscard]] std::span<const std::uint8_t> xsens_data(std::span<const std::uint8_t> message);

/// data: of an MTData2 message. ENU and NWU have the instrument's axes forward-port-up, NED
/// forward-starboard-down. A quaternion is preferred to Euler angles. Items of unknown kinds are passed over.
/// Gives why the packet is refused: "fields" (a size that does not fit its id), "range" (a number that is
/// none); empty when it is not.
[[nodiscard]] std::string_view read_xsens_packet(std::span<const std::uint8_t> data, XsensPacket& packet);

}  // namespace leadline::decode
