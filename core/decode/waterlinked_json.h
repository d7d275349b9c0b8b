#pragma once

#include <memory>

#include "core/flow/decoder.h"

namespace leadline::decode {

/// Water Linked A50 and A125 over TCP, one JSON object a line (wire-formats 6, format json_v3): velocity,
/// velocity_water, position_local (roll and pitch); response is known and unused. A line has less than 64 KiB
/// and at most 8 objects and lists inside each other; members that are not known are passed over; one that is
/// there twice, or of another type, refuses its line ("fields"), and so does what is no JSON ("syntax").
/// Without velocity_valid a velocity is not valid.
[[nodiscard]] std::unique_ptr<Decoder> make_waterlinked_json(const DecoderSettings& settings);

}  // namespace leadline::decode
