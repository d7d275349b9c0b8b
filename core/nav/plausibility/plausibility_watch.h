#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/flow/engine.h"
#include "core/nav/engines/position_fixes.h"
#include "core/nav/plausibility/displacement_check.h"
#include "core/nav/plausibility/frozen_values.h"
#include "core/nav/plausibility/unit_check.h"

namespace leadline::nav {

/// Names the instrument that contradicts the others: a DVL with a wrong sign, swapped axes or a forgotten
/// mount (DisplacementCheck), radians for degrees and feet for metres (UnitCheck), values that stand still
/// while the body moves (FrozenValues). It says Health only, a warning once a finding and a note when it is
/// well again; it changes nothing of the navigation. Everything is kept in fixed room made at the start: no
/// allocation a message. Heard in the Bus's order, it says the same of the same.
class PlausibilityWatch final : public Engine {
 public:
  /// magnetic may be null. sources must outlive it.
  PlausibilityWatch(std::span<const SourceInfo> sources, const Options& options,
                    const geo::MagneticModel* magnetic);
  ~PlausibilityWatch() override;

  void take(const Envelope& envelope, EngineOutput& out) override;

 private:
  struct Vessel;
  struct Dvl;
  void ping(const Envelope& envelope, const DvlVelocity& velocity);
  void fix(const PositionFix& fix, Arrival now, EngineOutput& out);
  void judge(SourceId source, const DisplacementCheck::Misreading& found, const PositionFix& fix, Arrival now,
             EngineOutput& out);

  std::span<const SourceInfo> sources_;
  Findings findings_;
  FrozenValues frozen_;
  UnitCheck units_;
  PositionFixes fixes_;
  std::vector<Vessel> vessels_;  // by Body
  std::vector<Dvl> dvls_;        // by source, of those that are one
  bool displacements_ = false;   ///< a DVL or USBL was heard
  std::uint32_t ticks_ = 0;
};

}  // namespace leadline::nav
