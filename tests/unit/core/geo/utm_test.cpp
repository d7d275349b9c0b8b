#include "core/geo/utm.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <random>

#include "core/geo/geodesy.h"

namespace leadline::geo {
namespace {

using testing::HasSubstr;

Geodetic at(double lat_deg, double lon_deg) { return {Angle::deg(lat_deg), Angle::deg(lon_deg)}; }

TEST(Utm, BaghdadIsWhereGeographicLibPutsIt) {  // the example of GeographicLib's GeoConvert
  const auto utm = to_utm(at(33.3, 44.4));
  ASSERT_TRUE(utm.ok());
  EXPECT_EQ(utm.value().zone, 38);
  EXPECT_TRUE(utm.value().north);
  EXPECT_NEAR(utm.value().easting_m, 444140.54, 0.005);
  EXPECT_NEAR(utm.value().northing_m, 3684706.36, 0.005);
}

TEST(Utm, CentralMeridianHasScale09996AndNoConvergence) {
  const Utm utm = to_utm(at(50, 9)).value();
  EXPECT_EQ(utm.zone, 32);
  EXPECT_NEAR(utm.easting_m, 500e3, 1e-6);
  EXPECT_NEAR(utm.scale, 0.9996, 1e-12);
  EXPECT_NEAR(utm.convergence.deg(), 0.0, 1e-12);
}

TEST(Utm, SouthCountsFromTenThousandKilometres) {
  const Utm utm = to_utm(at(-0.001, 9)).value();
  EXPECT_FALSE(utm.north);
  EXPECT_NEAR(utm.northing_m, 10e6 - 110.57, 0.1);
}

TEST(Utm, ConvergenceTurnsAGridHeadingIntoATrueOne) {
  const Utm here = to_utm(at(60, 11)).value();  // east of the central meridian, 9 degrees
  const Geodetic grid_north = from_utm(here.zone, true, here.easting_m, here.northing_m + 100).value();
  const Angle azimuth = geodesic(at(60, 11), grid_north).azimuth;
  EXPECT_NEAR(azimuth.wrapped_pi().deg(), here.convergence.deg(), 1e-4);
  EXPECT_GT(here.convergence.deg(), 1.7);
}

TEST(Utm, NorwayAndSvalbardHaveTheirOwnZones) {
  EXPECT_EQ(to_utm(at(60, 4)).value().zone, 32);
  EXPECT_EQ(to_utm(at(78, 20)).value().zone, 33);
}

TEST(Utm, AZoneAskedForIsKeptAcrossItsEdge) {
  const Utm utm = to_utm(at(50, 12.1), 32).value();  // zone 33 by rights
  EXPECT_EQ(utm.zone, 32);
  EXPECT_GT(utm.easting_m, 721e3);
  EXPECT_LT(geodesic(from_utm(32, true, utm.easting_m, utm.northing_m).value(), at(50, 12.1)).distance_m,
            1e-7);
}

TEST(Utm, ReverseUndoesForward) {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> lat(-79.9, 83.9), lon(-180.0, 180.0);
  for (int i = 0; i < 5000; ++i) {
    const Geodetic point = at(lat(random), lon(random));
    const Utm utm = to_utm(point).value();
    const Geodetic back = from_utm(utm.zone, utm.north, utm.easting_m, utm.northing_m).value();
    ASSERT_LT(geodesic(point, back).distance_m, 3e-8);
    ASSERT_GE(back.lon.rad(), -kPi);
    ASSERT_LT(back.lon.rad(), kPi);
  }
}

TEST(Utm, PolarLatitudesAreRefusedByName) {
  for (const Geodetic point : {at(84.5, 0), at(-80.5, 0), at(90, 0)}) {
    const auto utm = to_utm(point, 31);
    ASSERT_FALSE(utm.ok());
    EXPECT_THAT(utm.error().line(), HasSubstr("UPS"));
    EXPECT_FALSE(to_utm(point).ok());
  }
}

TEST(Utm, ZonesThatDoNotExistAreRefused) {
  for (const int zone : {-4, -1, 0, 61}) {
    EXPECT_FALSE(to_utm(at(50, 9), zone).ok()) << zone;
    EXPECT_FALSE(from_utm(zone, true, 500e3, 5e6).ok()) << zone;
  }
  EXPECT_THAT(from_utm(0, true, 2e6, 2e6).error().line(), HasSubstr("UPS"));
  EXPECT_THAT(from_utm(61, true, 5e5, 5e6).error().line(), HasSubstr("61"));
}

TEST(Utm, WhatTheLibraryThrowsComesBackAsAnError) {
  EXPECT_FALSE(to_utm(at(50, 120), 32).ok());
  EXPECT_FALSE(from_utm(32, true, 5e6, 5e5).ok());
  EXPECT_FALSE(from_utm(32, true, std::numeric_limits<double>::quiet_NaN(), 5e6).ok());
  EXPECT_FALSE(to_utm({Angle::rad(std::numeric_limits<double>::quiet_NaN()), {}}).ok());
}

}  // namespace
}  // namespace leadline::geo
