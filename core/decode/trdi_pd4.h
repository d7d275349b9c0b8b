#pragma once

#include <memory>

#include "core/flow/decoder.h"

namespace leadline::decode {

/// Teledyne RDI PD4 (`7D 00`, 47 bytes) and PD5 (`7D 01`, 88 bytes: also depth and attitude), wire-formats
/// 3.1. A frame has one velocity over the bottom and one through the water, in the one frame its
/// configuration byte names; both are the vehicle's own (PD0 has the other sign). Beam coordinates give no
/// velocity, with a warning: the beam angle is not told. No lock: a component is -32768, or fewer than three
/// beams are good. Its clock has no date (wire-formats 1.1); 00:00:00.00 is no clock.
[[nodiscard]] std::unique_ptr<Decoder> make_trdi_pd4(const DecoderSettings& settings);

}  // namespace leadline::decode
