#include "core/nav/plausibility/unit_check.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "core/types/angle.h"

namespace leadline::nav {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kFeetInAMetre = 1.0 / 0.3048;
constexpr double kPaInAMetre = 10052.0;
constexpr std::uint32_t kLookEvery_s = 4;
constexpr std::size_t kTurnStep_s = 4;
constexpr double kLeastTurn_rad = 3.0 * kRadPerDeg;
constexpr double kCourseSpeed_mps = 1.0;
constexpr std::uint8_t kMovingFor_s = 10;

bool about(double value, double wanted, double share) {
  return std::abs(value - wanted) <= share * std::abs(wanted);
}

/// 57: y is 57 times x; -57: x is 57 times y; -1: opposite; 1: alike; 0: nothing can be said.
int turn_factor(const Regression& r, double least_sd, double least_r2) {
  if (r.count < 10 || std::max(r.sd_x, r.sd_y) < least_sd || r.r2 < least_r2 || r.r2 <= 0.0) return 0;
  if (about(r.slope, kDegPerRad, 0.25)) return 57;
  if (about(r.slope / r.r2, kRadPerDeg, 0.25)) return -57;
  if (about(r.slope, -1.0, 0.25) && r.count >= 30) return -1;
  return about(r.slope, 1.0, 0.25) ? 1 : 0;
}

/// 1: y is in feet and read as metres, -1: y is 0.305 times too small, 2: alike, 0: neither.
int length_factor(const std::optional<double>& ratio) {
  if (!ratio) return 0;
  return about(*ratio, kFeetInAMetre, 0.07) ? 1
         : about(*ratio, 0.3048, 0.07)      ? -1
         : about(*ratio, 1.0, 0.2)          ? 2
                                            : 0;
}

}  // namespace

UnitCheck::UnitCheck(std::span<const SourceInfo> sources, Findings& findings)
    : sources_(sources), findings_(findings), instruments_(sources.size()) {}

void UnitCheck::hear(SourceId source, Kind kind, double value) {
  if (!std::isfinite(value)) return;
  Live& live = instruments_[source].live[kind];
  live.value = value;
  live.fresh = live.known = true;
}

/// An angle that goes on over 360 degrees.
void UnitCheck::turn(SourceId source, Kind kind, double angle_rad) {
  if (!std::isfinite(angle_rad)) return;
  Live& live = instruments_[source].live[kind];
  hear(source, kind,
       live.known ? live.value + Angle::rad(angle_rad - live.last).wrapped_pi().rad() : angle_rad);
  live.last = angle_rad;
}

void UnitCheck::integrate(SourceId source, Kind kind, Time t, double per_second) {
  if (!std::isfinite(per_second)) return;
  Live& live = instruments_[source].live[kind];
  const double dt_s = live.known ? seconds(t - live.at) : 0.0;
  live.at = t;
  if (dt_s >= 0.0 && dt_s <= 3.0) hear(source, kind, live.value + 0.5 * dt_s * (per_second + live.last));
  live.last = per_second;
}

void UnitCheck::take(const Envelope& envelope) {
  if (envelope.source >= instruments_.size()) return;
  const SourceInfo& source = sources_[envelope.source];
  const SourceId id = envelope.source;
  auto& moved = moved_[static_cast<std::size_t>(source.body)];
  if (const auto* compass = std::get_if<Heading>(&envelope.message)) {
    turn(id, heading, compass->heading.rad() - source.mount.heading.rad());
  } else if (const auto* over_ground = std::get_if<Course>(&envelope.message)) {
    if (over_ground->course && over_ground->speed_mps >= kCourseSpeed_mps)
      turn(id, course, over_ground->course->rad());
    moved |= over_ground->speed_mps >= 0.5;
  } else if (const auto* rates = std::get_if<Rates>(&envelope.message)) {
    integrate(id, rate, envelope.valid, rates->rate_z_rps);
  } else if (const auto* imu = std::get_if<ImuSample>(&envelope.message)) {
    if (imu->increments || source.mount.roll != Angle() || source.mount.pitch != Angle()) return;
    integrate(id, gyro, envelope.valid, imu->gyro.z);
    hear(id, accel_roll, std::atan2(-imu->accel.y, -imu->accel.z));
    hear(id, accel_pitch, std::atan2(imu->accel.x, std::hypot(imu->accel.y, imu->accel.z)));
  } else if (const auto* attitude = std::get_if<Attitude>(&envelope.message)) {
    hear(id, roll, attitude->roll.rad());
    hear(id, pitch, attitude->pitch.rad());
  } else if (const auto* below = std::get_if<DepthMeasured>(&envelope.message)) {
    hear(id, depth, below->depth.m);
  } else if (const auto* water = std::get_if<Pressure>(&envelope.message)) {
    hear(id, pressure, water->gauge_pa / kPaInAMetre);
  } else if (const auto* above = std::get_if<AltitudeAboveBottom>(&envelope.message)) {
    hear(id, altitude, above->above_bottom_m);
  } else if (const auto* dvl = std::get_if<DvlVelocity>(&envelope.message)) {
    moved |=
        dvl->valid && dvl->reference == DvlReference::bottom && std::hypot(dvl->x_mps, dvl->y_mps) >= 0.1;
  }
}

