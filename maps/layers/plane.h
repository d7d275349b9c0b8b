#pragma once

namespace leadline::maps {

/// A point in a chart's local projection: metres east and north of its origin.
struct PlanePoint {
  double east_m = 0.0, north_m = 0.0;
  bool operator==(const PlanePoint&) const = default;
};

/// An axis-parallel part of the plane.
struct PlaneBox {
  double west_m = 0.0, south_m = 0.0, east_m = 0.0, north_m = 0.0;
  bool operator==(const PlaneBox&) const = default;
};

}  // namespace leadline::maps
