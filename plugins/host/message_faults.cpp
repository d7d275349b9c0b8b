#include "plugins/host/message_faults.h"

#include <cmath>
#include <optional>
#include <type_traits>

namespace leadline {
namespace {

/// Looks at every number of a message.
class Look {
 public:
  [[nodiscard]] std::string_view fault() const { return !finite_ ? "not finite" : !in_range_ ? "range" : ""; }

  template <class... Ts>
  Look& at(const Ts&... values) {
    (see(values), ...);
    return *this;
  }
  /// A variance or one sigma.
  template <class... Ts>
  Look& spread(const Ts&... values) {
    at(values...);
    (must(!(number(values) < 0.0)), ...);
    return *this;
  }
  template <class E>
  Look& one_of(E value, E last) {
    return must(static_cast<std::underlying_type_t<E>>(value) <=
                static_cast<std::underlying_type_t<E>>(last));
  }
  Look& must(bool in_range) {
    in_range_ = in_range_ && in_range;
    return *this;
  }

 private:
  static double number(double value) { return value; }
  static double number(Angle value) { return value.rad(); }
  template <class T>
  static double number(const std::optional<T>& value) {
    return value ? number(*value) : 0.0;
  }

  void see(double value) { finite_ = finite_ && std::isfinite(value); }
  void see(Angle value) { see(value.rad()); }
  void see(Depth value) { see(value.m); }
  void see(EllipsoidHeight value) { see(value.m); }
  void see(const Geodetic& p) {
    at(p.lat, p.lon).must(std::abs(p.lat.rad()) <= kPi / 2 && std::abs(p.lon.rad()) <= 2 * kPi);
  }
  template <class Frame>
  void see(const Vec3<Frame>& v) {
    at(v.x, v.y, v.z);
  }
  template <class T>
  void see(const std::optional<T>& value) {
    if (value) see(*value);
  }

  bool finite_ = true, in_range_ = true;
};

std::string_view look(const GnssFix& m) {
  return Look()
      .at(m.position, m.height, m.hdop)
      .spread(m.sd_north_m, m.sd_east_m, m.sd_down_m)
      .one_of(m.quality, GnssQuality::rtk_float)
      .fault();
}
std::string_view look(const Course& m) {
  return Look().at(m.speed_mps, m.course, m.vel_down_mps).spread(m.sd_mps).fault();
}
std::string_view look(const Heading& m) {
  return Look()
      .at(m.heading, m.variation)
      .spread(m.sd)
      .one_of(m.reference, HeadingReference::magnetic_north)
      .fault();
}
std::string_view look(const Attitude& m) {
  return Look().at(m.roll, m.pitch, m.heave_up_m).spread(m.sd_roll, m.sd_pitch).fault();
}
std::string_view look(const Rates& m) { return Look().at(m.rate_z_rps).fault(); }
std::string_view look(const ImuSample& m) { return Look().at(m.gyro, m.accel).fault(); }
std::string_view look(const DvlVelocity& m) {
  Look look;
  if (m.applied)
    look.at(m.applied->heading, m.applied->roll, m.applied->pitch)
        .one_of(m.applied->reference, HeadingReference::magnetic_north);
  return look.at(m.x_mps, m.y_mps, m.z_mps, m.error_mps)
      .spread(m.sd_mps)
      .one_of(m.reference, DvlReference::water)
      .one_of(m.frame, DvlFrame::earth)
      .fault();
}
std::string_view look(const BeamRanges& m) {
  return Look().at(m.range_m[0], m.range_m[1], m.range_m[2], m.range_m[3], m.beam_angle).fault();
}
std::string_view look(const AltitudeAboveBottom& m) { return Look().at(m.above_bottom_m).fault(); }
std::string_view look(const DepthMeasured& m) { return Look().at(m.depth).spread(m.sd_m).fault(); }
std::string_view look(const BottomDepth& m) {
  return Look().at(m.depth_m).one_of(m.below, BottomDepth::Below::keel).fault();
}
std::string_view look(const Pressure& m) { return Look().at(m.gauge_pa).fault(); }
std::string_view look(const SoundSpeed& m) { return Look().at(m.speed_mps).fault(); }
std::string_view look(const UsblRelative& m) {
  return Look().at(m.x_m, m.y_m, m.down_m).spread(m.sd_m).one_of(m.axes, UsblAxes::north_up).fault();
}
std::string_view look(const UsblGeographic& m) {
  return Look().at(m.position, m.depth).spread(m.sd_m).fault();
}
std::string_view look(const UsblGrid& m) {
  return Look().at(m.easting_m, m.northing_m, m.depth).spread(m.sd_m).fault();
}
std::string_view look(const ClockReading&) { return {}; }
std::string_view look(const Solution& m) {
  return Look()
      .at(m.position, m.depth, m.roll, m.pitch, m.heading, m.vel_north_mps, m.vel_east_mps, m.vel_down_mps)
      .at(m.cov_north_east_m2, m.heading_bias)
      .spread(m.var_north_m2, m.var_east_m2, m.sd_down_m, m.sd_heading)
      .one_of(m.mode.value_or(Mode::A), Mode::E0)
      .one_of(m.position_source, PositionSource::usbl)
      .fault();
}
std::string_view look(const FixVerdict& m) {
  return Look().at(m.position, m.depth, m.residual_m, m.dr_residual_m, m.gate_m).fault();
}
std::string_view look(const ModeChange& m) {
  return Look().one_of(m.from, Mode::E0).one_of(m.to, Mode::E0).fault();
}
std::string_view look(const Health& m) { return Look().one_of(m.level, Health::Level::warning).fault(); }

template <class T, class... Kinds>
constexpr bool kOneOf = (std::is_same_v<T, Kinds> || ...);

}  // namespace

std::string_view fault_of_engine(const Message& message, Time valid, EngineId id) {
  // 1824 to 2116: the difference of any two is a Duration.
  constexpr std::int64_t kFarthestNs = std::int64_t{1} << 62;
  if (valid.ns < -kFarthestNs || valid.ns > kFarthestNs) return "range";
  return std::visit(
      [&](const auto& m) -> std::string_view {
        using T = std::decay_t<decltype(m)>;
        if constexpr (kOneOf<T, Solution, FixVerdict, ModeChange>)
          return m.engine != id ? "foreign id" : look(m);
        else if constexpr (std::is_same_v<T, Health>)
          return look(m);
        else
          return "foreign message";
      },
      message);
}

std::string_view fault_of_decoder(const Message& message) {
  return std::visit(
      [](const auto& m) -> std::string_view {
        using T = std::decay_t<decltype(m)>;
        constexpr bool kMeasured = !kOneOf<T, Health, Solution, FixVerdict, ModeChange>;
        if constexpr (kMeasured && requires { look(m); })
          return look(m);
        else
          return "foreign message";  // so is a new kind of message, until it is given its look
      },
      message);
}

}  // namespace leadline
