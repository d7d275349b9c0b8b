#pragma once

#include <optional>
#include <span>

#include "core/nav/engines/ship_state.h"

namespace leadline::nav {

/// One position of a body, from whatever telegram, in latitude and longitude of the instrument or
/// transponder.
struct PositionFix {
  Time t;
  SourceId source = kNoSource;
  Body body = Body::vehicle;
  PositionSource kind = PositionSource::gnss;
  Geodetic position;
  std::optional<Depth> depth;
  std::optional<EllipsoidHeight> height;
  double drms_m = 0.0;  ///< gamma: horizontal 2-D RMS error
};

/// Turns every position telegram into a PositionFix. USBL: the transponder's bearing is taken from the ship's
/// heading and the transceiver's mount (devices level it themselves), the transceiver's place from the ship's
/// position and its lever arm. A USBL telegram without a ship position or heading gives nothing.
class PositionFixes {
 public:
  PositionFixes(std::span<const SourceInfo> sources, const Options& options,
                const geo::MagneticModel* magnetic)
      : sources_(sources), options_(options), ship_(sources, options, magnetic) {}

  /// Takes every fact; gives the fix this one is.
  std::optional<PositionFix> take(const Envelope& envelope);

 private:
  [[nodiscard]] std::optional<Geodetic> transponder(const UsblRelative& relative, const SourceInfo& source,
                                                    Time t);

  std::span<const SourceInfo> sources_;
  Options options_;
  ShipState ship_;
};

}  // namespace leadline::nav
