#pragma once

#include <memory>

#include "core/decode/profile.h"
#include "core/flow/decoder.h"

namespace leadline::decode {

/// NMEA 0183 / IEC 61162-1 sentences and the makers' sentences of wire-formats 1.2 to 1.4.
[[nodiscard]] std::unique_ptr<Decoder> make_nmea0183(const DecoderSettings& settings,
                                                     const ProfileOptions& profile = {});

}  // namespace leadline::decode
