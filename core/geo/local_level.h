#pragma once

#include <memory>

#include "core/types/position.h"
#include "core/types/vec3.h"

namespace GeographicLib {
class LocalCartesian;
}

namespace leadline::geo {

/// l: north, east, down at a fixed origin, the axes of the origin everywhere.
struct LocalLevelFrame {};

/// The Cartesian frame of a session: north-east-down at its origin, exact at any distance (GeographicLib's
/// LocalCartesian, to 5 nm near the Earth). Far from the origin its axes are not those of the place:
/// 1 km away "down" is 79 mm of curvature off the sea's surface. A value, cheap to copy; const is thread
/// safe.
class LocalLevel {
 public:
  LocalLevel(Geodetic origin, EllipsoidHeight height);

  struct Place {
    Geodetic position;
    EllipsoidHeight height;
  };

  /// Metres from the origin.
  [[nodiscard]] Vec3<LocalLevelFrame> forward(Geodetic position, EllipsoidHeight height) const;
  /// Longitude in [-180, 180) deg.
  [[nodiscard]] Place reverse(const Vec3<LocalLevelFrame>& from_origin) const;
  [[nodiscard]] Place origin() const { return origin_; }

 private:
  Place origin_;
  std::shared_ptr<const GeographicLib::LocalCartesian> cartesian_;
};

}  // namespace leadline::geo