void UnitCheck::usbl_depth(SourceId source, double depth_m) { hear(source, usbl, depth_m); }

void UnitCheck::descent(SourceId source, Time t, double down_mps) { integrate(source, sunk, t, down_mps); }

void UnitCheck::sample(Arrival now, EngineOutput& out) {
  for (std::size_t i = 0; i < moved_.size(); ++i) {
    moving_s_[i] = static_cast<std::uint8_t>(std::min(255, moved_[i] ? moving_s_[i] + 1 : 0));
    moved_[i] = false;
  }
  for (auto& instrument : instruments_)
    for (std::size_t kind = 0; kind < kKinds; ++kind) {
      Live& live = instrument.live[kind];
      if (!live.known) continue;
      live.quiet = live.fresh ? std::uint8_t{0} : static_cast<std::uint8_t>(std::min(live.quiet + 1, 200));
      live.fresh = false;
      instrument.tracks[kind].push(live.quiet <= 1 ? live.value : kNaN);
    }
  if (++seconds_ % kLookEvery_s != 0) return;
  for (std::size_t i = 0; i < instruments_.size(); ++i) {
    const auto id = static_cast<SourceId>(i);
    const auto& tracks = instruments_[i].tracks;
    if (tracks[heading].used()) check_heading(id, now, out);
    if (tracks[roll].used()) check_tilts(id, now, out);
    if (tracks[depth].used()) check_depth(id, now, out);
    if (tracks[altitude].used()) check_altitude(id, now, out);
  }
}

template <class Visit>
void UnitCheck::others(Other self, std::initializer_list<Kind> kinds, const Visit& visit) const {
  for (std::size_t i = 0; i < instruments_.size(); ++i) {
    if (sources_[i].body != sources_[self.source].body) continue;
    for (const Kind kind : kinds) {
      const Other other{static_cast<SourceId>(i), kind};
      if ((other.source != self.source || other.kind != self.kind) && track(other).used()) visit(other);
    }
  }
}

std::optional<Angle> UnitCheck::reads_as_radians(SourceId source) const {
  const Instrument& instrument = instruments_[source];
  double low = 1e9, high = -1e9;
  for (std::size_t i = 0; i < SampledTrack::kSeconds; ++i)
    if (const double v = instrument.tracks[heading].at(i); std::isfinite(v))
      low = std::min(low, v), high = std::max(high, v);
  if (low > high || low < -0.2 * kRadPerDeg || high > 6.5 * kRadPerDeg) return std::nullopt;
  return Angle::rad(instrument.live[heading].value);
}

