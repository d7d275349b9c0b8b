#pragma once

#include <optional>
#include <span>

#include "core/nav/engines/options.h"
#include "core/nav/motion/body_attitude.h"

namespace leadline::nav {

/// One sigma radius (2-D RMS) of a GNSS fix: its own, never below a tenth of the configured one; else that
/// one.
[[nodiscard]] double drms_m(const GnssFix& fix, double configured_m);

/// Where the ship is and where she heads, from her own instruments: the origin of USBL positions and a track
/// of its own. The first position source of the configuration that is alive speaks.
class ShipState {
 public:
  ShipState(std::span<const SourceInfo> sources, const Options& options, const geo::MagneticModel* magnetic);

  /// Takes every fact. True when this one is a position of the ship that was used.
  bool take(const Envelope& envelope);

  /// The reference point at t: the last position moved on by course and speed. Empty when the last one is
  /// more than 10 s away.
  [[nodiscard]] std::optional<Geodetic> position_at(Time t) const;
  [[nodiscard]] BodyAttitude::Estimate attitude_at(Time t) { return attitude_.at(t, position_); }
  /// The state at the last position's time, without engine and mode.
  [[nodiscard]] Solution solution();

 private:
  std::span<const SourceInfo> sources_;
  Options options_;
  BodyAttitude attitude_;
  Preferred gnss_, course_source_;
  std::optional<Time> fixed_at_;
  Geodetic position_;
  std::optional<EllipsoidHeight> height_;
  double drms_m_ = 0.0;
  std::optional<Course> course_;
  Time course_at_;
};

}  // namespace leadline::nav
