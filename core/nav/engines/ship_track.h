#pragma once

#include "core/flow/engine.h"
#include "core/nav/engines/ship_state.h"

namespace leadline::nav {

/// The ship's own track: one Solution (engine kShipTrack) for each position of hers that was used.
class ShipTrack final : public Engine {
 public:
  ShipTrack(std::span<const SourceInfo> sources, const Options& options, const geo::MagneticModel* magnetic)
      : ship_(sources, options, magnetic) {}

  void take(const Envelope& envelope, EngineOutput& out) override {
    if (ship_.take(envelope)) out.publish(envelope.valid, ship_.solution());
  }

 private:
  ShipState ship_;
};

}  // namespace leadline::nav
