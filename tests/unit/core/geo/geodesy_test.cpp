#include "core/geo/geodesy.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace leadline::geo {
namespace {

Geodetic at(double lat_deg, double lon_deg) { return {Angle::deg(lat_deg), Angle::deg(lon_deg)}; }

double length(NorthEast v) { return std::hypot(v.north_m, v.east_m); }
double distance(NorthEast a, NorthEast b) { return std::hypot(a.north_m - b.north_m, a.east_m - b.east_m); }

/// Where the geodesic says `to` is: distance and azimuth as a vector.
NorthEast by_geodesic(Geodetic from, Geodetic to) {
  const GeodesicLine line = geodesic(from, to);
  return {line.distance_m * cos(line.azimuth), line.distance_m * sin(line.azimuth)};
}

class Places {
 public:
  Geodetic place() { return at(between(-89.9, 89.9), between(-180.0, 180.0)); }
  NorthEast step(double length_m) {
    const double azimuth = between(0.0, 2.0 * kPi);
    return {length_m * std::cos(azimuth), length_m * std::sin(azimuth)};
  }
  double between(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random_);
  }

 private:
  std::mt19937_64 random_{20250101};
};

double worst_against_geodesic(double length_m) {
  Places places;
  double worst = 0.0;
  for (int i = 0; i < 5000; ++i) {
    const Geodetic from = places.place();
    const NorthEast step = places.step(length_m);
    worst = std::fmax(worst, distance(step, by_geodesic(from, displaced(from, step.north_m, step.east_m))));
  }
  return worst;
}

double worst_round_trip(double length_m) {
  Places places;
  double worst = 0.0;
  for (int i = 0; i < 5000; ++i) {
    const Geodetic from = places.place();
    const NorthEast step = places.step(length_m);
    const double height = places.between(-11000.0, 9000.0);
    const Geodetic to = displaced(from, step.north_m, step.east_m, height);
    worst = std::fmax(worst, distance(step, difference(from, to, height)));
  }
  return worst;
}

TEST(Radii, AreThoseOfTheEllipsoidAtEquatorAndPole) {
  EXPECT_NEAR(radii(Angle::deg(0)).meridian_m, 6335439.3272928, 1e-6);
  EXPECT_NEAR(radii(Angle::deg(0)).prime_vertical_m, 6378137.0, 1e-6);
  EXPECT_NEAR(radii(Angle::deg(90)).meridian_m, 6399593.6257585, 1e-6);
  EXPECT_NEAR(radii(Angle::deg(-90)).prime_vertical_m, 6399593.6257585, 1e-6);
}

TEST(Radii, AreTheSlopesOfTheGeodesic) {
  for (double lat = -80.0; lat <= 80.0; lat += 20.0) {
    const Radii r = radii(Angle::deg(lat));
    EXPECT_NEAR(geodesic(at(lat - 0.01, 5), at(lat + 0.01, 5)).distance_m / (0.02 * kRadPerDeg), r.meridian_m,
                1.0);
    EXPECT_NEAR(geodesic(at(lat, 5), at(lat, 5.001)).distance_m / (0.001 * kRadPerDeg),
                r.prime_vertical_m * cos(Angle::deg(lat)), 0.01);
  }
}

// The bounds are s^3/6R^2 with the smallest radius of curvature, 6335 km, and 20 nm for the geodesic itself.
TEST(Displaced, FollowsTheGeodesicToTheCubeOfTheStep) {
  EXPECT_LT(worst_against_geodesic(1.0), 2e-8);
  EXPECT_LT(worst_against_geodesic(100.0), 3e-8);
  EXPECT_LT(worst_against_geodesic(1e3), 4.3e-6);
  EXPECT_LT(worst_against_geodesic(5e3), 0.53e-3);
  EXPECT_LT(worst_against_geodesic(9.99e3), 4.2e-3);
  EXPECT_LT(worst_against_geodesic(1e6), 1e-6);
}

TEST(Displaced, NorthAndEastAreNotSwapped) {
  const Geodetic from = at(45, 10);
  const Geodetic north = displaced(from, 1000, 0), east = displaced(from, 0, 1000);
  EXPECT_NEAR(north.lat.deg() - 45.0, 1000.0 / radii(Angle::deg(45)).meridian_m * kDegPerRad, 1e-6);
  EXPECT_NEAR(north.lon.deg(), 10.0, 1e-12);
  EXPECT_NEAR(east.lon.deg() - 10.0, 1000.0 / (6388838.29 * std::sqrt(0.5)) * kDegPerRad, 1e-6);
  EXPECT_LT(std::abs(east.lat.deg() - 45.0), 1e-6);
}

TEST(Displaced, NoStepIsNoMove) {
  for (const Geodetic from : {at(0, 0), at(-33, 179.999), at(89.9, -180), at(90, 0), at(-90, 12)}) {
    const Geodetic to = displaced(from, 0, 0);
    EXPECT_EQ(to, from);
    EXPECT_EQ(length(difference(from, from)), 0.0);
  }
}

TEST(Displaced, HeightAboveTheEllipsoidShortensTheAngle) {
  const Geodetic from = at(30, 0);
  const Radii r = radii(from.lat);
  const double low = displaced(from, 100, 0).lat.rad() - from.lat.rad();
  const double high = displaced(from, 100, 0, 5000).lat.rad() - from.lat.rad();
  EXPECT_NEAR(low / high, 1.0 + 5000.0 / r.meridian_m, 1e-9);
  const double west = displaced(from, 0, -100, -5000).lon.rad();
  EXPECT_NEAR(west, -100.0 / ((r.prime_vertical_m - 5000.0) * cos(from.lat)), 1e-14);
}

