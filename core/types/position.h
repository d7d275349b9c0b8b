#pragma once

#include "core/types/angle.h"

namespace leadline {

/// A point on the WGS-84 ellipsoid: latitude in [-90, 90] deg north, longitude in [-180, 180) deg east.
struct Geodetic {
  Angle lat, lon;
  constexpr bool operator==(const Geodetic&) const = default;
};

/// Metres down from the water's surface.
struct Depth {
  double m = 0.0;
  constexpr auto operator<=>(const Depth&) const = default;
};

/// Metres up from the WGS-84 ellipsoid.
struct EllipsoidHeight {
  double m = 0.0;
  constexpr auto operator<=>(const EllipsoidHeight&) const = default;
};

}  // namespace leadline
