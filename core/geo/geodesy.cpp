#include "core/geo/geodesy.h"

#include <GeographicLib/Geodesic.hpp>
#include <algorithm>
#include <cmath>

namespace leadline::geo {
namespace {

constexpr double kA = 6378137.0;
constexpr double kF = 1.0 / 298.257223563;
constexpr double kE2 = kF * (2.0 - kF);

// Where the tangent plane's overshoot, s^3/6R^2, reaches 4 mm.
constexpr double kTangentReach_m = 10e3;

// Distances at a height, as a multiple of those on the ellipsoid below.
struct HeightScale {
  double north, east;
};
HeightScale height_scale(const Radii& r, double height_m) {
  return {1.0 + height_m / r.meridian_m, 1.0 + height_m / r.prime_vertical_m};
}

/// to - from, the short way round. Near the date line every operation is exact.
double longitude_difference(Angle from, Angle to) {
  const double d = to.rad() - from.rad();
  if (d >= kPi) return (to.rad() - kPi) - (from.rad() + kPi);
  if (d < -kPi) return (to.rad() + kPi) - (from.rad() - kPi);
  return d;
}

/// The point of the ellipsoid above or below a step in the tangent plane at `from`.
///
/// Coordinates: x away from the axis in the plane of from's meridian, east, z along the axis; u is the drop
/// below the tangent plane. Putting the point into (x^2 + east^2) + k z^2 = a^2, k = 1/(1 - e^2), leaves
/// A u^2 - 2 B u + C = 0. All changes of latitude come from small differences, so that nothing is lost to the
/// 1e-9 m which is all a double can resolve in coordinates of 6e6 m.
Geodetic from_tangent_plane(Geodetic from, double n, double e) {
  constexpr double k = 1.0 / (1.0 - kE2);
  const double s = sin(from.lat), c = cos(from.lat);
  const double N = kA / std::sqrt(1.0 - kE2 * s * s);

  const double A = c * c + k * s * s;
  const double B = N + n * s * c * (k - 1.0);
  const double C = (s * s + k * c * c) * n * n + e * e;
  const double u = C / (B + std::sqrt(B * B - A * C));

  const double x = N * c - s * n - c * u;
  const double p = std::hypot(x, e);
  const double p_minus_x = x > 0.0 ? e * e / (p + x) : p - x;
  const double dp = p_minus_x - s * n - c * u;
  const double dz = c * n - s * u;

  // The normal of the ellipsoid is along (p, k z), at `from` along N (c, s).
  const double dlat = std::atan2(c * k * dz - s * dp, N + c * dp + s * k * dz);
  const double lat = std::clamp(from.lat.rad() + dlat, -kPi / 2.0, kPi / 2.0);
  return {Angle::rad(lat), normal_longitude(Angle::rad(from.lon.rad() + std::atan2(e, x)))};
}

struct TangentStep {
  double north, east, drop;
};

/// The inverse: products of sines of the half difference instead of differences of large coordinates.
TangentStep to_tangent_plane(Geodetic from, Geodetic to) {
  const double s1 = sin(from.lat), c1 = cos(from.lat), s2 = sin(to.lat), c2 = cos(to.lat);
  const double half = 0.5 * (to.lat.rad() - from.lat.rad());
  const double mid = from.lat.rad() + half, sin_half = std::sin(half);
  const double ds = 2.0 * std::cos(mid) * sin_half, dc = -2.0 * std::sin(mid) * sin_half;

  const double w1 = std::sqrt(1.0 - kE2 * s1 * s1), w2 = std::sqrt(1.0 - kE2 * s2 * s2);
  const double N2 = kA / w2;
  const double dN = kA * kE2 * ds * (s1 + s2) / (w1 * w2 * (w1 + w2));
  const double dp = N2 * dc + c1 * dN;
  const double dz = (1.0 - kE2) * (N2 * ds + s1 * dN);

  const double dlon = longitude_difference(from.lon, to.lon), sin_half_lon = std::sin(0.5 * dlon);
  const double dx = dp - 2.0 * N2 * c2 * sin_half_lon * sin_half_lon;
  return {c1 * dz - s1 * dx, N2 * c2 * std::sin(dlon), -(c1 * dx + s1 * dz)};
}

}  // namespace

Radii radii(Angle lat) {
  const double s = sin(lat), w2 = 1.0 - kE2 * s * s, prime_vertical = kA / std::sqrt(w2);
  return {prime_vertical * (1.0 - kE2) / w2, prime_vertical};
}

Geodetic displaced(Geodetic from, double north_m, double east_m, double height_m) {
  const HeightScale scale = height_scale(radii(from.lat), height_m);
  const double n = north_m / scale.north, e = east_m / scale.east;
  if (n * n + e * e <= kTangentReach_m * kTangentReach_m) return from_tangent_plane(from, n, e);

  double lat_deg = 0.0, lon_deg = 0.0;
  GeographicLib::Geodesic::WGS84().Direct(from.lat.deg(), from.lon.deg(), std::atan2(e, n) * kDegPerRad,
                                          std::hypot(n, e), lat_deg, lon_deg);
  return {Angle::deg(lat_deg), normal_longitude(Angle::deg(lon_deg))};
}

NorthEast difference(Geodetic from, Geodetic to, double height_m) {
  const HeightScale scale = height_scale(radii(from.lat), height_m);
  const TangentStep step = to_tangent_plane(from, to);
  // The far side of the Earth also lies above the tangent plane's first kilometres: the drop tells.
  if (step.north * step.north + step.east * step.east <= kTangentReach_m * kTangentReach_m && step.drop < kA)
    return {step.north * scale.north, step.east * scale.east};

  const GeodesicLine line = geodesic(from, to);
  return {line.distance_m * cos(line.azimuth) * scale.north,
          line.distance_m * sin(line.azimuth) * scale.east};
}

GeodesicLine geodesic(Geodetic a, Geodetic b) {
  double distance_m = 0.0, azimuth_a_deg = 0.0, azimuth_b_deg = 0.0;
  GeographicLib::Geodesic::WGS84().Inverse(a.lat.deg(), a.lon.deg(), b.lat.deg(), b.lon.deg(), distance_m,
                                           azimuth_a_deg, azimuth_b_deg);
  return {distance_m, Angle::deg(azimuth_a_deg).wrapped_2pi()};
}

Angle normal_longitude(Angle lon) {
  if (lon.rad() >= -kPi && lon.rad() < kPi) return lon;
  const double r = std::remainder(lon.rad(), 2.0 * kPi);
  return Angle::rad(r >= kPi ? -kPi : r);
}

}  // namespace leadline::geo
