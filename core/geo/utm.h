#pragma once

#include <optional>

#include "core/types/position.h"
#include "core/types/result.h"

namespace leadline::geo {

/// A point in the Universal Transverse Mercator grid (WGS-84).
struct Utm {
  int zone;    ///< 1..60
  bool north;  ///< northings count from the equator; in the south from 10 000 km below it
  double easting_m, northing_m;
  Angle convergence;  ///< grid north clockwise from true north: true heading = grid heading + convergence
  double scale;       ///< grid metres per metre on the ellipsoid
};

/// Without `zone` the standard one, the exceptions of Norway and Svalbard included; with it that zone, to
/// stay on one grid across a zone's edge. To 5 nm within the zone (Karney 2011). Error outside [-80, 84) deg
/// of latitude, where the polar grids (UPS) rule, for a zone not in 1..60, and too far from the zone.
[[nodiscard]] Result<Utm> to_utm(Geodetic point, std::optional<int> zone = {});

/// Error for a zone not in 1..60 (zone 0 is UPS) and for coordinates outside the zone's legal range.
[[nodiscard]] Result<Geodetic> from_utm(int zone, bool north, double easting_m, double northing_m);

}  // namespace leadline::geo