void UnitCheck::check_heading(SourceId source, Arrival now, EngineOutput& out) {
  char text[200];
  const auto name = [&](SourceId id) { return sources_[id].name.c_str(); };
  const auto body = static_cast<std::size_t>(sources_[source].body);
  int alike = 0;
  others({source, heading}, {rate, gyro, heading, course}, [&](Other other) {
    const Regression r = regress(track({source, heading}), track(other), kTurnStep_s);
    const int factor = turn_factor(r, kLeastTurn_rad, 0.9);
    const bool is_rate = other.kind == rate || other.kind == gyro;
    const char* what = other.kind == heading ? "heading" : other.kind == course ? "course" : "turn rate";
    alike += factor == 1;
    if (factor == -57 && reads_as_radians(source)) {
      std::snprintf(
          text, sizeof text,
          "its heading turns 57 times less than the %s of %.24s and stays within 0 to 6.3 deg: it is most "
          "likely in radians and read as degrees",
          what, name(other.source));
      findings_.raise(source, Fault::heading_unit, text, now, out);
    } else if (factor == 57 && r.sd_y > (is_rate ? 90.0 : 60.0) * kRadPerDeg) {
      std::snprintf(
          text, sizeof text,
          "its heading turns 57 times more than the %s of %.24s: it is most likely in degrees and read as "
          "radians",
          what, name(other.source));
      findings_.raise(source, Fault::heading_unit, text, now, out);
    } else if (is_rate && factor != 0 && !findings_.stands(source, Fault::heading_unit)) {
      if (factor == 1) {
        findings_.clear(other.source, Fault::rate, "its turn rate agrees with the heading again", now, out);
      } else {
        std::snprintf(text, sizeof text, "its turn rate is %s the heading of %.24s turns: %s",
                      factor == -1   ? "opposite to what"
                      : factor == 57 ? "57 times less than"
                                     : "57 times more than",
                      name(source),
                      factor == -1   ? "its sign is wrong or it is mounted upside down"
                      : factor == 57 ? "most likely radians read as degrees"
                                     : "most likely degrees read as radians");
        findings_.raise(other.source, Fault::rate, text, now, out);
      }
    }
    if (other.kind != heading) return;
    if (const auto read = reads_as_radians(source); read && moving_s_[body] >= kMovingFor_s) {
      const auto apart = offset(track({source, heading}), track(other));
      const Angle rest = Angle::rad(read->deg() - track(other).at(0)).wrapped_pi();
      if (apart && apart->spread_rad <= 10.0 * kRadPerDeg && std::abs(apart->mean_rad) >= 30.0 * kRadPerDeg &&
          std::abs(rest.deg()) <= 10.0) {
        std::snprintf(
            text, sizeof text,
            "its heading reads %.2f deg, that of %.24s %.0f deg: it is most likely in radians and read as "
            "degrees",
            read->deg(), name(other.source), Angle::rad(track(other).at(0)).wrapped_2pi().deg());
        findings_.raise(source, Fault::heading_unit, text, now, out);
      }
    }
    if (other.source > source) return;
    const auto off = offset(track({source, heading}), track(other));
    if (!off || off->spread_rad > 10.0 * kRadPerDeg) return;
    const double apart_deg = off->mean_rad * kDegPerRad, quarters = std::abs(apart_deg) / 90.0;
    const bool turned =
        std::round(quarters) >= 1.0 && std::abs(quarters - std::round(quarters)) <= 10.0 / 90.0;
    if (turned && moving_s_[body] >= kMovingFor_s && !findings_.stands(source, Fault::heading_unit) &&
        !findings_.stands(other.source, Fault::heading_unit)) {
      std::snprintf(
          text, sizeof text,
          "its heading stays %+.0f deg from that of %.24s: one of the two is mounted turned by %.0f deg "
          "(mount.yaw_deg)",
          apart_deg, name(other.source), 90.0 * std::round(quarters));
      findings_.raise(source, Fault::heading_offset, text, now, out);
    } else if (std::abs(apart_deg) < 45.0) {
      std::snprintf(text, sizeof text, "its heading agrees with that of %.24s again", name(other.source));
      findings_.clear(source, Fault::heading_offset, text, now, out);
    }
  });
  if (alike > 0)
    findings_.clear(source, Fault::heading_unit, "its heading turns as the others do again", now, out);
}

