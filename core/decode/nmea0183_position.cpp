// Positions of GNSS receivers: GGA, GNS, RMC, GLL, and GST, which says how good they are.

#include <algorithm>

#include "core/decode/nmea0183_sentences.h"
#include "core/decode/number.h"

namespace leadline::decode::nmea0183 {
namespace {

constexpr double kHdopUnknown = 99.99, kHighestHdop = 9999.0;
constexpr double kFastest = 1e5;  // knots; faster than any orbit

/// A position as its sentence gives it.
struct Candidate {
  Candidate(PositionKind k, std::optional<std::int64_t> tod) : kind(k), time_of_day(tod) {}
  PositionKind kind;
  std::optional<std::int64_t> time_of_day;
  std::optional<Time> time;
  std::optional<Geodetic> position;
  GnssFix fix;
};

void see(Memory& memory, PositionKind kind) {
  memory.position_seen[static_cast<std::size_t>(kind)] = memory.moment;
}

bool better_kind_seen(const Memory& memory, PositionKind kind) {
  for (std::size_t i = 0; i < static_cast<std::size_t>(kind); ++i)
    if (memory.fresh(memory.position_seen[i])) return true;
  return false;
}

bool given_already(const Memory& memory, const Candidate& c) {
  if (!c.time_of_day || c.time_of_day != memory.fix_time_of_day) return false;
  return !c.time || !memory.fix_time || c.time == memory.fix_time;
}

void add_sigmas(const Memory& memory, const Candidate& c, GnssFix& fix) {
  const auto& gst = memory.gst;
  if (!gst || !((c.time_of_day && c.time_of_day == gst->time_of_day) || memory.fresh(gst->moment))) return;
  fix.sd_north_m = gst->north_m;
  fix.sd_east_m = gst->east_m;
  fix.sd_down_m = gst->down_m;
}

/// One fix an epoch: gives it out unless a better kind speaks for this epoch or this UTC was given already.
void tell_fix(Reading& r, Candidate& c) {
  Memory& memory = r.memory;
  if (!c.position || better_kind_seen(memory, c.kind) || given_already(memory, c)) return;
  c.fix.position = *c.position;
  add_sigmas(memory, c, c.fix);
  memory.fix_time_of_day = c.time_of_day;
  memory.fix_time = c.time;
  r.out.fact(c.time, c.fix);
}

/// estimated: those are taken too.
std::optional<GnssQuality> quality_of_gga(std::uint32_t quality, bool estimated) {
  switch (quality) {
    case 1:
      return GnssQuality::autonomous;
    case 2:
      return GnssQuality::differential;
    case 3:
      return GnssQuality::precise;
    case 4:
      return GnssQuality::rtk_fixed;
    case 5:
      return GnssQuality::rtk_float;
    case 6:
      return estimated ? std::optional(GnssQuality::unknown) : std::nullopt;
    case 9:
      return GnssQuality::unknown;
    default:
      return std::nullopt;  // none, manual, simulator
  }
}

/// Of a mode letter (NMEA 2.3 and later); empty when it is no GNSS position.
std::optional<GnssQuality> quality_of_mode(char mode, bool estimated) {
  switch (mode) {
    case '\0':
      return GnssQuality::unknown;  // older than modes
    case 'A':
      return GnssQuality::autonomous;
    case 'D':
      return GnssQuality::differential;
    case 'P':
      return GnssQuality::precise;
    case 'R':
      return GnssQuality::rtk_fixed;
    case 'F':
      return GnssQuality::rtk_float;
    case 'E':
      return estimated ? std::optional(GnssQuality::unknown) : std::nullopt;
    default:
      return std::nullopt;  // manual, simulator, none
  }
}

/// The best of one letter a system.
std::optional<GnssQuality> quality_of_systems(std::string_view modes, bool estimated) {
  for (const char best : {'R', 'F', 'P', 'D', 'A', 'E'})
    if (modes.find(best) != std::string_view::npos) return quality_of_mode(best, estimated);
  return std::nullopt;
}

void read_quality_figures(Fields& f, int satellites, int hdop, GnssFix& fix) {
  if (const auto n = f.digits(satellites, 255)) fix.satellites = static_cast<std::uint8_t>(*n);
  if (const auto value = f.number(hdop, 0.0, kHighestHdop); value && *value < kHdopUnknown) fix.hdop = value;
}

void read_height(Fields& f, int altitude, int separation, GnssFix& fix) {
  const auto above_geoid = f.number(altitude), geoid = f.number(separation);
  if (above_geoid && geoid) fix.height = EllipsoidHeight{*above_geoid + *geoid};
}

/// A sentence that says itself that it holds no position to go by. What else it holds are placeholders (real
/// ones put 89 degrees 60 minutes there), so they are not judged.
Verdict note_no_position(Fields& f, Reading& r, PositionKind kind, std::optional<std::int64_t> time_of_day) {
  if (!f.refusal().empty()) return refused(f.refusal());
  (void)r.dated(time_of_day);
  see(r.memory, kind);
  return decoded();
}

/// GGA, GNS and GLL, which hold a time without a date.
Verdict tell_epoch(const Fields& f, Reading& r, Candidate& c, std::string_view telegram) {
  if (!f.refusal().empty()) return refused(f.refusal());
  c.time = r.dated(c.time_of_day);
  see(r.memory, c.kind);
  r.tell_clock(telegram, c.time);
  tell_fix(r, c);
  return decoded();
}

/// ddmmyy; empty, with the refusal noted, when it is no date.
std::optional<Time> read_date(Fields& f, int n, const Reading& r) {
  const std::string_view text = f.text(n);
  const auto value = parse_digits(text);
  if (!value || text.size() != 6) {
    f.refuse(kReasonFields);
    return std::nullopt;
  }
  const int ddmmyy = static_cast<int>(*value);
  const auto midnight = from_civil({.year = r.memory.dating.full_year(ddmmyy % 100, r.arrival),
                                    .month = ddmmyy / 100 % 100,
                                    .day = ddmmyy / 10000});
  if (!midnight) f.refuse(kReasonRange);
  return midnight;
}

}  // namespace

Verdict read_gga(Fields& f, Reading& r) {
  f.require(6);
  Candidate c(PositionKind::gga, f.time_of_day(1));
  const auto figure = f.digits(6, 9);
  const auto quality = figure ? quality_of_gga(*figure, r.profile.estimated_positions) : std::nullopt;
  if (!quality) return note_no_position(f, r, c.kind, c.time_of_day);
  if (!c.time_of_day) f.refuse(kReasonFields);
  c.fix.quality = *quality;
  c.position = f.position(2);
  read_quality_figures(f, 7, 8, c.fix);
  read_height(f, 9, 11, c.fix);
  return tell_epoch(f, r, c, "GGA");
}

Verdict read_gns(Fields& f, Reading& r) {
  f.require(6);
  Candidate c(PositionKind::gns, f.time_of_day(1));
  const auto quality = quality_of_systems(f.text(6), r.profile.estimated_positions);
  if (!quality) return note_no_position(f, r, c.kind, c.time_of_day);
  if (!c.time_of_day) f.refuse(kReasonFields);
  c.fix.quality = *quality;
  c.position = f.position(2);
  read_quality_figures(f, 7, 8, c.fix);
  read_height(f, 9, 10, c.fix);
  return tell_epoch(f, r, c, "GNS");
}

Verdict read_rmc(Fields& f, Reading& r) {
  f.require(9);
  Candidate c(PositionKind::rmc, f.time_of_day(1));
  const auto quality = quality_of_mode(f.letter(12), r.profile.estimated_positions);
  if (f.letter(2) != 'A' || !quality) return note_no_position(f, r, c.kind, c.time_of_day);
  if (!c.time_of_day) f.refuse(kReasonFields);
  c.fix.quality = *quality;
  c.position = f.position(3);
  const auto speed_kn = f.number(7, 0.0, kFastest);
  const auto course = f.heading(8);
  const auto midnight = read_date(f, 9, r);
  if (!f.refusal().empty()) return refused(f.refusal());
  c.time = r.learn("RMC", *midnight + Duration(*c.time_of_day));
  see(r.memory, c.kind);
  tell_fix(r, c);
  if (speed_kn && !r.memory.fresh(r.memory.vtg_seen))
    r.out.fact(c.time, Course{*speed_kn * kMpsPerKnot, course, {}, {}});
  return decoded();
}

Verdict read_gll(Fields& f, Reading& r) {
  f.require(4);
  Candidate c(PositionKind::gll, f.time_of_day(5));
  const auto quality = quality_of_mode(f.letter(7), r.profile.estimated_positions);
  const char status = f.letter(6);  // units older than statuses send none
  if ((status != 'A' && status != '\0') || !quality) return note_no_position(f, r, c.kind, c.time_of_day);
  c.fix.quality = *quality;
  c.position = f.position(1);
  return tell_epoch(f, r, c, "GLL");
}

Verdict read_gst(Fields& f, Reading& r) {
  f.require(8);
  Memory::Sigmas s;
  s.time_of_day = f.time_of_day(1);
  const auto positive = [&](int n) {
    auto sigma = f.number(n);
    if (sigma && *sigma <= 0.0) sigma.reset();
    return sigma;
  };
  s.north_m = positive(6);
  s.east_m = positive(7);
  s.down_m = positive(8);
  const auto major = positive(3), minor = positive(4);
  if (!s.north_m && !s.east_m && major && minor) s.north_m = s.east_m = std::max(*major, *minor);
  if (!f.refusal().empty()) return refused(f.refusal());
  (void)r.dated(s.time_of_day);
  if (r.arrival || s.time_of_day) s.moment = r.memory.moment;
  r.memory.gst = s;
  return decoded();
}

}  // namespace leadline::decode::nmea0183
