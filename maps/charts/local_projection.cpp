#include "maps/charts/local_projection.h"

#include <proj.h>

#include <cmath>
#include <cstdio>

#include "core/geo/geodesy.h"
#include "core/types/expect.h"

namespace leadline::maps {
namespace {

// PROJ's sterea loses the scale of its sphere close to a pole (an arc sine near 1): nothing to be seen at
// 89.99 deg, 9e-6 at 89.9999, and no plane at all at the south pole. There its ellipsoidal stere takes over;
// where it does, the two differ by 5e-8 of the distance 50 km out (measured).
constexpr double kPolar_deg = 89.9;
constexpr double kStep_rad = 1e-6;

std::string definition_of(Geodetic origin) {
  const char* method = std::abs(origin.lat.deg()) > kPolar_deg ? "stere" : "sterea";
  char text[160];
  std::snprintf(text, sizeof text, "+proj=%s +lat_0=%.15g +lon_0=%.15g +k=1 +datum=WGS84 +units=m +no_defs",
                method, origin.lat.deg(), origin.lon.deg());
  return text;
}

}  // namespace

struct LocalProjection::Transform {
  explicit Transform(const std::string& definition) : context(proj_context_create()) {
    proj_log_level(context, PJ_LOG_NONE);
    projection = proj_create(context, definition.c_str());
    LL_EXPECT(projection != nullptr);
  }
  Transform(const Transform&) = delete;
  Transform& operator=(const Transform&) = delete;
  ~Transform() {
    proj_destroy(projection);
    proj_context_destroy(context);
  }
  [[nodiscard]] PlanePoint forward(double lat_rad, double lon_rad) const {
    const PJ_COORD at = proj_trans(projection, PJ_FWD, proj_coord(lon_rad, lat_rad, 0.0, 0.0));
    return {at.xy.x, at.xy.y};
  }

  PJ_CONTEXT* context;
  PJ* projection;
};

LocalProjection::LocalProjection(Geodetic origin)
    : origin_(origin), transform_(std::make_shared<Transform>(definition_of(origin))) {}

PlanePoint LocalProjection::forward(Geodetic point) const {
  return transform_->forward(point.lat.rad(), point.lon.rad());
}

void LocalProjection::forward(std::span<const Geodetic> points, std::span<PlanePoint> out) const {
  LL_EXPECT(points.size() == out.size());
  if (points.empty()) return;
  for (std::size_t i = 0; i < points.size(); ++i) out[i] = {points[i].lon.rad(), points[i].lat.rad()};
  proj_trans_generic(transform_->projection, PJ_FWD, &out[0].east_m, sizeof(PlanePoint), out.size(),
                     &out[0].north_m, sizeof(PlanePoint), out.size(), nullptr, 0, 0, nullptr, 0, 0);
}

Geodetic LocalProjection::reverse(PlanePoint point) const {
  const PJ_COORD at =
      proj_trans(transform_->projection, PJ_INV, proj_coord(point.east_m, point.north_m, 0.0, 0.0));
  return {Angle::rad(at.lp.phi), geo::normal_longitude(Angle::rad(at.lp.lam))};
}

// The plane direction of the meridian, by a difference over 12 m: 1e-9 rad.
Angle LocalProjection::convergence(Geodetic point) const {
  const double lat = point.lat.rad(), lon = point.lon.rad();
  const PlanePoint a = transform_->forward(std::fmax(lat - kStep_rad, -kPi / 2), lon);
  const PlanePoint b = transform_->forward(std::fmin(lat + kStep_rad, kPi / 2), lon);
  return Angle::rad(-std::atan2(b.east_m - a.east_m, b.north_m - a.north_m)).wrapped_pi();
}

std::string LocalProjection::definition() const { return definition_of(origin_); }

}  // namespace leadline::maps
