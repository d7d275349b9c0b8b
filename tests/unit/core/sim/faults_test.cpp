#include "core/sim/sensors/faults.h"

#include <gtest/gtest.h>

#include "core/geo/geodesy.h"

namespace leadline::sim {
namespace {

Measurement dvl(double x) {
  DvlMeasurement m;
  m.bottom = true, m.v_s = {x, 0.1, 0.0};
  return m;
}
double x_of(const Measurement& m) { return std::get<DvlMeasurement>(m).v_s.x(); }
double after(Faults& faults, double t_s, double x) {
  Measurement m = dvl(x);
  (void)faults.apply(t_s, m);
  return x_of(m);
}

TEST(Faults, LeaveAloneWhatIsOutsideTheirTime) {
  Faults faults({{.kind = "jump", .from_s = 10.0, .until_s = 20.0, .x_mps = 0.1}});
  EXPECT_DOUBLE_EQ(after(faults, 9.9, 1.0), 1.0);
  EXPECT_DOUBLE_EQ(after(faults, 10.0, 1.0), 1.1);
  EXPECT_DOUBLE_EQ(after(faults, 19.9, 1.0), 1.1);
  EXPECT_DOUBLE_EQ(after(faults, 20.0, 1.0), 1.0);
}

TEST(Faults, AFreezeRepeatsTheLastGoodValue) {
  Faults faults({{.kind = "freeze", .from_s = 10.0, .until_s = 20.0}});
  EXPECT_DOUBLE_EQ(after(faults, 9.0, 1.0), 1.0);
  EXPECT_DOUBLE_EQ(after(faults, 11.0, 2.0), 1.0);
  EXPECT_DOUBLE_EQ(after(faults, 19.0, 3.0), 1.0);
  EXPECT_DOUBLE_EQ(after(faults, 20.0, 4.0), 4.0);
}

TEST(Faults, ASignFlipTurnsVelocityRatesAndTilts) {
  const std::vector<FaultOptions> flip{{.kind = "sign-flip"}};
  Faults a(flip), b(flip), c(flip);
  EXPECT_DOUBLE_EQ(after(a, 0.0, 1.0), -1.0);
  Measurement tilt = AttitudeMeasurement{{Angle::deg(2), Angle::deg(-3), Angle::deg(40)}, 0.0, 0.1, 0, 0};
  (void)b.apply(0.0, tilt);
  const auto& m = std::get<AttitudeMeasurement>(tilt);
  EXPECT_DOUBLE_EQ(m.attitude.roll.deg(), -2.0);
  EXPECT_DOUBLE_EQ(m.attitude.heading.deg(), 40.0);
  EXPECT_DOUBLE_EQ(m.rate_z_rps, -0.1);
  Measurement imu = ImuSample{false, {1, 2, 3}, {4, 5, 6}};
  (void)c.apply(0.0, imu);
  EXPECT_DOUBLE_EQ(std::get<ImuSample>(imu).accel.z, -6.0);
}

TEST(Faults, FalseFixesAreAsManyAsWereAskedForAndCountRepliesOnly) {
  Faults faults({{.kind = "false-fixes", .from_s = 0.0, .count = 3, .east_m = 80.0}});
  int thrown = 0;
  for (int i = 0; i < 12; ++i) {
    UsblMeasurement fix;
    fix.reply = i % 2 == 0;
    fix.position = {Angle::deg(59), Angle::deg(5)};
    Measurement m = fix;
    (void)faults.apply(i, m);
    const auto off = geo::difference(fix.position, std::get<UsblMeasurement>(m).position);
    if (fix.reply && std::abs(off.east_m - 80.0) < 1e-6 && std::abs(off.north_m) < 1e-6) ++thrown;
  }
  EXPECT_EQ(thrown, 3);
}

TEST(Faults, DropoutsCorruptionAndGarbageAreLeftToTheLine) {
  Faults faults({{.kind = "dropout", .from_s = 0, .until_s = 1},
                 {.kind = "corrupt", .from_s = 1, .until_s = 2},
                 {.kind = "garbage", .from_s = 2, .until_s = 3, .bytes = 9}});
  Measurement m = dvl(1.0);
  EXPECT_TRUE(faults.apply(0.5, m).silent);
  EXPECT_TRUE(faults.apply(1.5, m).corrupt);
  EXPECT_EQ(faults.apply(2.5, m).garbage, 9);
  EXPECT_DOUBLE_EQ(x_of(m), 1.0);
}

}  // namespace
}  // namespace leadline::sim
