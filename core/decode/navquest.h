#pragma once

#include <memory>

#include "core/decode/profile.h"
#include "core/flow/decoder.h"

namespace leadline::decode {

/// LinkQuest NavQuest text (wire-formats 7): one line a ping, $#NQ.RES and 46 numbers between blanks. How its
/// checksum is made is not public: a line holds by having exactly these, all legal. The velocity of the
/// instrument is told (x forward, y starboard, z down, turned round where the profile's velocity_sign says
/// that the device sends the bottom's), over the bottom or through the water as its flag says; without either
/// a ping without lock. Roll, pitch and heading that are all zero are not filled. An error code is told when
/// it changes.
[[nodiscard]] std::unique_ptr<Decoder> make_navquest(const DecoderSettings& settings,
                                                     const ProfileOptions& profile = {});

}  // namespace leadline::decode
