#pragma once

#include <memory>
#include <span>
#include <string>

#include "core/types/position.h"
#include "maps/layers/plane.h"

namespace leadline::maps {

/// The chart's plane: an oblique stereographic projection of WGS-84 about an origin (EPSG method 9809, by
/// PROJ). Conformal: angles are true everywhere, scale is 1 at the origin and 1 + r^2/4R^2 away from it
/// (1.5e-5 at 50 km). Good at any latitude, over the poles and the date line; without meaning near the
/// antipode. A value; copies share one PROJ object, so they belong to one thread: another thread makes its
/// own from origin().
class LocalProjection {
 public:
  explicit LocalProjection(Geodetic origin);

  [[nodiscard]] Geodetic origin() const { return origin_; }
  [[nodiscard]] PlanePoint forward(Geodetic point) const;
  /// points and out have one length.
  void forward(std::span<const Geodetic> points, std::span<PlanePoint> out) const;
  /// Longitude in [-180, 180) deg.
  [[nodiscard]] Geodetic reverse(PlanePoint point) const;
  /// Plane north clockwise from true north at a point, in [-pi, pi): plane bearing = true bearing -
  /// convergence.
  [[nodiscard]] Angle convergence(Geodetic point) const;
  /// For GDAL's warper.
  [[nodiscard]] std::string definition() const;

 private:
  struct Transform;
  Geodetic origin_;
  std::shared_ptr<Transform> transform_;
};

}  // namespace leadline::maps
