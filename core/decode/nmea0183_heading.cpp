// Headings and turn rates: HDT, THS, HDM, HDG, ROT.

#include "core/decode/nmea0183_sentences.h"

namespace leadline::decode::nmea0183 {
namespace {

constexpr double kFastestTurn_deg_per_min = 360.0 * 60.0;  // a full turn a second

Verdict tell_heading(const Fields& f, Reading& r, std::optional<Angle> heading, HeadingReference reference) {
  if (!f.refusal().empty()) return refused(f.refusal());
  if (heading) r.out.fact(std::nullopt, Heading{*heading, reference, {}, {}});
  return decoded();
}

}  // namespace

Verdict read_hdt(Fields& f, Reading& r) {
  f.require(1);
  const auto heading = f.heading(1);
  return tell_heading(f, r, heading, r.heading_reference());
}

Verdict read_ths(Fields& f, Reading& r) {
  f.require(2);
  auto heading = f.heading(1);
  const char mode = f.letter(2);
  if (mode != 'A' && mode != 'E') heading.reset();  // manual, simulator, invalid
  return tell_heading(f, r, heading, r.heading_reference());
}

Verdict read_hdm(Fields& f, Reading& r) {
  f.require(1);
  const auto heading = f.heading(1);
  return tell_heading(f, r, heading, HeadingReference::magnetic_north);
}

Verdict read_hdg(Fields& f, Reading& r) {
  f.require(1);
  const auto sensor = f.heading(1);
  const auto deviation = f.directed(2, 'E', 'W'), variation = f.directed(4, 'E', 'W');
  if (!f.refusal().empty()) return refused(f.refusal());
  if (!sensor) return decoded();
  const Angle magnetic = deviation ? (*sensor + *deviation).wrapped_2pi() : *sensor;
  r.out.fact(std::nullopt, Heading{magnetic, HeadingReference::magnetic_north, variation, {}});
  return decoded();
}

Verdict read_rot(Fields& f, Reading& r) {
  f.require(1);
  const auto rate = f.number(1, -kFastestTurn_deg_per_min, kFastestTurn_deg_per_min);
  const char status = f.letter(2);
  if (!f.refusal().empty()) return refused(f.refusal());
  if (rate && status != 'V') r.out.fact(std::nullopt, Rates{*rate / 60.0 * kRadPerDeg});
  return decoded();
}

}  // namespace leadline::decode::nmea0183
