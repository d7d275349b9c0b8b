#pragma once

#include <memory>

#include "core/decode/profile.h"
#include "core/flow/decoder.h"

namespace leadline::decode {

/// MAVLink 1 and 2, from a telemetry log (each frame after its time in microseconds) or live,
/// wire-formats 17. ATTITUDE: heading, attitude, rate. GPS_INPUT and GPS_RAW_INT with a 3-D fix: position,
/// course; they are one receiver, so GPS_RAW_INT is not used while GPS_INPUT is heard. SCALED_PRESSURE2 (the
/// sensor in the water): pressure. GLOBAL_POSITION_INT, LOCAL_POSITION_NED and VFR_HUD are not used: they are
/// what the vehicle's own filter makes of the same sensors, and would count them twice; nor RAW_IMU, whose
/// unit is the maker's. Valid at the log's stamp. address: only this system's messages make facts.
[[nodiscard]] std::unique_ptr<Decoder> make_mavlink(const DecoderSettings& settings,
                                                    const ProfileOptions& profile = {});

}  // namespace leadline::decode
