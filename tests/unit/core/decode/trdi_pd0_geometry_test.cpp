#include "core/decode/trdi_pd0_geometry.h"

#include <gtest/gtest.h>

#include <cmath>

namespace leadline {
namespace {

using decode::pd0_from_beams;
using decode::pd0_vehicle_velocity;
using Beams = std::array<std::optional<double>, 4>;

constexpr double kExact = 1e-12;
const Angle kThirty = Angle::deg(30.0);

/// Radial velocities, positive towards the transducer, that a vehicle moving in a straight line makes with a
/// convex head. Each beam looks down (or up) and outwards: 1 to port of a down-facing head, 2 to starboard,
/// 3 forward, 4 aft. Independent of the code under test: the speed at which the vehicle nears the bottom.
Beams closing_speeds(const Vec3<Instrument>& v, Angle t, bool up_facing) {
  const double side = up_facing ? -1.0 : 1.0;  // the head is rolled over its forward axis
  const double s = sin(t), z = up_facing ? -cos(t) : cos(t);
  return {v.y * -side * s + v.z * z, v.y * side * s + v.z * z, v.x * s + v.z * z, -v.x * s + v.z * z};
}

Vec3<Instrument> through(const Vec3<Instrument>& v, bool up_facing) {
  const auto bottom = pd0_from_beams(closing_speeds(v, kThirty, up_facing), kThirty, true, false);
  EXPECT_TRUE(bottom);
  EXPECT_NEAR(bottom->error_mps.value_or(1.0), 0.0, kExact);
  return pd0_vehicle_velocity(*bottom, up_facing);
}

void expect_near(const Vec3<Instrument>& a, const Vec3<Instrument>& b) {
  EXPECT_NEAR(a.x, b.x, kExact);
  EXPECT_NEAR(a.y, b.y, kExact);
  EXPECT_NEAR(a.z, b.z, kExact);
}

TEST(Pd0Geometry, ADownFacingHeadGivesBackEachDirectionOfTravel) {
  for (const Vec3<Instrument>& v : {Vec3<Instrument>{1.5, 0, 0}, {0, 0.7, 0}, {0, 0, 0.3}, {1.5, -0.7, 0.3}})
    expect_near(through(v, false), v);
}

TEST(Pd0Geometry, AnUpFacingHeadIsRolledOverItsForwardAxis) {
  for (const Vec3<Instrument>& v : {Vec3<Instrument>{1.5, 0, 0}, {0, 0.7, 0}, {0, 0, 0.3}, {1.5, -0.7, 0.3}})
    expect_near(through(v, true), v);
}

TEST(Pd0Geometry, SignsAreThoseOfTheDevicesGuide) {
  // Beam 3 leading makes y negative, beam 2 leading makes x negative, the bottom coming nearer makes z
  // positive.
  EXPECT_LT(pd0_from_beams(closing_speeds({1, 0, 0}, kThirty, false), kThirty, true, false)->y_mps, -0.99);
  EXPECT_LT(pd0_from_beams(closing_speeds({0, 1, 0}, kThirty, false), kThirty, true, false)->x_mps, -0.99);
  EXPECT_GT(pd0_from_beams(closing_speeds({0, 0, 1}, kThirty, false), kThirty, true, false)->z_mps, 0.99);
}

TEST(Pd0Geometry, ABowDownSinkReachesTheForwardBeamFirst) {
  // Beam 3 closes faster than beam 4: forward and down, nothing to the side.
  const auto v = pd0_vehicle_velocity(*pd0_from_beams({0.4, 0.4, 0.6, 0.2}, kThirty, true, false), false);
  EXPECT_GT(v.x, 0.0);
  EXPECT_NEAR(v.y, 0.0, kExact);
  EXPECT_GT(v.z, 0.0);
}

TEST(Pd0Geometry, AConcaveHeadChangesTheSignOfXAndYOnly) {
  const Beams beams = {0.31, -0.12, 0.55, -0.48};
  const auto convex = pd0_from_beams(beams, kThirty, true, false),
             concave = pd0_from_beams(beams, kThirty, false, false);
  EXPECT_DOUBLE_EQ(concave->x_mps, -convex->x_mps);
  EXPECT_DOUBLE_EQ(concave->y_mps, -convex->y_mps);
  EXPECT_DOUBLE_EQ(concave->z_mps, convex->z_mps);
  EXPECT_DOUBLE_EQ(*concave->error_mps, *convex->error_mps);
}

TEST(Pd0Geometry, ThreeConsistentBeamsGiveWhatFourGiveButNoErrorVelocity) {
  const Vec3<Instrument> v = {1.2, -0.4, 0.1};
  const Beams four = closing_speeds(v, Angle::deg(20), false);
  for (std::size_t gap = 0; gap < 4; ++gap) {
    Beams three = four;
    three[gap].reset();
    const auto bottom = pd0_from_beams(three, Angle::deg(20), true, true);
    ASSERT_TRUE(bottom) << gap;
    EXPECT_FALSE(bottom->error_mps);
    expect_near(pd0_vehicle_velocity(*bottom, false), v);
    EXPECT_FALSE(pd0_from_beams(three, Angle::deg(20), true, false))
        << "the device does not allow three beams";
  }
}

TEST(Pd0Geometry, TwoBeamsOrNoBeamAngleGiveNothing) {
  EXPECT_FALSE(pd0_from_beams({0.1, {}, 0.1, {}}, kThirty, true, true));
  EXPECT_FALSE(pd0_from_beams({0.1, 0.1, 0.1, 0.1}, Angle{}, true, true));
}

TEST(Pd0Geometry, ErrorVelocityIsTheDisagreementOfTheBeamPairs) {
  const auto v = pd0_from_beams({0.10, 0.10, 0.08, 0.08}, kThirty, true, false);
  EXPECT_NEAR(*v->error_mps, 0.04 / (2.0 * std::sqrt(2.0) * 0.5), kExact);
}

}  // namespace
}  // namespace leadline