TEST(Displaced, CrossesTheDateLineBothWays) {
  const Geodetic east = displaced(at(-17, 179.999), 0, 500), west = displaced(at(-17, -179.999), 0, -500);
  EXPECT_LT(east.lon.deg(), -179.99);
  EXPECT_GE(east.lon.deg(), -180.0);
  EXPECT_GT(west.lon.deg(), 179.99);
  EXPECT_LT(west.lon.deg(), 180.0);
}

TEST(Displaced, ResultIsAlwaysALegalPosition) {
  Places places;
  for (int i = 0; i < 5000; ++i) {
    const Geodetic from = at(places.between(89.0, 90.0) * (i % 2 ? 1 : -1), places.between(-180.0, 180.0));
    const NorthEast step = places.step(places.between(0.0, 30e3));
    const Geodetic to = displaced(from, step.north_m, step.east_m);
    ASSERT_LE(std::abs(to.lat.rad()), kPi / 2.0);
    ASSERT_GE(to.lon.rad(), -kPi);
    ASSERT_LT(to.lon.rad(), kPi);
  }
}

TEST(Displaced, PassesOverThePole) {
  const Geodetic from = at(89.99, 20);  // 1117 m from the pole
  const Geodetic to = displaced(from, 2000, 0);
  EXPECT_NEAR(to.lon.deg(), -160.0, 1e-9);
  EXPECT_NEAR(geodesic(from, to).distance_m, 2000.0, 1e-4);
  EXPECT_NEAR(difference(from, to).north_m, 2000.0, 2e-9);
}

TEST(Displaced, IsAsGoodAtTheEdgeOfThePoleAsElsewhere) {
  const Geodetic from = at(89.9, 100);
  const Geodetic to = displaced(from, 300, -900);
  EXPECT_LT(distance({300, -900}, by_geodesic(from, to)), 5e-6);
}

// Storage rounds a latitude to 0.7e-9 m and a longitude to 1.4e-9 m, so no inverse comes nearer.
TEST(Difference, UndoesDisplacedToTheLastBitOfAPosition) {
  for (const double length_m : {1e-3, 1.0, 30.0, 1e3, 9.9e3})
    EXPECT_LT(worst_round_trip(length_m), 2e-9) << length_m;
}

TEST(Difference, IsAsFineAcrossTheDateLine) {
  Places places;
  for (int i = 0; i < 5000; ++i) {
    const double side = i % 2 ? 1.0 : -1.0;
    const Geodetic from = at(places.between(-70.0, 70.0), side * 179.9999);
    const double east_m = side * places.between(40.0, 900.0);
    const Geodetic to = displaced(from, 0.0, east_m);
    ASSERT_LT(side * to.lon.rad(), 0.0);
    ASSERT_NEAR(difference(from, to).east_m, east_m, 2e-9);
  }
}

// A step due east moves the latitude by less than a bit: noise of the coordinates would show as north.
TEST(Difference, AnEastwardStepKeepsItsNorthToHalfABitOfLatitude) {
  Places places;
  for (int i = 0; i < 5000; ++i) {
    const Geodetic from = places.place();
    ASSERT_NEAR(difference(from, displaced(from, 0.0, 1e-3)).north_m, 0.0, 1e-10);
    ASSERT_NEAR(difference(from, displaced(from, 0.0, 200.0)).north_m, 0.0, 0.75e-9);
  }
}

TEST(Difference, UndoesDisplacedToAMillionthAtAnyDistance) {
  for (const double length_m : {10e3, 10.02e3, 100e3, 5000e3})
    EXPECT_LT(worst_round_trip(length_m) / length_m, 1e-6) << length_m;
}

TEST(Difference, DoesNotTakeTheOtherSideOfTheEarthForHere) {
  EXPECT_GT(length(difference(at(10, 20), at(-10, -160))), 19e6);
  EXPECT_GT(length(difference(at(90, 0), at(-90, 0))), 19e6);
}

TEST(Geodesic, MeasuresOneDegreeOfEquatorAndOfMeridian) {
  EXPECT_NEAR(geodesic(at(0, 0), at(0, 1)).distance_m, 6378137.0 * kRadPerDeg, 1e-6);
  EXPECT_NEAR(geodesic(at(0, 0), at(0, 1)).azimuth.deg(), 90.0, 1e-9);
  EXPECT_NEAR(geodesic(at(0, 0), at(90, 0)).distance_m, 10001965.729, 1e-3);
  EXPECT_NEAR(geodesic(at(0, 1), at(0, 0)).azimuth.deg(), 270.0, 1e-9);
}

TEST(Geodesic, IsTheLongFlightFromNewYorkToLondon) {  // GeographicLib's GeodSolve: JFK to LHR
  const GeodesicLine line = geodesic(at(40.6, -73.8), at(51.6, -0.5));
  EXPECT_NEAR(line.distance_m, 5551759.400, 1e-3);
  EXPECT_NEAR(line.azimuth.deg(), 51.19888, 1e-4);
}

TEST(NormalLongitude, KeepsWhatIsLegalAndTurnsWhatIsNot) {
  EXPECT_EQ(normal_longitude(Angle::rad(-kPi)), Angle::rad(-kPi));
  EXPECT_EQ(normal_longitude(Angle::rad(3.1)), Angle::rad(3.1));
  EXPECT_EQ(normal_longitude(Angle::rad(kPi)), Angle::rad(-kPi));
  EXPECT_NEAR(normal_longitude(Angle::deg(300)).deg(), -60.0, 1e-12);
  EXPECT_NEAR(normal_longitude(Angle::deg(-541)).deg(), 179.0, 1e-12);
}

}  // namespace
}  // namespace leadline::geo
