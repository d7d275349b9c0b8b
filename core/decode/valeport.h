#pragma once

#include <memory>
#include <optional>
#include <string_view>

#include "core/decode/nmea0183_fields.h"
#include "core/decode/profile.h"
#include "core/flow/decoder.h"

namespace leadline::decode {

/// Valeport's miniIPS2 (a value and its unit, $PVIPS2, the legacy form, whose date is not a clock) and the
/// rows of miniSVS, SVP and CTD, between commas, semicolons, blanks or tabs as the profile's columns name
/// them (wire-formats 11). A value without a unit has the profile's. Pressure becomes depth by PressureDepth,
/// but a depth the device tells wins. A sound speed of 0 is a probe in air: not told. Only $PVIPS2 has a
/// checksum: elsewhere a line that the stream's end cuts is refused.
[[nodiscard]] std::unique_ptr<Decoder> make_valeport(const DecoderSettings& settings,
                                                     const ProfileOptions& profile = {});

/// What $PVIPS2 says: pressure above the atmosphere it was zeroed at.
struct MiniIps2 {
  std::optional<double> pressure_dbar, depth_m;
};
/// Reads its fields; refusal() of them says why it may not be used.
[[nodiscard]] MiniIps2 read_mini_ips2(nmea0183::Fields& fields);

}  // namespace leadline::decode