void UnitCheck::check_tilts(SourceId source, Arrival now, EngineOutput& out) {
  char text[200];
  auto& misfits = instruments_[source].misfits;
  bool large = false, small = false, alike = false;
  SourceId witness = source;
  for (const Kind kind : {roll, pitch}) {
    others({source, kind}, {kind, kind == roll ? accel_roll : accel_pitch}, [&](Other other) {
      const Regression r = regress(track({source, kind}), track(other), 1);
      const int factor = turn_factor(r, 0.5 * kRadPerDeg, 0.8);
      if (factor == -57 && r.sd_x < 20.0 * kRadPerDeg) small = true, witness = other.source;
      alike |= factor == 1;
    });
    std::array<double, SampledTrack::kSeconds> turns{};
    std::size_t n = 0;
    const SampledTrack& own = track({source, kind});
    for (std::size_t i = 0; i + 1 < turns.size(); ++i)
      if (const double d = own.at(i) - own.at(i + 1); std::isfinite(d))
        turns[n++] = std::abs(Angle::rad(d).wrapped_pi().rad());
    if (n < 20) continue;
    const auto middle = turns.begin() + static_cast<std::ptrdiff_t>(n / 2);
    std::nth_element(turns.begin(), middle, turns.begin() + static_cast<std::ptrdiff_t>(n));
    large |= *middle > 30.0 * kRadPerDeg;
  }
  misfits = static_cast<std::uint8_t>(large || small ? std::min(misfits + 1, 3) : 0);
  if (misfits >= 2) {
    if (small)
      std::snprintf(
          text, sizeof text,
          "its roll and pitch swing 57 times less than those of %.24s: they are most likely in radians and "
          "read as degrees",
          sources_[witness].name.c_str());
    else
      std::snprintf(
          text, sizeof text,
          "its roll or pitch swings by more than 30 deg/s all the time: they are most likely in degrees and "
          "read as radians");
    findings_.raise(source, Fault::tilt_unit, text, now, out);
  } else if (alike && misfits == 0) {
    findings_.clear(source, Fault::tilt_unit, "its roll and pitch are plausible again", now, out);
  }
}

void UnitCheck::check_depth(SourceId source, Arrival now, EngineOutput& out) {
  char text[200];
  others({source, depth}, {pressure, usbl, depth, sunk}, [&](Other other) {
    if (findings_.stands(other.source, other.kind == sunk ? Fault::velocity : Fault::depth_unit)) return;
    int factor = 0;
    double ratio = 1.0;
    if (other.kind != sunk) {
      const auto values = median_ratio(track({source, depth}), track(other), 5.0);
      factor = length_factor(values);
      ratio = values.value_or(1.0);
    }
    if (factor == 0) {
      const Regression r = regress(track({source, depth}), track(other), 0);
      if (r.count >= 10 && std::max(r.span_x, r.span_y) >= 5.0 && std::min(r.span_x, r.span_y) >= 1.5 &&
          r.r2 >= 0.97)
        factor = length_factor(r.slope), ratio = r.slope;
    }
    // Of two depths alike in kind the later one of the configuration is named.
    if (factor == 0 || (other.kind == depth && other.source > source)) return;
    const char* what = other.kind == pressure ? "pressure"
                       : other.kind == usbl   ? "USBL depth"
                       : other.kind == depth  ? "depth"
                                              : "descent over the DVL";
    if (factor == 2) {
      findings_.clear(source, Fault::depth_unit, "its depth agrees with the others again", now, out);
    } else {
      std::snprintf(text, sizeof text,
                    "its depth is %.2f times the %s of %.24s: most likely %s (or that one is wrong)", ratio,
                    what, sources_[other.source].name.c_str(),
                    factor == 1 ? "feet read as metres" : "metres read as feet");
      findings_.raise(source, Fault::depth_unit, text, now, out);
    }
  });
}

void UnitCheck::check_altitude(SourceId source, Arrival now, EngineOutput& out) {
  char text[200];
  others({source, altitude}, {altitude, depth}, [&](Other other) {
    int factor = 0;
    double ratio = 1.0;
    if (other.kind == altitude) {
      if (other.source > source) return;
      const auto values = median_ratio(track({source, altitude}), track(other), 1.0);
      factor = length_factor(values);
      ratio = values.value_or(1.0);
    } else {
      if (findings_.stands(other.source, Fault::depth_unit)) return;
      const Regression r = regress(track({source, altitude}), track(other), 0);
      if (r.count < 15 || r.span_x < 5.0 || r.r2 < 0.98) return;
      ratio = -r.slope;
      factor = about(ratio, kFeetInAMetre, 0.07) ? 1 : about(ratio, 1.0, 0.2) ? 2 : 0;
    }
    if (factor == 2) {
      findings_.clear(source, Fault::altitude_unit, "its altitude agrees with the others again", now, out);
    } else if (factor != 0) {
      std::snprintf(text, sizeof text, "its altitude %s %.2f times the %s of %.24s: most likely %s",
                    other.kind == altitude ? "is" : "changes by", ratio,
                    other.kind == altitude ? "altitude" : "change of depth",
                    sources_[other.source].name.c_str(),
                    factor == 1 ? "feet read as metres" : "metres read as feet");
      findings_.raise(source, Fault::altitude_unit, text, now, out);
    }
  });
}

}  // namespace leadline::nav
