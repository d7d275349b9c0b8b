#include <gtest/gtest.h>

#include <chrono>
#include <cmath>

#include "core/geo/geodesy.h"
#include "maps/charts/coastline.h"

namespace leadline::maps {
namespace {

Geodetic at(double lat_deg, double lon_deg) { return {Angle::deg(lat_deg), Angle::deg(lon_deg)}; }

const Coastline& coastline() {
  static const Coastline loaded = load_coastline(LEADLINE_BINARY_DIR "/charts").value();
  return loaded;
}

bool within(const PlaneRing& ring, PlanePoint p) {
  bool in = false;
  for (std::size_t i = 0, j = ring.points.size() - 1; i < ring.points.size(); j = i++) {
    const PlanePoint a = ring.points[i], b = ring.points[j];
    if ((a.north_m > p.north_m) != (b.north_m > p.north_m) &&
        p.east_m < (b.east_m - a.east_m) * (p.north_m - a.north_m) / (b.north_m - a.north_m) + a.east_m) {
      in = !in;
    }
  }
  return in;
}

// As a painter sees it: the last ring that holds the point wins.
bool is_land(const std::vector<PlaneRing>& land, const LocalProjection& plane, Geodetic place) {
  const PlanePoint p = plane.forward(place);
  bool found = false;
  for (const PlaneRing& ring : land) {
    if (within(ring, p)) found = !ring.water;
  }
  return found;
}

struct Place {
  const char* name;
  Geodetic place;
  bool land;
};
const std::vector<Place> kPlaces{{"Madrid", at(40.4, -3.7), true},
                                 {"Biscay", at(45.0, -6.0), false},
                                 {"North Pole", at(90.0, 0.0), false},
                                 {"South Pole", at(-90.0, 0.0), true},
                                 {"South Pole, another meridian", at(-89.99, 180.0), true},
                                 {"Antarctica on the date line", at(-86.0, 180.0), true},
                                 {"Ross Sea", at(-72.0, 180.0), false},
                                 {"Chukotka, east of the date line", at(67.0, -179.0), true},
                                 {"Chukotka, west of it", at(67.0, 179.0), true},
                                 {"Chukotka, on it", at(67.5, 180.0), true},
                                 {"Bering Sea", at(58.0, 180.0), false},
                                 {"Vanua Levu", at(-16.6, 179.2), true},
                                 {"Koro Sea", at(-18.0, 179.8), false},
                                 {"New Zealand", at(-40.2, 175.8), true},
                                 {"Tasman Sea", at(-40.0, 160.0), false},
                                 {"Caspian Sea", at(42.0, 50.5), false},
                                 {"Turkmenistan", at(39.5, 58.0), true},
                                 {"Australia", at(-25.0, 135.0), true},
                                 {"mid Pacific", at(0.0, -140.0), false},
                                 {"Kansas", at(38.0, -98.0), true},
                                 {"South Atlantic", at(-30.0, -15.0), false},
                                 {"Greenland", at(75.0, -40.0), true},
                                 {"Congo", at(0.0, 23.0), true},
                                 {"Indian Ocean", at(-30.0, 80.0), false}};

TEST(LandInPlane, LandIsLandAndSeaIsSeaFromAnyOrigin) {
  const std::vector<Geodetic> origins{
      at(40.0, -4.2),  // New Zealand at the antipode
      at(-40.5, 175.8),  at(-17.0, 179.9), at(-17.0, -179.9), at(89.0, 30.0),   at(90.0, 0.0),
      at(-90.0, 0.0),    at(-75.0, 180.0), at(36.9, 129.9),   at(-31.0, -70.0),  // China
      at(-50.0, -110.0),                                                         // Kazakhstan
      at(-42.0, -129.5),                                                         // the Caspian Sea
      at(0.0, 0.0),      at(67.0, -179.9), at(10.0, -30.0),   at(25.0, -45.0)};
  for (const Geodetic origin : origins) {
    const LocalProjection plane(origin);
    const auto land = land_in_plane(coastline(), plane);
    for (const Place& p : kPlaces) {
      if (geo::geodesic(origin, p.place).distance_m > 11'000'000.0) continue;  // beyond the cap
      EXPECT_EQ(is_land(land, plane, p.place), p.land)
          << p.name << " from " << origin.lat.deg() << " " << origin.lon.deg();
    }
  }
}

TEST(LandInPlane, NothingLiesBeyondTheCapAndNoShoreOnItsCircle) {
  const double radius_m = 2.0 * 6'371'000.0 * std::tan(50.0 * kRadPerDeg);
  for (const Geodetic origin : {at(40.0, -4.2), at(90.0, 0.0), at(-31.0, -70.0)}) {
    for (const PlaneRing& ring : land_in_plane(coastline(), LocalProjection(origin))) {
      ASSERT_EQ(ring.points.size(), ring.shore.size());
      const std::size_t n = ring.points.size();
      for (std::size_t i = 0; i < n; ++i) {
        const PlanePoint a = ring.points[i], b = ring.points[(i + 1) % n];
        EXPECT_LE(std::hypot(a.east_m, a.north_m), radius_m * (1.0 + 1e-9));
        if (ring.shore[i] == 0) continue;
        EXPECT_LT(std::hypot(a.east_m, a.north_m), radius_m);
        EXPECT_LT(std::hypot(b.east_m, b.north_m), radius_m);
        // 650 km on the ground, up to 2.5 times that so far out.
        EXPECT_LT(std::hypot(b.east_m - a.east_m, b.north_m - a.north_m), 1.7e6);
      }
    }
  }
}

TEST(LandInPlane, DateLineDrawsNoShore) {
  const LocalProjection plane(at(67.0, 179.9));
  int along = 0;
  for (const PlaneRing& ring : land_in_plane(coastline(), plane)) {
    for (std::size_t i = 0; i < ring.points.size(); ++i) {
      const Geodetic a = plane.reverse(ring.points[i]);
      const Geodetic b = plane.reverse(ring.points[(i + 1) % ring.points.size()]);
      const auto on = [](Geodetic p) { return std::abs(std::abs(p.lon.deg()) - 180.0) < 1e-7; };
      along += ring.shore[i] != 0 && on(a) && on(b) ? 1 : 0;
    }
  }
  EXPECT_EQ(along, 0);
}

TEST(LandInPlane, BoundsHoldTheRing) {
  for (const PlaneRing& ring : land_in_plane(coastline(), LocalProjection(at(40.0, -4.2)))) {
    for (const PlanePoint p : ring.points) {
      ASSERT_TRUE(p.east_m >= ring.bounds.west_m && p.east_m <= ring.bounds.east_m);
      ASSERT_TRUE(p.north_m >= ring.bounds.south_m && p.north_m <= ring.bounds.north_m);
    }
  }
}

}  // namespace
}  // namespace leadline::maps
