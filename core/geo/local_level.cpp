#include "core/geo/local_level.h"

#include <GeographicLib/LocalCartesian.hpp>

#include "core/geo/geodesy.h"

namespace leadline::geo {

LocalLevel::LocalLevel(Geodetic origin, EllipsoidHeight height)
    : origin_{origin, height},
      cartesian_(
          std::make_shared<GeographicLib::LocalCartesian>(origin.lat.deg(), origin.lon.deg(), height.m)) {}

Vec3<LocalLevelFrame> LocalLevel::forward(Geodetic position, EllipsoidHeight height) const {
  double east = 0.0, north = 0.0, up = 0.0;
  cartesian_->Forward(position.lat.deg(), position.lon.deg(), height.m, east, north, up);
  return {north, east, -up};
}

LocalLevel::Place LocalLevel::reverse(const Vec3<LocalLevelFrame>& from_origin) const {
  double lat_deg = 0.0, lon_deg = 0.0, height_m = 0.0;
  cartesian_->Reverse(from_origin.y, from_origin.x, -from_origin.z, lat_deg, lon_deg, height_m);
  return {{Angle::deg(lat_deg), normal_longitude(Angle::deg(lon_deg))}, {height_m}};
}

}  // namespace leadline::geo
