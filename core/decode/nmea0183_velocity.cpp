// Velocities: VTG over ground, VBW and the Hawaii ADCP feed's PUHAW,UVH through the water.

#include "core/decode/nmea0183_sentences.h"

namespace leadline::decode::nmea0183 {
namespace {

/// One block of VBW: longitudinal, transverse (starboard positive), status.
struct LogBlock {
  std::optional<double> forward_kn, starboard_kn;
  char status = '\0';
};

LogBlock read_block(Fields& f, int n) {
  LogBlock block{f.number(n), f.number(n + 1), f.letter(n + 2)};
  if (block.status != 'A' && block.status != 'V' && block.status != '\0') f.refuse(kReasonFields);
  return block;
}

DvlVelocity level_velocity(DvlReference reference, DvlFrame frame) {
  DvlVelocity v;
  v.reference = reference;
  v.frame = frame;
  v.tilt_applied = true;
  return v;
}

void tell_block(Reading& r, const LogBlock& block, DvlReference reference) {
  DvlVelocity v = level_velocity(reference, DvlFrame::ship);
  if (block.status == 'A' && block.forward_kn && block.starboard_kn) {
    v.valid = true;
    v.x_mps = *block.forward_kn * kMpsPerKnot;
    v.y_mps = *block.starboard_kn * kMpsPerKnot;
  } else if (block.status != 'V') {
    return;  // this log does not measure against that
  }
  r.out.fact(std::nullopt, v);
}

}  // namespace

Verdict read_vtg(Fields& f, Reading& r) {
  f.require(4);
  const bool lettered = f.text(2) == "T" || f.count() >= 8;  // else the old form of four numbers
  const auto course = f.heading(1);
  const auto knots = f.number(lettered ? 5 : 3, 0.0, 1e9), kmh = f.number(lettered ? 7 : 4, 0.0, 1e9);
  const char mode = lettered ? f.letter(9) : '\0';
  if (!f.refusal().empty()) return refused(f.refusal());
  if (mode == 'N' || mode == 'E' || mode == 'M' || mode == 'S' || (!knots && !kmh)) return decoded();
  r.memory.vtg_seen = r.arrival ? std::optional(r.arrival->ns) : r.memory.moment;
  r.out.fact(std::nullopt, Course{knots ? *knots * kMpsPerKnot : *kmh / 3.6, course, {}, {}});
  return decoded();
}

Verdict read_vbw(Fields& f, Reading& r) {
  f.require(6);
  const LogBlock water = read_block(f, 1), ground = read_block(f, 4);
  if (!f.refusal().empty()) return refused(f.refusal());
  tell_block(r, ground, DvlReference::bottom);
  tell_block(r, water, DvlReference::water);
  return decoded();
}

Verdict read_vlw(Fields& f, Reading&) {
  f.require(4);
  for (const int n : {1, 3, 5, 7}) (void)f.number(n, 0.0, 1e9);
  return f.refusal().empty() ? decoded() : refused(f.refusal());  // distances run: no fact is made of them
}

Verdict read_puhaw(Fields& f, Reading& r) {
  if (f.text(1) != "UVH") return unused();
  f.require(4);
  const auto east_kn = f.number(2), north_kn = f.number(3);
  const auto heading = f.heading(4);
  if (!f.refusal().empty()) return refused(f.refusal());
  if (heading) r.out.fact(std::nullopt, Heading{*heading, r.heading_reference(), {}, {}});
  if (!east_kn || !north_kn) return decoded();
  DvlVelocity v = level_velocity(DvlReference::water, DvlFrame::earth);
  v.valid = true;
  v.x_mps = *north_kn * kMpsPerKnot;
  v.y_mps = *east_kn * kMpsPerKnot;
  if (heading) v.applied = {.heading = *heading, .roll = {}, .pitch = {}, .reference = r.heading_reference()};
  r.out.fact(std::nullopt, v);
  return decoded();
}

}  // namespace leadline::decode::nmea0183
