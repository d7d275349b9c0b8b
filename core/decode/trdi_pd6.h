#pragma once

#include <memory>

#include "core/decode/profile.h"
#include "core/flow/decoder.h"

namespace leadline::decode {

/// Teledyne RDI PD6 and PD13 text (wire-formats 4), told ping by ping: from SA or TS to BD or the next start.
/// Of BI, BS and BE the first that is there speaks for the ping: BI needs nothing undone, neither the
/// device's alignment nor its tilts; BS has both in it; BE also its heading. One whose size differs from it
/// by more than 5 mm/s refuses them all. BI of a Water Linked (x forward, z down) is known by BS being its
/// mirror, unless the profile names the axes. The telegram has no checksum: damage inside a ping refuses what
/// follows in it ("group"). Not told: what is all zero in SA, depth, water lines (not filled) and a range
/// while BD counts seconds since the last lock.
[[nodiscard]] std::unique_ptr<Decoder> make_trdi_pd6(const DecoderSettings& settings,
                                                     const ProfileOptions& profile = {});

}  // namespace leadline::decode
