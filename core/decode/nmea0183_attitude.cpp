// Roll, pitch and heave: XDR, PASHR, PRDID and the Seapath's PSXN.

#include <algorithm>
#include <cmath>

#include "core/decode/nmea0183_sentences.h"
#include "core/decode/number.h"

namespace leadline::decode::nmea0183 {
namespace {

constexpr double kRollLimit_deg = 180.0, kPitchLimit_deg = 90.0;

/// The text before the next comma; `rest` loses both.
std::string_view take_field(std::string_view& rest) {
  const std::size_t comma = rest.find(',');
  const std::string_view field = rest.substr(0, comma);
  rest = comma == std::string_view::npos ? std::string_view{} : rest.substr(comma + 1);
  return field;
}

bool named_in(const std::vector<std::string>& names, std::string_view name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

/// How long one half of an attitude waits for the other where a device sends each in a sentence of its own.
constexpr std::int64_t kHalfWaits = 1'000'000'000;

/// Each half makes one attitude at most.
void pair_tilts(Reading& r, std::optional<Angle>& roll, std::optional<Angle>& pitch) {
  Memory::Tilts& half = r.memory.xdr;
  const bool fresh = !r.arrival || !half.arrival || *r.arrival - *half.arrival <= Duration(kHalfWaits);
  if (fresh && !roll) roll = half.roll;
  if (fresh && !pitch) pitch = half.pitch;
  const bool whole = roll && pitch;
  half = whole ? Memory::Tilts{} : Memory::Tilts{roll, pitch, r.arrival};
}

/// A transducer's angle. Beyond the limit it is none: what a name means is each maker's own choice, and one
/// sends tenths of a degree as "D".
std::optional<Angle> read_tilt(Fields& f, std::string_view value, double limit_deg) {
  if (value.empty()) return std::nullopt;
  const auto degrees = parse_number(value);
  if (!degrees) f.refuse(kReasonFields);
  if (!degrees || std::abs(*degrees) > limit_deg) return std::nullopt;
  return Angle::deg(*degrees);
}

std::optional<Angle> read_sigma(Fields& f, int n) {
  const auto degrees = f.number(n);
  return degrees && *degrees > 0.0 ? std::optional(Angle::deg(*degrees)) : std::nullopt;
}

void tell_attitude(Reading& r, std::optional<Time> time, std::optional<Angle> roll,
                   std::optional<Angle> pitch, std::optional<double> heave_up_m, std::optional<Angle> sd_roll,
                   std::optional<Angle> sd_pitch) {
  if (roll && pitch) r.out.fact(time, Attitude{*roll, *pitch, heave_up_m, sd_roll, sd_pitch});
}

void tell_heading(Reading& r, std::optional<Time> time, std::optional<Angle> heading,
                  std::optional<Angle> sd) {
  if (heading) r.out.fact(time, Heading{*heading, r.heading_reference(), {}, sd});
}

Verdict read_seapath_quality(Fields& f, Reading& r) {
  f.require(5);
  const auto heading = f.digits(4, 2), tilt = f.digits(5, 2);
  (void)f.digits(2, 2);
  (void)f.digits(3, 2);
  if (!f.refusal().empty()) return refused(f.refusal(), "PSXN20");
  r.memory.seapath_heading_invalid = heading == 2u;
  r.memory.seapath_tilt_invalid = tilt == 2u;
  return decoded("PSXN20");
}

Verdict read_seapath_attitude(Fields& f, Reading& r) {
  f.require(5);
  auto roll = f.angle(2, kRollLimit_deg), pitch = f.angle(3, kPitchLimit_deg), heading = f.heading(4);
  auto heave_up_m = f.number(5);
  if (!f.refusal().empty()) return refused(f.refusal(), "PSXN23");
  if (heave_up_m) heave_up_m = -*heave_up_m;  // the Seapath's is positive down
  if (r.memory.seapath_heading_invalid) heading.reset();
  if (r.memory.seapath_tilt_invalid) roll.reset();
  tell_heading(r, std::nullopt, heading, {});
  tell_attitude(r, std::nullopt, roll, pitch, heave_up_m, {}, {});
  return decoded("PSXN23");
}

}  // namespace

Verdict read_xdr(Fields& f, Reading& r) {
  std::optional<Angle> roll, pitch;
  std::string_view rest = f.all();
  while (!rest.empty()) {
    const std::string_view type = take_field(rest), value = take_field(rest), unit = take_field(rest);
    const std::string_view name = take_field(rest);  // empty when the last quadruple is incomplete
    if (type != "A" || unit != "D") continue;
    if (named_in(r.profile.xdr_roll, name)) roll = read_tilt(f, value, kRollLimit_deg);
    if (named_in(r.profile.xdr_pitch, name)) pitch = read_tilt(f, value, kPitchLimit_deg);
  }
  if (!f.refusal().empty()) return refused(f.refusal());
  if (roll || pitch) pair_tilts(r, roll, pitch);
  tell_attitude(r, std::nullopt, roll, pitch, {}, {}, {});
  return decoded();
}

Verdict read_pashr(Fields& f, Reading& r) {
  if (f.text(3) != "T") return unused();  // PASHR,POS and its like are receiver messages
  f.require(6);
  const auto utc = f.time_of_day(1);
  const auto heading = f.heading(2), pitch = f.angle(5, kPitchLimit_deg);
  auto roll = f.angle(4, kRollLimit_deg);
  auto heave_up_m = f.number(6);
  const auto sd_roll = read_sigma(f, 7), sd_pitch = read_sigma(f, 8), sd_heading = read_sigma(f, 9);
  if (!f.refusal().empty()) return refused(f.refusal());
  if (roll && r.profile.pashr_roll_positive == "starboard-up") roll = -*roll;
  if (heave_up_m && r.profile.pashr_heave_positive == "down") heave_up_m = -*heave_up_m;
  const auto time = r.dated(utc);
  tell_heading(r, time, heading, sd_heading);
  tell_attitude(r, time, roll, pitch, heave_up_m, sd_roll, sd_pitch);
  return decoded();
}

Verdict read_prdid(Fields& f, Reading& r) {
  if (f.count() != 3)
    return refused(kReasonFields);  // one maker's form ends in a comma: its order is not known
  const auto pitch = f.angle(1, kPitchLimit_deg), roll = f.angle(2, kRollLimit_deg), heading = f.heading(3);
  if (!f.refusal().empty()) return refused(f.refusal());
  tell_heading(r, std::nullopt, heading, {});
  tell_attitude(r, std::nullopt, roll, pitch, {}, {}, {});
  return decoded();
}

Verdict read_psxn(Fields& f, Reading& r) {
  const std::string_view form = f.text(1);
  if (form == "20") return read_seapath_quality(f, r);
  if (form == "22") return decoded("PSXN22");
  if (form == "23") return read_seapath_attitude(f, r);
  return unused();
}

}  // namespace leadline::decode::nmea0183
