#pragma once

// Inside this folder only: the columns of every kind of message, once, for writing and reading alike.
// table_of names its table in schema/; fields(visitor, message) shows each column's name and member.

#include <cmath>
#include <span>
#include <string_view>
#include <type_traits>

#include "core/messages/message.h"

namespace leadline::sessions {

template <class E>
struct Words;  // how an enumeration is spelt in the file, in its order
#define LL_WORDS(E, ...)                                        \
  template <>                                                   \
  struct Words<E> {                                             \
    static constexpr std::string_view kWords[] = {__VA_ARGS__}; \
  }
LL_WORDS(Health::Level, "note", "warning");
LL_WORDS(Alarm::Priority, "caution", "warning", "alarm", "emergency");
LL_WORDS(GnssQuality, "unknown", "autonomous", "differential", "precise", "rtk-fixed", "rtk-float");
LL_WORDS(HeadingReference, "true", "magnetic");
LL_WORDS(DvlReference, "bottom", "water");
LL_WORDS(DvlFrame, "instrument", "ship", "earth");
LL_WORDS(BottomDepth::Below, "transducer", "surface", "keel");
LL_WORDS(UsblAxes, "head-up", "north-up");
LL_WORDS(Mode, "A", "B", "C", "D", "E1", "E0");
LL_WORDS(PositionSource, "", "gnss", "usbl");
#undef LL_WORDS

template <class M>
inline constexpr const char* table_of = nullptr;
template <>
inline constexpr const char* table_of<Rejected> = "rejected";
template <>
inline constexpr const char* table_of<Health> = "health";
template <>
inline constexpr const char* table_of<Alarm> = "alarm_raised";
template <>
inline constexpr const char* table_of<ClockReading> = "clock_reading";
template <>
inline constexpr const char* table_of<GnssFix> = "gnss_fix";
template <>
inline constexpr const char* table_of<Course> = "course";
template <>
inline constexpr const char* table_of<Heading> = "heading";
template <>
inline constexpr const char* table_of<Attitude> = "attitude";
template <>
inline constexpr const char* table_of<Rates> = "rates";
template <>
inline constexpr const char* table_of<ImuSample> = "imu_sample";
template <>
inline constexpr const char* table_of<DvlVelocity> = "dvl_velocity";
template <>
inline constexpr const char* table_of<BeamRanges> = "beam_ranges";
template <>
inline constexpr const char* table_of<AltitudeAboveBottom> = "altitude_above_bottom";
template <>
inline constexpr const char* table_of<DepthMeasured> = "depth_measured";
template <>
inline constexpr const char* table_of<BottomDepth> = "bottom_depth";
template <>
inline constexpr const char* table_of<Pressure> = "pressure";
template <>
inline constexpr const char* table_of<SoundSpeed> = "sound_speed";
template <>
inline constexpr const char* table_of<UsblRelative> = "usbl_relative";
template <>
inline constexpr const char* table_of<UsblGeographic> = "usbl_geographic";
template <>
inline constexpr const char* table_of<UsblGrid> = "usbl_grid";
template <>
inline constexpr const char* table_of<Solution> = "engine_solution";
template <>
inline constexpr const char* table_of<FixVerdict> = "fix_verdict";
template <>
inline constexpr const char* table_of<ModeChange> = "mode_change";

template <class V>
void fields(V& v, Rejected& m) {
  v("reason", m.reason), v("offset_bytes", m.offset), v("length_bytes", m.length);
}
template <class V>
void fields(V& v, Health& m) {
  v("level", m.level), v("text", m.text);
}
template <class V>
void fields(V& v, Alarm& m) {
  v("priority", m.priority), v("reason", m.reason), v("text", m.text);
}
template <class V>
void fields(V& v, ClockReading& m) {
  v("telegram", m.telegram), v("device_ns", m.device_ns), v("reference_ns", m.reference_ns);
}
template <class V>
void fields(V& v, GnssFix& m) {
  v("lat_rad", m.position.lat), v("lon_rad", m.position.lon), v("ellipsoid_height_m", m.height);
  v("quality", m.quality), v("satellites", m.satellites), v("hdop", m.hdop);
  v("sd_north_m", m.sd_north_m), v("sd_east_m", m.sd_east_m), v("sd_down_m", m.sd_down_m);
}
template <class V>
void fields(V& v, Course& m) {
  v("speed_mps", m.speed_mps), v("course_rad", m.course);
  v("vel_down_mps", m.vel_down_mps), v("sd_mps", m.sd_mps);
}
template <class V>
void fields(V& v, Heading& m) {
  v("heading_rad", m.heading), v("reference", m.reference), v("variation_rad", m.variation),
      v("sd_rad", m.sd);
}
template <class V>
void fields(V& v, Attitude& m) {
  v("roll_rad", m.roll), v("pitch_rad", m.pitch), v("heave_up_m", m.heave_up_m);
  v("sd_roll_rad", m.sd_roll), v("sd_pitch_rad", m.sd_pitch);
}
template <class V>
void fields(V& v, Rates& m) {
  v("rate_z_rps", m.rate_z_rps);
}
template <class V>
void fields(V& v, ImuSample& m) {
  v("increments", m.increments);
  v("gyro_x", m.gyro.x), v("gyro_y", m.gyro.y), v("gyro_z", m.gyro.z);
  v("accel_x", m.accel.x), v("accel_y", m.accel.y), v("accel_z", m.accel.z);
}
template <class V>
void fields(V& v, DvlVelocity& m) {
  v("reference", m.reference), v("axes", m.frame), v("tilt_applied", m.tilt_applied);
  v("x_mps", m.x_mps), v("y_mps", m.y_mps), v("z_mps", m.z_mps), v("valid", m.valid);
  v("sd_mps", m.sd_mps), v("error_mps", m.error_mps);
  std::optional<Angle> heading, roll, pitch;
  std::optional<HeadingReference> reference;
  if (m.applied) {
    heading = m.applied->heading, roll = m.applied->roll, pitch = m.applied->pitch;
    reference = m.applied->reference;
  }
  v("applied_heading_rad", heading), v("applied_roll_rad", roll), v("applied_pitch_rad", pitch);
  v("applied_reference", reference);
  const Angle unknown = Angle::rad(std::nan(""));
  if (reference)
    m.applied = {heading.value_or(unknown), roll.value_or(unknown), pitch.value_or(unknown), *reference};
}
template <class V>
void fields(V& v, BeamRanges& m) {
  v("range_1_m", m.range_m[0]), v("range_2_m", m.range_m[1]), v("range_3_m", m.range_m[2]),
      v("range_4_m", m.range_m[3]);
  v("beam_angle_rad", m.beam_angle);
}
template <class V>
void fields(V& v, AltitudeAboveBottom& m) {
  v("above_bottom_m", m.above_bottom_m);
}
template <class V>
void fields(V& v, DepthMeasured& m) {
  v("depth_m", m.depth), v("sd_m", m.sd_m);
}
template <class V>
void fields(V& v, BottomDepth& m) {
  v("depth_m", m.depth_m), v("below", m.below);
}
template <class V>
void fields(V& v, Pressure& m) {
  v("gauge_pa", m.gauge_pa);
}
template <class V>
void fields(V& v, SoundSpeed& m) {
  v("speed_mps", m.speed_mps);
}
template <class V>
void fields(V& v, UsblRelative& m) {
  v("transponder", m.transponder), v("axes", m.axes), v("x_m", m.x_m), v("y_m", m.y_m);
  v("down_m", m.down_m), v("sd_m", m.sd_m);
}
template <class V>
void fields(V& v, UsblGeographic& m) {
  v("transponder", m.transponder), v("lat_rad", m.position.lat), v("lon_rad", m.position.lon);
  v("depth_m", m.depth), v("sd_m", m.sd_m);
}
template <class V>
void fields(V& v, UsblGrid& m) {
  v("transponder", m.transponder), v("easting_m", m.easting_m), v("northing_m", m.northing_m);
  v("depth_m", m.depth), v("sd_m", m.sd_m);
}
template <class V>
void fields(V& v, Solution& m) {
  v("engine", m.engine), v("lat_rad", m.position.lat), v("lon_rad", m.position.lon), v("depth_m", m.depth);
  v("roll_rad", m.roll), v("pitch_rad", m.pitch), v("heading_rad", m.heading);
  v("vel_north_mps", m.vel_north_mps), v("vel_east_mps", m.vel_east_mps), v("vel_down_mps", m.vel_down_mps);
  v("var_north_m2", m.var_north_m2), v("cov_north_east_m2", m.cov_north_east_m2),
      v("var_east_m2", m.var_east_m2);
  double sd_north_m = std::sqrt(m.var_north_m2), sd_east_m = std::sqrt(m.var_east_m2);
  v("sd_north_m", sd_north_m), v("sd_east_m", sd_east_m), v("sd_down_m", m.sd_down_m);
  v("sd_heading_rad", m.sd_heading), v("heading_bias_rad", m.heading_bias);
  v("mode", m.mode), v("position_source", m.position_source);
}
template <class V>
void fields(V& v, FixVerdict& m) {
  v("engine", m.engine), v("lat_rad", m.position.lat), v("lon_rad", m.position.lon), v("depth_m", m.depth);
  v("residual_m", m.residual_m), v("dr_residual_m", m.dr_residual_m), v("gate_m", m.gate_m),
      v("accepted", m.accepted);
}
template <class V>
void fields(V& v, ModeChange& m) {
  v("engine", m.engine), v("mode_before", m.from), v("mode", m.to), v("reason", m.reason);
}

}  // namespace leadline::sessions
