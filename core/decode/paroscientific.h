#pragma once

#include <memory>

#include "core/decode/profile.h"
#include "core/flow/decoder.h"

namespace leadline::decode {

/// Paroscientific Digiquartz (wire-formats 11): '*', two digits of destination (00 is the host), two of the
/// source, which `address` may name, and the absolute pressure in the unit the profile names, m being
/// metres of water of 1000 kg/m3 and standard gravity. Commands and answers hold letters: known and unused.
/// The format has no checksum: a reading beyond 12000 m ("range"), or one that 5 m/s do not reach either from
/// the last one believed or from the one before ("rate"), is refused; what
/// was heard at one instant is not compared.
[[nodiscard]] std::unique_ptr<Decoder> make_paroscientific(const DecoderSettings& settings,
                                                           const ProfileOptions& profile = {});

}  // namespace leadline::decode
