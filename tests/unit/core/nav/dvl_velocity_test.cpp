#include "core/nav/motion/dvl_velocity.h"

#include <gtest/gtest.h>

#include <cmath>

namespace leadline::nav {
namespace {

DvlVelocity ping(DvlFrame frame, double x, double y, double z) {
  return {.frame = frame,
          .tilt_applied = frame == DvlFrame::earth,
          .x_mps = x,
          .y_mps = y,
          .z_mps = z,
          .valid = true};
}

EulerAngles attitude(double roll_deg, double pitch_deg, double heading_deg) {
  return {Angle::deg(roll_deg), Angle::deg(pitch_deg), Angle::deg(heading_deg)};
}

TEST(DvlVelocity, InstrumentAxesTakeMountCalibrationAndAttitude) {
  SourceInfo source;
  source.mount.heading = Angle::deg(40.0);
  source.calibration.heading = Angle::deg(5.0);
  source.scale = 2.0;
  // The sensor is turned 45 degrees to starboard: its forward motion is forward and to starboard of the body.
  const auto v = velocity_ned(ping(DvlFrame::instrument, 1, 0, 0), source, attitude(0, 0, 0));
  EXPECT_NEAR(v.x, std::sqrt(2.0), 1e-12);
  EXPECT_NEAR(v.y, std::sqrt(2.0), 1e-12);
  // Heading east turns that by 90 degrees.
  const auto east = velocity_ned(ping(DvlFrame::instrument, 1, 0, 0), source, attitude(0, 0, 90));
  EXPECT_NEAR(east.x, -std::sqrt(2.0), 1e-12);
  EXPECT_NEAR(east.y, std::sqrt(2.0), 1e-12);
}

TEST(DvlVelocity, ShipAxesTakeTheCalibrationButNotTheMount) {
  SourceInfo source;
  source.mount.heading = Angle::deg(45.0);
  source.calibration.heading = Angle::deg(90.0);
  const auto v = velocity_ned(ping(DvlFrame::ship, 1, 0, 0), source, attitude(0, 0, 0));
  EXPECT_NEAR(v.x, 0.0, 1e-12);
  EXPECT_NEAR(v.y, 1.0, 1e-12);
}

TEST(DvlVelocity, TiltedAxesAreLevelledOnceAndLevelOnesNever) {
  const SourceInfo source;
  const auto tilts = attitude(0, 30, 0);  // bow up
  const auto raw = velocity_ned(ping(DvlFrame::ship, 1, 0, 0), source, tilts);
  EXPECT_NEAR(raw.x, std::cos(30 * kRadPerDeg), 1e-12);
  EXPECT_NEAR(raw.z, -0.5, 1e-12);  // forward with the bow up is up
  auto level = ping(DvlFrame::ship, 1, 0, 0);
  level.tilt_applied = true;
  const auto untouched = velocity_ned(level, source, tilts);
  EXPECT_NEAR(untouched.x, 1.0, 1e-12);
  EXPECT_NEAR(untouched.z, 0.0, 1e-12);
}

TEST(DvlVelocity, EarthAxesAreTurnedBackByTheDevicesHeadingFirst) {
  const SourceInfo source;
  auto earth = ping(DvlFrame::earth, 0, 1, 0);  // the device took its heading for 90: it moved ahead
  earth.applied = {.heading = Angle::deg(90.0)};
  const auto v = velocity_ned(earth, source, attitude(10, 5, 100));
  EXPECT_NEAR(v.x, std::cos(100 * kRadPerDeg), 1e-12);
  EXPECT_NEAR(v.y, std::sin(100 * kRadPerDeg), 1e-12);
}

}  // namespace
}  // namespace leadline::nav
