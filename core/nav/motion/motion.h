#pragma once

#include <span>

#include "core/nav/engines/options.h"
#include "core/nav/motion/body_attitude.h"
#include "core/nav/motion/dead_reckoning.h"

namespace leadline::nav {

/// What one body's own sensors say of its motion: attitude, depth and the velocity of its DVL, summed up to a
/// track. Knows nothing of fixes; the engines are built round it.
class Motion {
 public:
  Motion(Body body, std::span<const SourceInfo> sources, const Options& options,
         const geo::MagneticModel* magnetic);

  /// A velocity over the bottom, or through the water while there is none over the bottom.
  struct Ping {
    Time t;
    DeadReckoning::Velocity velocity;
    bool bottom = false;
    double vel_down_mps = 0.0;
  };
  /// Takes every fact; gives the velocity when this one is a ping that has one: the DVL first in the
  /// configuration that is alive, with a heading.
  std::optional<Ping> take(const Envelope& envelope);
  /// Is this DvlVelocity a bottom ping of the DVL that speaks? (lock or not)
  [[nodiscard]] bool is_bottom_ping(const Envelope& envelope) const;

  [[nodiscard]] const SourceInfo& source(SourceId id) const { return sources_[id]; }
  [[nodiscard]] bool own(SourceId id) const { return id < sources_.size() && sources_[id].body == body_; }
  [[nodiscard]] BodyAttitude::Estimate attitude_at(Time t) { return attitude_.at(t, track.position()); }
  [[nodiscard]] std::optional<Depth> depth() const { return depth_; }
  [[nodiscard]] std::optional<double> above_bottom_m() const { return above_bottom_m_; }
  /// On the surface, as far as is known: less than 2 m deep.
  [[nodiscard]] bool surfaced() const { return !depth_measured_ || depth_->m < 2.0; }
  /// What the operator has to know of the headings: each is given once.
  [[nodiscard]] std::optional<Health> notice();

  /// Without a depth sensor the depth is minus the ellipsoid height of the fixes (product page).
  void height_known(EllipsoidHeight height);
  void depth_known(Depth depth, double sd_m);
  /// A fix of an instrument brought to the body's reference point, as far as the attitude is known.
  [[nodiscard]] Geodetic without_lever(const Geodetic& instrument, const SourceInfo& source, Time t);

  /// The track's end and everything known beside it, true at the track's time.
  [[nodiscard]] Solution solution();

  DeadReckoning track;

 private:
  Body body_;
  std::span<const SourceInfo> sources_;
  Options options_;
  BodyAttitude attitude_;
  Preferred dvl_, depth_source_;
  Intervals bottom_pings_;
  std::optional<Ping> last_ping_;
  bool depth_measured_ = false;
  std::optional<Depth> depth_;
  double sd_depth_m_ = 0.0;
  std::optional<double> above_bottom_m_;
  bool told_lacking_ = false, told_outside_ = false;
};

}  // namespace leadline::nav
