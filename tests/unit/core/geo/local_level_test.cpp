#include "core/geo/local_level.h"

#include <gtest/gtest.h>

#include <random>

#include "core/geo/geodesy.h"

namespace leadline::geo {
namespace {

Geodetic at(double lat_deg, double lon_deg) { return {Angle::deg(lat_deg), Angle::deg(lon_deg)}; }

TEST(LocalLevel, CalaisSeenFromParis) {  // the example of GeographicLib's CartConvert
  const LocalLevel paris(at(48.0 + 50.0 / 60.0, 2.0 + 20.0 / 60.0), {0.0});
  const auto calais = paris.forward(at(50.9, 1.8), {0.0});
  EXPECT_NEAR(calais.x, 229949.65, 0.005);
  EXPECT_NEAR(calais.y, -37518.64, 0.005);
  EXPECT_NEAR(calais.z, 4260.43, 0.005);
}

TEST(LocalLevel, DownIsDownAtTheOrigin) {
  const LocalLevel level(at(-40, 170), {12.0});
  const auto below = level.forward(at(-40, 170), {-88.0});
  EXPECT_NEAR(below.x, 0.0, 1e-8);
  EXPECT_NEAR(below.y, 0.0, 1e-8);
  EXPECT_NEAR(below.z, 100.0, 1e-8);
  EXPECT_EQ(level.origin().position, at(-40, 170));
  EXPECT_EQ(level.origin().height.m, 12.0);
}

TEST(LocalLevel, ReverseUndoesForwardAcrossTheDateLine) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> lat(-89.0, 89.0), lon(179.0, 181.0), away(-20e3, 20e3),
      down(-100.0, 6000.0);
  for (int i = 0; i < 2000; ++i) {
    const LocalLevel level({Angle::deg(lat(random)), normal_longitude(Angle::deg(lon(random)))}, {30.0});
    const Vec3<LocalLevelFrame> v{away(random), away(random), down(random)};
    const LocalLevel::Place place = level.reverse(v);
    ASSERT_GE(place.position.lon.rad(), -kPi);
    ASSERT_LT(place.position.lon.rad(), kPi);
    const auto back = level.forward(place.position, place.height);
    ASSERT_LT((back - v).eigen().norm(), 2e-8);
  }
}

TEST(LocalLevel, AgreesWithTheSmallDifferenceNearTheOrigin) {
  const Geodetic origin = at(60, 5), near = at(60.001, 5.002);
  const auto v = LocalLevel(origin, {0.0}).forward(near, {0.0});
  const NorthEast d = difference(origin, near);
  EXPECT_NEAR(v.x, d.north_m, 1e-7);
  EXPECT_NEAR(v.y, d.east_m, 1e-7);
}

}  // namespace
}  // namespace leadline::geo
