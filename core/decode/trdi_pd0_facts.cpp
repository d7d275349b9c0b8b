#include "core/decode/trdi_pd0_facts.h"

#include <array>
#include <cmath>

#include "core/decode/trdi_pd0_geometry.h"
#include "core/types/expect.h"

namespace leadline::decode {
namespace {

using Four = std::array<std::optional<double>, 4>;

constexpr double kPaPerDecapascal = 10.0;
constexpr double kFineMps = 1e-5;         // 0x5803 counts 0.01 mm/s
constexpr double kRoundingMps = 1.01e-3;  // 0x0600 may be cut off rather than rounded

std::optional<Time> clock_time(const Pd0VariableLeader::Clock& c, int century) {
  if (c.year > 99 || c.second > 59 || c.hundredths > 99) return std::nullopt;
  Civil civil;
  civil.year = 100 * century + c.year;
  civil.month = c.month, civil.day = c.day;
  civil.hour = c.hour, civil.minute = c.minute, civil.second = c.second;
  civil.nanosecond = c.hundredths * 10'000'000;
  return from_civil(civil);
}

HeadingReference reference_of(const DecoderSettings& settings) {
  return settings.heading_magnetic ? HeadingReference::magnetic_north : HeadingReference::true_north;
}

std::optional<Angle> heading_of(const Pd0VariableLeader& v) {
  if (v.heading_cdeg > 35999) return std::nullopt;
  return Angle::deg(v.heading_cdeg * 0.01);
}

std::optional<Attitude> attitude_of(const Pd0VariableLeader& v) {
  if (v.pitch_cdeg == kPd0Missing || v.roll_cdeg == kPd0Missing) return std::nullopt;
  Attitude attitude;
  attitude.roll = Angle::deg(v.roll_cdeg * 0.01);
  attitude.pitch = Angle::deg(v.pitch_cdeg * 0.01);
  return attitude;
}

Four in_mps(const std::array<std::int16_t, 4>& mmps) {
  Four mps;
  for (std::size_t i = 0; i < 4; ++i)
    if (mmps[i] != kPd0Missing) mps[i] = mmps[i] * 1e-3;
  return mps;
}

Four refined(Four coarse, const std::array<std::int32_t, 4>& fine) {
  for (std::size_t i = 0; i < 4; ++i) {
    const double mps = fine[i] * kFineMps;
    if (coarse[i] && std::abs(mps - *coarse[i]) <= kRoundingMps) coarse[i] = mps;
  }
  return coarse;
}

std::optional<Pd0Velocity> as_components(const Four& mps) {
  if (!mps[0] || !mps[1] || !mps[2]) return std::nullopt;
  return Pd0Velocity{*mps[0], *mps[1], *mps[2], mps[3]};
}

/// The attitude a device used to turn its velocities to the earth's axes.
std::optional<DvlVelocity::Applied> applied_of(const Pd0VariableLeader& v, const DecoderSettings& settings) {
  const auto heading = heading_of(v);
  const auto attitude = attitude_of(v);
  if (!heading || !attitude) return std::nullopt;
  return DvlVelocity::Applied{*heading, attitude->roll, attitude->pitch, reference_of(settings)};
}

DvlVelocity vehicle_velocity(const Pd0Ensemble& e, DvlReference reference, const Four& mps,
                             const DecoderSettings& settings) {
  DvlVelocity velocity;
  velocity.reference = reference;
  std::optional<Pd0Velocity> bottom;
  // Ship (starboard, forward, up) and earth (east, north, up) components stand as a down-facing head's x, y,
  // z do.
  bool up_facing = false;
  switch (e.fixed.coordinates()) {
    case Pd0Coordinates::beam:
      velocity.frame = DvlFrame::instrument;
      up_facing = e.fixed.up_facing();
      bottom = pd0_from_beams(mps, Angle::deg(e.fixed.beam_angle()), e.fixed.convex(),
                              e.fixed.three_beams_allowed());
      break;
    case Pd0Coordinates::instrument:
      velocity.frame = DvlFrame::instrument;
      up_facing = e.fixed.up_facing();
      bottom = as_components(mps);
      break;
    case Pd0Coordinates::ship:
      velocity.frame = DvlFrame::ship;
      velocity.tilt_applied = e.fixed.tilts_used();
      bottom = as_components(mps);
      break;
    case Pd0Coordinates::earth:
      velocity.frame = DvlFrame::earth;
      velocity.tilt_applied = true;
      velocity.applied = applied_of(e.variable, settings);
      bottom = as_components(mps);
      break;
  }
  if (!bottom) return velocity;
  const Vec3<Instrument> v = pd0_vehicle_velocity(*bottom, up_facing);
  velocity.x_mps = v.x, velocity.y_mps = v.y, velocity.z_mps = v.z;
  velocity.error_mps = bottom->error_mps;
  velocity.valid = true;
  return velocity;
}

void tell_bottom_track(const Pd0Ensemble& e, const DecoderSettings& settings, std::optional<Time> time,
                       DecoderOutput& out) {
  BeamRanges ranges;
  for (std::size_t i = 0; i < 4; ++i) ranges.range_m[i] = e.bottom->range_cm[i] * 0.01;
  ranges.beam_angle = Angle::deg(e.fixed.beam_angle());
  out.fact(time, ranges);
  if (const auto altitude = pd0_altitude(*e.bottom)) out.fact(time, *altitude);
  out.fact(time, pd0_bottom_velocity(e, settings));
  if (const auto water = pd0_water_velocity(e, settings)) out.fact(time, *water);
}

}  // namespace

std::optional<Time> pd0_time(const Pd0VariableLeader& leader) {
  if (leader.clock_y2k && leader.century && (*leader.century == 19 || *leader.century == 20))
    if (const auto time = clock_time(*leader.clock_y2k, *leader.century)) return time;
  return clock_time(leader.clock, leader.clock.year >= 80 ? 19 : 20);
}

DvlVelocity pd0_bottom_velocity(const Pd0Ensemble& e, const DecoderSettings& settings) {
  LL_EXPECT(e.bottom.has_value());
  Four mps = in_mps(e.bottom->velocity_mmps);
  if (e.high_resolution) mps = refined(mps, *e.high_resolution);
  return vehicle_velocity(e, DvlReference::bottom, mps, settings);
}

std::optional<DvlVelocity> pd0_water_velocity(const Pd0Ensemble& e, const DecoderSettings& settings) {
  if (!e.bottom || e.bottom->layer_far_dm == 0) return std::nullopt;
  const DvlVelocity water =
      vehicle_velocity(e, DvlReference::water, in_mps(e.bottom->layer_velocity_mmps), settings);
  return water.valid ? std::optional(water) : std::nullopt;
}

std::optional<AltitudeAboveBottom> pd0_altitude(const Pd0BottomTrack& bottom) {
  const auto& r = bottom.range_cm;
  double sum_m = 0.0;
  int beams = 0;
  for (std::size_t i = 0; i < 4; i += 2)
    if (r[i] > 0 && r[i + 1] > 0) sum_m += (r[i] + r[i + 1]) * 0.01, beams += 2;
  return beams > 0 ? std::optional(AltitudeAboveBottom{sum_m / beams}) : std::nullopt;
}

void tell_pd0_facts(const Pd0Ensemble& e, const DecoderSettings& settings, DecoderOutput& out) {
  const auto& v = e.variable;
  const std::optional<Time> time = pd0_time(v);
  if (time) out.fact(time, ClockReading{"ensemble", time->ns, {}});
  if (const auto heading = heading_of(v)) out.fact(time, Heading{*heading, reference_of(settings), {}, {}});
  if (const auto attitude = attitude_of(v)) out.fact(time, *attitude);
  if (v.sound_speed_mps >= 1400 && v.sound_speed_mps <= 1600)
    out.fact(time, SoundSpeed{static_cast<double>(v.sound_speed_mps)});
  // Without a sensor this field is what the operator typed in.
  if (e.fixed.sensor_source & e.fixed.sensors_available & kPd0DepthSensor)
    out.fact(time, DepthMeasured{Depth{v.depth_dm * 0.1}, {}});
  if (v.pressure_dapa && *v.pressure_dapa != 0) out.fact(time, Pressure{*v.pressure_dapa * kPaPerDecapascal});
  if (e.bottom) tell_bottom_track(e, settings, time, out);
}

}  // namespace leadline::decode
