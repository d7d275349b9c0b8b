#include "core/types/rotation.h"

#include <gtest/gtest.h>

#include <cmath>
#include <initializer_list>

namespace leadline {
namespace {

using Mount = Rotation<BodyFrame, Instrument>;
using Attitude3 = Rotation<Ned, BodyFrame>;

EulerAngles deg(double roll, double pitch, double heading) {
  return {Angle::deg(roll), Angle::deg(pitch), Angle::deg(heading)};
}

template <class Frame>
void expect_vector(const Vec3<Frame>& v, double x, double y, double z) {
  EXPECT_NEAR(v.x, x, 1e-15);
  EXPECT_NEAR(v.y, y, 1e-15);
  EXPECT_NEAR(v.z, z, 1e-15);
}

TEST(Rotation, SensorTurned45DegreesToStarboard) {
  const Mount mount = Mount::zyx(deg(0, 0, 45));
  expect_vector(mount * Vec3<Instrument>{1, 0, 0}, std::sqrt(0.5), std::sqrt(0.5), 0);
}

TEST(Rotation, HeadingEastPointsTheBowEast) {
  expect_vector(Attitude3::zyx(deg(0, 0, 90)) * Vec3<BodyFrame>{1, 0, 0}, 0, 1, 0);
}

TEST(Rotation, PositivePitchRaisesTheBow) {
  expect_vector(Attitude3::zyx(deg(0, 30, 0)) * Vec3<BodyFrame>{1, 0, 0}, std::sqrt(0.75), 0, -0.5);
}

TEST(Rotation, PositiveRollLowersTheStarboardSide) {
  expect_vector(Attitude3::zyx(deg(30, 0, 0)) * Vec3<BodyFrame>{0, 1, 0}, 0, std::sqrt(0.75), 0.5);
}

TEST(Rotation, ZyxIsRollThenPitchThenHeading) {
  const auto all = Attitude3::zyx(deg(10, -20, 130)).matrix();
  const auto steps = (Attitude3::zyx(deg(0, 0, 130)).matrix() * Attitude3::zyx(deg(0, -20, 0)).matrix() *
                      Attitude3::zyx(deg(10, 0, 0)).matrix())
                         .eval();
  EXPECT_LT((all - steps).cwiseAbs().maxCoeff(), 1e-15);
}

TEST(Rotation, EulerAnglesComeBack) {
  for (double roll = -179; roll < 180; roll += 17.9)
    for (double pitch = -89.9; pitch < 90; pitch += 8.99)
      for (double heading = 0; heading < 360; heading += 23.7) {
        const EulerAngles e = Attitude3::zyx(deg(roll, pitch, heading)).euler();
        ASSERT_NEAR(e.roll.deg(), roll, 1e-9);
        ASSERT_NEAR(e.pitch.deg(), pitch, 1e-9);
        ASSERT_NEAR((e.heading - Angle::deg(heading)).wrapped_pi().deg(), 0.0, 1e-9);
        ASSERT_GE(e.heading.rad(), 0.0);
        ASSERT_LT(e.heading.rad(), 2 * kPi);
      }
}

TEST(Rotation, EulerOfABowStraightUpIsFinite) {
  for (const double pitch : {90.0, -90.0}) {
    const EulerAngles e = Attitude3::zyx(deg(0, pitch, 0)).euler();
    EXPECT_NEAR(e.pitch.deg(), pitch, 1e-6);
    EXPECT_TRUE(std::isfinite(e.roll.rad()) && std::isfinite(e.heading.rad()));
  }
  // A matrix whose element is a rounding beyond 1.
  Eigen::Matrix3d m = Eigen::Matrix3d::Zero();
  m(2, 0) = -1.0 - 1e-15;
  EXPECT_DOUBLE_EQ(Attitude3(m).euler().pitch.deg(), 90.0);
}

TEST(Rotation, InverseTakesVectorsBack) {
  const Mount mount = Mount::zyx(deg(3, -4, 222));
  const Rotation<Instrument, BodyFrame> back = mount.inverse();
  const Vec3<Instrument> v = back * (mount * Vec3<Instrument>{1, -2, 3});
  EXPECT_NEAR(v.x, 1, 1e-14);
  EXPECT_NEAR(v.y, -2, 1e-14);
  EXPECT_NEAR(v.z, 3, 1e-14);
}

TEST(Rotation, IsOrthonormalAndRightHanded) {
  const auto m = Attitude3::zyx(deg(12, 34, 56)).matrix();
  EXPECT_LT((m * m.transpose() - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff(), 1e-15);
  EXPECT_NEAR(m.determinant(), 1.0, 1e-15);
  EXPECT_EQ(Attitude3().matrix(), Eigen::Matrix3d::Identity());
}

}  // namespace
}  // namespace leadline
