#pragma once

#include <memory>

#include "core/decode/profile.h"
#include "core/flow/decoder.h"

namespace leadline::decode {

/// Nortek DVL, wire-formats 5: AD2CP records DF21 and DF22 of bottom and water track and the sentences
/// PNORBT6 to 9 and PNORWT6 to 9, mixed as they come. Axes forward, starboard, down of the instrument. The
/// status word is believed before the markers; Z is the mean of both beam pairs. Facts are valid at the
/// device's time plus DT1. Known and not used: other records, sentences of one beam (0, 1: a beam alone is no
/// velocity, and the order of their date is not certain) and of speed and direction (3, 4).
[[nodiscard]] std::unique_ptr<Decoder> make_nortek_dvl(const DecoderSettings& settings,
                                                       const ProfileOptions& profile = {});

}  // namespace leadline::decode
