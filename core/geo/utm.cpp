#include "core/geo/utm.h"

#include <GeographicLib/UTMUPS.hpp>
#include <cmath>
#include <exception>
#include <string>

#include "core/geo/geodesy.h"

namespace leadline::geo {
namespace {

using GeographicLib::UTMUPS;

Error bad_zone(int zone) {
  const std::string what = "no UTM zone " + std::to_string(zone);
  return {zone == 0 ? what + ": zone 0 means the polar grids (UPS), which are not supported" : what, "",
          "give a zone from 1 to 60"};
}

bool legal(int zone) { return zone >= UTMUPS::MINUTMZONE && zone <= UTMUPS::MAXUTMZONE; }

}  // namespace

Result<Utm> to_utm(Geodetic point, std::optional<int> zone) {
  if (zone && !legal(*zone)) return bad_zone(*zone);
  const double lat_deg = point.lat.deg(), lon_deg = point.lon.deg();
  if (!std::isfinite(lat_deg) || !std::isfinite(lon_deg)) return Error{"position is not a number", "", ""};
  if (lat_deg < -80.0 || lat_deg >= 84.0)
    return Error{"latitude " + std::to_string(lat_deg) +
                     " deg is outside UTM (80 S to 84 N); the polar grids (UPS) are not supported",
                 "", "use latitude and longitude there"};
  try {
    Utm utm{};
    double convergence_deg = 0.0;
    UTMUPS::Forward(lat_deg, lon_deg, utm.zone, utm.north, utm.easting_m, utm.northing_m, convergence_deg,
                    utm.scale, zone.value_or(UTMUPS::STANDARD));
    utm.convergence = Angle::deg(convergence_deg);
    return utm;
  } catch (const std::exception& e) {
    return Error{e.what(), "", "choose the zone the position lies in, or a neighbour"};
  }
}

Result<Geodetic> from_utm(int zone, bool north, double easting_m, double northing_m) {
  if (!legal(zone)) return bad_zone(zone);
  if (!std::isfinite(easting_m) || !std::isfinite(northing_m))
    return Error{"UTM coordinate is not a number", "", ""};
  try {
    double lat_deg = 0.0, lon_deg = 0.0;
    UTMUPS::Reverse(zone, north, easting_m, northing_m, lat_deg, lon_deg);
    return Geodetic{Angle::deg(lat_deg), normal_longitude(Angle::deg(lon_deg))};
  } catch (const std::exception& e) {
    return Error{e.what(), "", "check zone, hemisphere and the order of easting and northing"};
  }
}

}  // namespace leadline::geo
