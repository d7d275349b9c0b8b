#pragma once

#include <optional>

#include "core/nav/engines/dead_reckoning_engine.h"
#include "core/nav/filters/fix_gate.h"
#include "core/nav/filters/heading_bias_filter.h"

namespace leadline::nav {

/// Kang 2017's localization of a vehicle with a compass, a rate gyro, a DVL and GNSS while on the surface:
/// HeadingBiasFilter as an engine. The heading is taken as the compass gives it, magnetic or true; b is what
/// has to be added: declination, mount and the DVL's own misalignment in one. It starts from the declination
/// where that is known, at the first GNSS fix (or [navigation.initial]) with a heading.
///
/// GNSS of this body is used at 0.15 m/s or more and with an HDOP of at most 2; a late one is compared with
/// the position at its own time. Fixes that are refused but agree set the position anew. USBL is not used.
/// Once b is known to 0.7 degrees after 60 m or more, that is said, with the declination beside it.
/// u and v are velocities over the bottom; between pings they are held.
class Ekf7Engine final : public Engine {
 public:
  explicit Ekf7Engine(const EngineSetup& setup);
  void take(const Envelope& envelope, EngineOutput& out) override;

 private:
  using Filter = HeadingBiasFilter;

  void on_heading(const Envelope& envelope, const Heading& heading);
  void on_velocity(const Envelope& envelope, const DvlVelocity& ping);
  void on_fix(const PositionFix& fix, std::optional<double> hdop, EngineOutput& out);
  void start(Time t, const Geodetic& position, double sd_m);
  /// From the body's reference point to an antenna.
  [[nodiscard]] Eigen::Vector2d lever_ne(const SourceInfo& source, Time t);
  /// False: too long ago to be of use now.
  bool advance(Time t);
  /// After a measurement: carries the filter's change of position over to the track.
  void shift_from(const Eigen::Vector2d& before);
  void evaluate(Time now, EngineOutput& out);
  void tell_bias(Time now, EngineOutput& out);
  void publish_row(EngineOutput& out);

  EngineSetup setup_;
  Motion motion_;          // its track is the filter's; its headings give the declination
  BodyAttitude measured_;  // every heading as if it were a true one
  PositionFixes fixes_;
  Availability availability_;
  RowPace pace_;
  Filter filter_;
  Preferred compass_, rates_, dvl_, gnss_;
  RejectedFixes rejected_;
  DriftSinceFix drift_;
  Eigen::Vector2d corrections_ = Eigen::Vector2d::Zero();
  Time now_, epoch_;
  std::optional<Time> heading_at_, down_at_;
  double vel_down_mps_ = 0.0, run_m_ = 0.0;
  PositionSource position_source_ = PositionSource::none;
  bool bias_told_ = false;
};

}  // namespace leadline::nav
