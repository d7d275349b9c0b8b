#pragma once

#include "core/nav/availability/availability.h"
#include "core/nav/engines/position_fixes.h"
#include "core/nav/engines/registry.h"
#include "core/nav/engines/row_pace.h"
#include "core/nav/motion/motion.h"

namespace leadline::nav {

/// Dead reckoning as an engine: starts at [navigation.initial] or the first valid fix and never looks at
/// another; every fix gets a verdict with its residual, none is accepted.
class DeadReckoningEngine final : public Engine {
 public:
  explicit DeadReckoningEngine(const EngineSetup& setup);
  void take(const Envelope& envelope, EngineOutput& out) override;

 private:
  void on_fix(const PositionFix& fix, EngineOutput& out);

  EngineSetup setup_;
  Motion motion_;
  PositionFixes fixes_;
  Availability availability_;
  RowPace pace_;
};

/// The start [navigation.initial] gives: nothing without latitude and longitude.
struct InitialPosition {
  Geodetic position;
  Eigen::Matrix2d P;
};
[[nodiscard]] std::optional<InitialPosition> initial_position(const InitialOptions& initial);
/// Sets the depth [navigation.initial] gives, if any.
void apply_initial_depth(const InitialOptions& initial, Motion& motion);

/// Where a fix puts the body's reference point. The mount of a USBL source is that of the transceiver on the
/// ship, which PositionFixes has allowed for: the transponder is taken to be at the reference point.
[[nodiscard]] Geodetic reference_point(const PositionFix& fix, Motion& motion);

/// Publishes a change of availability as a ModeChange, true at `now`.
void publish_change(const Availability::Change& change, EngineId engine, Time now, EngineOutput& out);

}  // namespace leadline::nav
