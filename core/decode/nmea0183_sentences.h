#pragma once

// The sentences that make facts: one reader each, in the file of its family.

#include <array>
#include <cstdint>
#include <cstdlib>
#include <optional>
#include <string_view>

#include "core/decode/nmea0183_clock.h"
#include "core/decode/nmea0183_fields.h"
#include "core/decode/profile.h"
#include "core/flow/decoder.h"

namespace leadline::decode::nmea0183 {

/// How long one sentence speaks for its neighbours: a date, a sigma, a better sentence of the same epoch.
inline constexpr std::int64_t kFresh = 5'000'000'000;

/// Position sentences of one epoch, best first.
enum class PositionKind : std::uint8_t { gga, gns, rmc, gll };

/// What earlier sentences of the stream left for later ones. Moments are arrivals, or the device's time where
/// a plain stream has none: only differences count.
struct Memory {
  explicit Memory(std::optional<Time> host) : dating(host) {}

  Dating dating;
  bool rollover_told = false;
  std::optional<std::int64_t> moment;  ///< of the newest sentence that knows one

  std::array<std::optional<std::int64_t>, 4> position_seen;  ///< by PositionKind
  std::optional<std::int64_t> fix_time_of_day;               ///< of the newest fix given out
  std::optional<Time> fix_time;
  std::optional<std::int64_t> vtg_seen;

  struct Sigmas {
    std::optional<std::int64_t> time_of_day, moment;
    std::optional<double> north_m, east_m, down_m;
  };
  std::optional<Sigmas> gst;

  struct Tilts {
    std::optional<Angle> roll, pitch;
    std::optional<Arrival> arrival;
  };
  Tilts xdr;  ///< the half of an attitude that waits for the other

  bool seapath_heading_invalid = false, seapath_tilt_invalid = false;

  [[nodiscard]] bool fresh(std::optional<std::int64_t> seen) const {
    return seen && moment && std::abs(*moment - *seen) <= kFresh;
  }
};

/// One sentence being read.
struct Reading {
  const DecoderSettings& settings;
  const ProfileOptions& profile;
  Memory& memory;
  std::optional<Arrival> arrival;
  DecoderOutput& out;

  /// The instant of a time of day, as Dating finds it.
  std::optional<Time> dated(std::optional<std::int64_t> time_of_day_ns);
  /// A full date and time: gives the ClockReading; empty when the date is not to be used.
  std::optional<Time> learn(std::string_view telegram, Time full);
  void tell_clock(std::string_view telegram, std::optional<Time> instant);
  /// The reference of a heading that does not say itself that it is magnetic.
  [[nodiscard]] HeadingReference heading_reference() const {
    return settings.heading_magnetic ? HeadingReference::magnetic_north : HeadingReference::true_north;
  }
};

/// What became of a sentence; kind is set where the address alone does not tell it.
struct Verdict {
  ByteClass byte_class = ByteClass::decoded;
  std::string_view reason;
  std::string_view kind;
};
inline Verdict decoded(std::string_view kind = {}) { return {ByteClass::decoded, {}, kind}; }
inline Verdict unused(std::string_view kind = {}) { return {ByteClass::unused, {}, kind}; }
inline Verdict refused(std::string_view reason, std::string_view kind = {}) {
  return {ByteClass::refused, reason, kind};
}

/// Reads one sentence: facts go out only when all of it was legal.
using SentenceReader = Verdict (*)(Fields& fields, Reading& reading);

// nmea0183_clock.cpp
Verdict read_zda(Fields& f, Reading& r);
// nmea0183_position.cpp
Verdict read_gga(Fields& f, Reading& r);
Verdict read_gns(Fields& f, Reading& r);
Verdict read_rmc(Fields& f, Reading& r);
Verdict read_gll(Fields& f, Reading& r);
Verdict read_gst(Fields& f, Reading& r);
// nmea0183_velocity.cpp
Verdict read_vtg(Fields& f, Reading& r);
Verdict read_vbw(Fields& f, Reading& r);
Verdict read_vlw(Fields& f, Reading& r);
Verdict read_puhaw(Fields& f, Reading& r);
// nmea0183_heading.cpp
Verdict read_hdt(Fields& f, Reading& r);
Verdict read_ths(Fields& f, Reading& r);
Verdict read_hdm(Fields& f, Reading& r);
Verdict read_hdg(Fields& f, Reading& r);
Verdict read_rot(Fields& f, Reading& r);
// nmea0183_attitude.cpp
Verdict read_xdr(Fields& f, Reading& r);
Verdict read_pashr(Fields& f, Reading& r);
Verdict read_prdid(Fields& f, Reading& r);
Verdict read_psxn(Fields& f, Reading& r);
// nmea0183_depth.cpp
Verdict read_dbt(Fields& f, Reading& r);
Verdict read_dpt(Fields& f, Reading& r);
Verdict read_pvips2(Fields& f, Reading& r);
// nmea0183_usbl.cpp
Verdict read_psimssb(Fields& f, Reading& r);
Verdict read_ptsag(Fields& f, Reading& r);
Verdict read_ptsax(Fields& f, Reading& r);

inline constexpr double kMpsPerKnot = 1852.0 / 3600.0;

}  // namespace leadline::decode::nmea0183
