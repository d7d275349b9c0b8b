#pragma once

#include "core/types/position.h"

namespace leadline::geo {

/// WGS-84 radii of curvature at a latitude, metres: along the meridian and along the prime vertical.
struct Radii {
  double meridian_m, prime_vertical_m;
};
[[nodiscard]] Radii radii(Angle lat);

/// A small horizontal vector along the north and east axes at one point, metres.
struct NorthEast {
  double north_m = 0.0, east_m = 0.0;
};

/// The point reached from `from` by a step along its north and east axes, at `height_m` above the ellipsoid
/// (negative below). The step lies in the tangent plane at `from` up to 10 km, beyond that along the
/// geodesic, which the plane overshoots by s^3/6R^2: 4 um at 1 km, 0.5 mm at 5 km, 4 mm at 10 km, at any
/// latitude, over a pole and over the date line. A course held over one long step (a loxodrome) turns away
/// from it by s^2 tan(lat)/2R, 0.8 mm for 100 m at 45 deg: cut long dead reckoning up. No allocation, about
/// 0.1 us.
[[nodiscard]] Geodetic displaced(Geodetic from, double north_m, double east_m, double height_m = 0.0);

/// Where `to` lies from `from`, along the axes at `from`: the inverse of displaced(), any distance. Round
/// trip within 2e-9 m below 9.9 km (a longitude near 180 deg is itself only stored to 1.4e-9 m), 1e-6 of it
/// beyond.
[[nodiscard]] NorthEast difference(Geodetic from, Geodetic to, double height_m = 0.0);

/// The shortest way on the ellipsoid (Karney 2013), any distance, to 15 nm: length, and its azimuth at `a`
/// clockwise from true north in [0, 2 pi); without meaning when the points coincide.
struct GeodesicLine {
  double distance_m;
  Angle azimuth;
};
[[nodiscard]] GeodesicLine geodesic(Geodetic a, Geodetic b);

/// The same longitude in [-180, 180) deg; one that is there already comes back bit for bit.
[[nodiscard]] Angle normal_longitude(Angle lon);

}  // namespace leadline::geo
