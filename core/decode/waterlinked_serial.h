#pragma once

#include <cstdint>
#include <memory>
#include <string_view>

#include "core/flow/decoder.h"

namespace leadline::decode {

/// Water Linked A50 and A125 on a serial line, protocol 2.2 to 2.8 (wire-formats 6): wrz velocities over the
/// bottom, wrs through the water, wru ranges (told when all four beams of a ping are there), wrp roll and
/// pitch, and the old wrx and wrt. CRC-8 over all before the '*'. wrs answers wct too: that one says whether
/// the device's clock is set. Answers to commands and commands are known and unused. A line whose CRC fails
/// is searched for one that begins inside it.
[[nodiscard]] std::unique_ptr<Decoder> make_waterlinked_serial(const DecoderSettings& settings);

/// CRC-8, polynomial 0x07, start 0, nothing reflected.
[[nodiscard]] std::uint8_t waterlinked_crc(std::string_view text);

}  // namespace leadline::decode
