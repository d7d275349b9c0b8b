#include "maps/charts/local_projection.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>

#include "core/geo/geodesy.h"

namespace leadline::maps {
namespace {

Geodetic at(double lat_deg, double lon_deg) { return {Angle::deg(lat_deg), Angle::deg(lon_deg)}; }

// Where the Earth is awkward: mid latitudes, both sides of the date line, near and on the poles, where the
// projection's method changes.
const std::vector<Geodetic> kOrigins{at(36.9, 129.9),  at(-17.0, 179.99), at(-17.0, -180.0), at(0.0, 0.0),
                                     at(89.0, 30.0),   at(-89.0, -75.0),  at(89.89, 10.0),   at(89.91, 10.0),
                                     at(-89.95, 10.0), at(89.9999999, 5), at(90.0, 0.0),     at(-90.0, 40.0)};

double apart_m(Geodetic a, Geodetic b) { return geo::geodesic(a, b).distance_m; }

TEST(LocalProjection, DistancesFromTheOriginAreThoseOnTheEllipsoid) {
  for (const Geodetic origin : kOrigins) {
    const LocalProjection plane(origin);
    for (const double range_m : {1.0, 100.0, 10'000.0, 50'000.0}) {
      for (int bearing = 0; bearing < 360; bearing += 30) {
        const Angle b = Angle::deg(bearing);
        const Geodetic there = geo::displaced(origin, range_m * cos(b), range_m * sin(b));
        const PlanePoint p = plane.forward(there);
        const double flat_m = std::hypot(p.east_m, p.north_m), true_m = apart_m(origin, there);
        // 1 + r^2/12R^2 along the whole way, and the ellipsoid's flattening in the third order; centimetres
        // from a pole the scale itself is good to 1e-7.
        EXPECT_NEAR(flat_m, true_m, 1e-6 + 1.1e-7 * true_m + 1.5e-5 * true_m * (range_m / 50'000.0))
            << origin.lat.deg() << " " << bearing;
      }
    }
  }
}

TEST(LocalProjection, BearingsFromTheOriginAreTrueOnes) {
  for (const Geodetic origin : kOrigins) {
    if (std::abs(origin.lat.deg()) > 89.9999) continue;  // a bearing at the pole means little
    const LocalProjection plane(origin);
    for (int bearing = 10; bearing < 360; bearing += 35) {
      const Geodetic there =
          geo::displaced(origin, 5'000 * cos(Angle::deg(bearing)), 5'000 * sin(Angle::deg(bearing)));
      const PlanePoint p = plane.forward(there);
      const Angle flat = Angle::rad(std::atan2(p.east_m, p.north_m));
      EXPECT_NEAR((flat - geo::geodesic(origin, there).azimuth).wrapped_pi().rad(), 0.0, 2e-6)
          << origin.lat.deg() << " " << bearing;
    }
  }
}

TEST(LocalProjection, RoundTripIsWithinAMicrometreInto1000Kilometres) {
  for (const Geodetic origin : kOrigins) {
    const LocalProjection plane(origin);
    for (double east_m = -1e6; east_m <= 1e6; east_m += 1.3e5) {
      for (double north_m = -1e6; north_m <= 1e6; north_m += 1.7e5) {
        const Geodetic there = plane.reverse({east_m, north_m});
        EXPECT_GE(there.lon.deg(), -180.0);
        EXPECT_LT(there.lon.deg(), 180.0);
        const PlanePoint back = plane.forward(there);
        ASSERT_NEAR(back.east_m, east_m, 1e-6) << origin.lat.deg() << " " << origin.lon.deg();
        ASSERT_NEAR(back.north_m, north_m, 1e-6) << origin.lat.deg() << " " << origin.lon.deg();
      }
    }
  }
}

TEST(LocalProjection, DateLineIsNoStep) {
  const LocalProjection plane(at(-17.0, 179.999));
  const PlanePoint west = plane.forward(at(-17.0, 179.9999999)),
                   east = plane.forward(at(-17.0, -179.9999999));
  EXPECT_NEAR(std::hypot(east.east_m - west.east_m, east.north_m - west.north_m), 0.0213, 0.001);
  EXPECT_GT(east.east_m, west.east_m);
}

TEST(LocalProjection, PoleIsNoStep) {
  const LocalProjection plane(at(89.0, 30.0));
  const PlanePoint before = plane.forward(at(89.9999, 30.0)), beyond = plane.forward(at(89.9999, -150.0));
  EXPECT_NEAR(beyond.north_m - before.north_m, 22.3, 0.2);
  EXPECT_NEAR(beyond.east_m, before.east_m, 1e-3);
}

TEST(LocalProjection, ConvergenceIsTheTurnBetweenTrueAndPlaneBearings) {
  for (const Geodetic origin : kOrigins) {
    const LocalProjection plane(origin);
    for (const auto& [north_m, east_m] :
         {std::pair{20'000.0, 30'000.0}, {-45'000.0, 5'000.0}, {0.0, 48'000.0}}) {
      const Geodetic here = geo::displaced(origin, north_m, east_m);
      if (std::abs(here.lat.deg()) > 89.999) continue;
      const Angle convergence = plane.convergence(here);
      for (int bearing = 0; bearing < 360; bearing += 45) {
        const double step_m = 10.0;
        const Geodetic there =
            geo::displaced(here, step_m * cos(Angle::deg(bearing)), step_m * sin(Angle::deg(bearing)));
        const PlanePoint a = plane.forward(here), b = plane.forward(there);
        const Angle flat = Angle::rad(std::atan2(b.east_m - a.east_m, b.north_m - a.north_m));
        const Angle expected = geo::geodesic(here, there).azimuth - convergence;
        EXPECT_NEAR((flat - expected).wrapped_pi().rad(), 0.0, 2e-6)
            << origin.lat.deg() << " " << origin.lon.deg() << " " << bearing;
      }
    }
  }
}

TEST(LocalProjection, ConvergenceIsNothingAtTheOriginAndFollowsTheSine) {
  const LocalProjection plane(at(60.0, 10.0));
  EXPECT_NEAR(plane.convergence(at(60.0, 10.0)).rad(), 0.0, 1e-9);
  EXPECT_NEAR(plane.convergence(at(60.0, 11.0)).deg(), std::sin(60.0 * kRadPerDeg), 0.01);
}

TEST(LocalProjection, ManyPointsAreThePointsOneByOne) {
  const LocalProjection plane(at(36.9, 129.9));
  std::vector<Geodetic> points;
  for (int i = 0; i < 50'000; ++i) points.push_back(at(36.0 + i * 2e-5, 129.0 + i * 3e-5));
  std::vector<PlanePoint> out(points.size());
  const auto start = std::chrono::steady_clock::now();
  plane.forward(points, out);
  const double ns =
      std::chrono::duration<double, std::nano>(std::chrono::steady_clock::now() - start).count();
  RecordProperty("ns_a_point", std::to_string(ns / static_cast<double>(points.size())));
  for (std::size_t i = 0; i < points.size(); i += 997) EXPECT_EQ(out[i], plane.forward(points[i]));
}

TEST(LocalProjection, CopiesAreOnePlane) {
  const LocalProjection plane(at(36.9, 129.9));
  const LocalProjection copy = plane;
  EXPECT_EQ(copy.forward(at(37, 130)), plane.forward(at(37, 130)));
  EXPECT_EQ(copy.definition(), plane.definition());
  EXPECT_EQ(copy.origin(), plane.origin());
}

}  // namespace
}  // namespace leadline::maps
