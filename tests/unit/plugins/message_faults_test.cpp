#include "plugins/host/message_faults.h"

#include <gtest/gtest.h>

#include <functional>
#include <limits>

#include "tests/unit/plugins/facts.h"

namespace leadline {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInf = std::numeric_limits<double>::infinity();

Solution full_solution() {
  Solution s{.engine = 1, .position = {Angle::deg(59), Angle::deg(5)}, .depth = Depth{10}};
  s.roll = s.pitch = s.heading = Angle::deg(1);
  s.vel_north_mps = s.vel_east_mps = s.vel_down_mps = 1.0;
  s.var_north_m2 = s.var_east_m2 = 4.0;
  s.cov_north_east_m2 = -1.0;
  s.sd_down_m = 1.0;
  s.sd_heading = s.heading_bias = Angle::deg(1);
  s.mode = Mode::E0;
  s.position_source = PositionSource::usbl;
  return s;
}

TEST(MessageFaults, EveryNumberOfASolutionIsLookedAt) {
  const Time now = test::at_s(0);
  ASSERT_EQ(fault_of_engine(full_solution(), now, 1), "");
  const std::vector<std::function<void(Solution&, double)>> numbers{
      [](Solution& s, double x) { s.position.lat = Angle::rad(x); },
      [](Solution& s, double x) { s.position.lon = Angle::rad(x); },
      [](Solution& s, double x) { s.depth = Depth{x}; },
      [](Solution& s, double x) { s.roll = Angle::rad(x); },
      [](Solution& s, double x) { s.pitch = Angle::rad(x); },
      [](Solution& s, double x) { s.heading = Angle::rad(x); },
      [](Solution& s, double x) { s.vel_north_mps = x; },
      [](Solution& s, double x) { s.vel_east_mps = x; },
      [](Solution& s, double x) { s.vel_down_mps = x; },
      [](Solution& s, double x) { s.var_north_m2 = x; },
      [](Solution& s, double x) { s.cov_north_east_m2 = x; },
      [](Solution& s, double x) { s.var_east_m2 = x; },
      [](Solution& s, double x) { s.sd_down_m = x; },
      [](Solution& s, double x) { s.sd_heading = Angle::rad(x); },
      [](Solution& s, double x) { s.heading_bias = Angle::rad(x); },
  };
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    for (const double bad : {kNan, kInf, -kInf}) {
      Solution s = full_solution();
      numbers[i](s, bad);
      EXPECT_EQ(fault_of_engine(s, now, 1), "not finite") << i;
    }
  }
}

TEST(MessageFaults, EveryNumberOfAVerdictIsLookedAt) {
  const FixVerdict good{.engine = 1, .residual_m = 1, .dr_residual_m = 2, .gate_m = 3, .accepted = true};
  EXPECT_EQ(fault_of_engine(good, test::at_s(0), 1), "");
  for (int i = 0; i < 6; ++i) {
    FixVerdict v = good;
    if (i == 0) v.position.lat = Angle::rad(kNan);
    if (i == 1) v.position.lon = Angle::rad(kNan);
    if (i == 2) v.depth = Depth{kNan};
    if (i == 3) v.residual_m = kNan;
    if (i == 4) v.dr_residual_m = kInf;
    if (i == 5) v.gate_m = kNan;
    EXPECT_EQ(fault_of_engine(v, test::at_s(0), 1), "not finite") << i;
  }
}

TEST(MessageFaults, WhatNoTypeAllowsIsOutOfRange) {
  const auto with = [](auto change) {
    Solution s = full_solution();
    change(s);
    return fault_of_engine(s, test::at_s(0), 1);
  };
  EXPECT_EQ(with([](Solution& s) { s.position.lat = Angle::deg(90.1); }), "range");
  EXPECT_EQ(with([](Solution& s) { s.position.lon = Angle::deg(361); }), "range");
  EXPECT_EQ(with([](Solution& s) { s.var_north_m2 = -1e-9; }), "range");
  EXPECT_EQ(with([](Solution& s) { s.sd_down_m = -1.0; }), "range");
  EXPECT_EQ(with([](Solution& s) { s.mode = static_cast<Mode>(6); }), "range");
  EXPECT_EQ(with([](Solution& s) { s.position_source = static_cast<PositionSource>(3); }), "range");
  EXPECT_EQ(fault_of_engine(full_solution(), Time{std::numeric_limits<std::int64_t>::min()}, 1), "range");
  EXPECT_EQ(fault_of_engine(ModeChange{.engine = 1, .to = static_cast<Mode>(77)}, test::at_s(0), 1), "range");
}

TEST(MessageFaults, AnEngineSpeaksForItselfOnly) {
  EXPECT_EQ(fault_of_engine(full_solution(), test::at_s(0), 2), "foreign id");
  EXPECT_EQ(fault_of_engine(ModeChange{.engine = 1}, test::at_s(0), 1), "");
  EXPECT_EQ(fault_of_engine(Health{}, test::at_s(0), 1), "");
  EXPECT_EQ(fault_of_engine(Alarm{}, test::at_s(0), 1), "foreign message");
  EXPECT_EQ(fault_of_engine(RawFrame{}, test::at_s(0), 1), "foreign message");
  EXPECT_EQ(fault_of_engine(GnssFix{}, test::at_s(0), 1), "foreign message");
}

TEST(MessageFaults, ADecoderSaysFiniteMeasurementsOnly) {
  EXPECT_EQ(fault_of_decoder(DepthMeasured{.depth = Depth{12}, .sd_m = 0.1}), "");
  EXPECT_EQ(fault_of_decoder(DepthMeasured{.depth = Depth{kNan}}), "not finite");
  EXPECT_EQ(fault_of_decoder(DepthMeasured{.depth = Depth{1}, .sd_m = -1.0}), "range");
  EXPECT_EQ(fault_of_decoder(GnssFix{.position = {Angle::deg(91), {}}}), "range");
  EXPECT_EQ(fault_of_decoder(ImuSample{.accel = {0, kInf, 0}}), "not finite");
  EXPECT_EQ(fault_of_decoder(DvlVelocity{.applied = DvlVelocity::Applied{.pitch = Angle::rad(kNan)}}),
            "not finite");
  EXPECT_EQ(fault_of_decoder(DvlVelocity{.frame = static_cast<DvlFrame>(9)}), "range");
  EXPECT_EQ(fault_of_decoder(BeamRanges{.range_m = {1, 2, 3, kNan}}), "not finite");
  EXPECT_EQ(fault_of_decoder(UsblGrid{.easting_m = kNan}), "not finite");
  EXPECT_EQ(fault_of_decoder(ClockReading{}), "");
  EXPECT_EQ(fault_of_decoder(RawFrame{}), "foreign message");
  EXPECT_EQ(fault_of_decoder(Tick{}), "foreign message");
  EXPECT_EQ(fault_of_decoder(Solution{}), "foreign message");
}

}  // namespace
}  // namespace leadline
