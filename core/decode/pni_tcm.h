#pragma once

#include <cstdint>
#include <memory>
#include <span>

#include "core/decode/profile.h"
#include "core/flow/decoder.h"

namespace leadline::decode {

/// PNI TCM, TRAX and FieldForce binary frames, wire-formats 9. There is no sync byte: the search slides one
/// byte until a CRC-16/XMODEM holds, and 100 ms of silence in arrival time end what was pending. Headings are
/// magnetic: a compass knows no other north unless it is told its declination. A distorted field is told as
/// Health when it begins. Known and not used: acceleration, magnetic field, gyro, quaternion. No time.
[[nodiscard]] std::unique_ptr<Decoder> make_pni_tcm(const DecoderSettings& settings,
                                                    const ProfileOptions& profile = {});

/// CRC-16/XMODEM: polynomial 0x1021, start 0; "123456789" has 0x31C3.
[[nodiscard]] std::uint16_t crc16_xmodem(std::span<const std::uint8_t> bytes);

}  // namespace leadline::decode
