#include <algorithm>
#include <cmath>

#include "tests/unit/core/nav/engine_harness.h"

namespace leadline::nav {
namespace {

SourceInfo of(Body body, const std::string& name = "s") {
  SourceInfo info;
  info.name = name;
  info.body = body;
  return info;
}

constexpr SourceId kDvl = 0, kGnss = 1, kSecondGnss = 2;
std::vector<SourceInfo> vehicle() {
  return {of(Body::vehicle, "dvl"), of(Body::vehicle, "gnss"), of(Body::vehicle, "gnss2")};
}

/// A second of a vehicle that goes north at 1 m/s, with a fix of its true position when asked for.
void second(EngineHarness& engine, int t, bool dvl, bool gnss, double off_east_m = 0.0) {
  for (int k = 0; k < 5; ++k) {
    const double now = t + 0.2 * k;
    if (!dvl) break;
    engine.tell(now, heading_deg(0), kDvl);
    engine.tell(now, ahead(1.0), kDvl);
  }
  if (gnss) engine.tell(t + 0.9, gnss_at(t + 0.9, off_east_m), kGnss);
}

TEST(DeadReckoningEngine, StartsAtTheFirstFixAndNeverLooksAtAnother) {
  EngineHarness engine("dead-reckoning", {}, vehicle());
  for (int t = 0; t < 100; ++t) second(engine, t, true, true, t > 10 ? 50.0 : 0.0);
  ASSERT_GT(engine.rows.size(), 400u);
  EXPECT_NEAR(engine.rows.back().north_m, engine.rows.back().t_s, 0.2);
  EXPECT_NEAR(engine.rows.back().east_m, 0.0, 1e-6);
  EXPECT_NEAR(*engine.verdicts.back().residual_m, 50.0, 0.2);
  for (const auto& verdict : engine.verdicts) EXPECT_FALSE(verdict.accepted.has_value());
}

TEST(DeadReckoningEngine, StartsAtTheConfiguredPlaceWithoutAnyFix) {
  Options options;
  options.initial.lat_deg = EngineHarness::place(100, 0).lat.deg();
  options.initial.lon_deg = EngineHarness::place(100, 0).lon.deg();
  options.initial.depth_m = 50.0;
  EngineHarness engine("dead-reckoning", options, vehicle());
  for (int t = 0; t < 10; ++t) second(engine, t, true, false);
  ASSERT_FALSE(engine.rows.empty());
  EXPECT_NEAR(engine.rows.back().north_m, 100.0 + engine.rows.back().t_s, 0.3);
  EXPECT_DOUBLE_EQ(engine.rows.back().solution.depth->m, 50.0);
  EXPECT_EQ(engine.mode(), Mode::E1);
}

Options variant(const std::string& name) {
  Options options;
  options.fusion.variant = name;
  return options;
}

/// What every variant of the filter has to do.
class FusionVariant : public ::testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(All, FusionVariant, ::testing::Values("error-state", "windowed-ci", "plain-ci"),
                         [](const auto& tested) {
                           std::string name = tested.param;
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

TEST_P(FusionVariant, GoesThroughEveryStateAndKeepsItsPosition) {
  EngineHarness engine("fusion", variant(GetParam()), vehicle());
  int t = 0;
  for (; t < 20; ++t) second(engine, t, true, true);
  EXPECT_EQ(engine.mode(), Mode::A);
  for (; t < 40; ++t) second(engine, t, true, false);
  EXPECT_EQ(engine.mode(), Mode::E1);
  const double sd_coasting = std::sqrt(engine.rows.back().solution.var_east_m2);
  for (; t < 60; ++t) second(engine, t, true, true);
  EXPECT_EQ(engine.mode(), Mode::A);
  EXPECT_LE(std::sqrt(engine.rows.back().solution.var_east_m2), sd_coasting);
  for (; t < 80; ++t) second(engine, t, false, true);
  EXPECT_EQ(engine.mode(), Mode::C);
  for (; t < 90; ++t) engine.wait_until(t);
  EXPECT_EQ(engine.mode(), Mode::E0);
  for (; t < 110; ++t) second(engine, t, true, true);
  EXPECT_EQ(engine.mode(), Mode::A);
  for (std::size_t i = 1; i < engine.rows.size(); ++i) {
    EXPECT_NEAR(engine.rows[i].north_m, engine.rows[i].t_s, 1.5) << engine.rows[i].t_s;
    EXPECT_NEAR(engine.rows[i].east_m, 0.0, 0.5);
  }
}

TEST(FusionEngine, SigmaGrowsWhileCoastingAndCoversAMisalignment) {
  for (const char* name : {"error-state", "windowed-ci", "plain-ci"}) {
    Options options = variant(name);
    options.aiding.dvl_misalignment_deg = 5.0;
    EngineHarness engine("fusion", options, vehicle());
    for (int t = 0; t < 10; ++t) second(engine, t, true, true);
    double last = 0.0;
    for (int t = 10; t < 400; ++t) {
      second(engine, t, true, false);
      const double sd = std::sqrt(engine.rows.back().solution.var_east_m2);
      EXPECT_GE(sd, last);
      last = sd;
    }
    const double declared_m = 390 * std::hypot(5.0, 0.3) * kRadPerDeg;
    // Ten fixes have told the filter that estimates it a little of the misalignment.
    if (name == std::string("error-state")) {
      EXPECT_LT(last, declared_m);
      EXPECT_GT(last, 0.6 * declared_m);
    } else {
      EXPECT_NEAR(last, declared_m, 2.0);
    }
  }
}

/// A vehicle that goes round a square of 100 m at 1 m/s; its DVL is turned by mounted_deg.
struct Square {
  Square(EngineHarness& to, double mounted) : engine(to), mounted_deg(mounted) {}
  void second(bool gnss, double latency_s = 0.0) {
    const double heading = 90.0 * (t / 100 % 4);
    const double c = std::cos(heading * kRadPerDeg), s = std::sin(heading * kRadPerDeg);
    for (int k = 0; k < 5; ++k) {
      north += 0.2 * c, east += 0.2 * s;
      engine.tell(t + 0.2 * (k + 1), heading_deg(heading), kDvl);
      engine.tell(t + 0.2 * (k + 1),
                  DvlVelocity{.frame = DvlFrame::ship,
                              .x_mps = std::cos(mounted_deg * kRadPerDeg),
                              .y_mps = -std::sin(mounted_deg * kRadPerDeg),
                              .valid = true},
                  kDvl);
    }
    ++t;
    if (gnss && t > latency_s)
      engine.tell_late(t, t - latency_s, gnss_at(north - c * latency_s, east - s * latency_s), kGnss);
  }
  [[nodiscard]] double error_m() const {
    return std::hypot(engine.rows.back().north_m - north, engine.rows.back().east_m - east);
  }
  EngineHarness& engine;
  double mounted_deg, north = 0.0, east = 0.0;
  int t = 0;
};

TEST(FusionEngine, MisalignmentIsEstimatedStatedAndAllowedFor) {
  for (const double mounted_deg : {0.0, 3.0, -23.0, 45.0, -178.0}) {
    EngineHarness engine("fusion", {}, vehicle());
    Square square(engine, mounted_deg);
    for (int t = 0; t < 600; ++t) square.second(true);
    for (int t = 0; t < 200; ++t) square.second(false);
    const Solution& last = engine.rows.back().solution;
    ASSERT_TRUE(last.heading_bias);
    EXPECT_NEAR((*last.heading_bias - Angle::deg(mounted_deg)).wrapped_pi().deg(), 0.0, 0.2) << mounted_deg;
    EXPECT_LT(square.error_m(), 1.0) << mounted_deg;
    EXPECT_NEAR(std::hypot(*last.vel_north_mps, *last.vel_east_mps), 1.0, 0.01);
    EXPECT_NEAR(*last.vel_east_mps, -1.0, 0.02) << "the velocity is turned as the position's is";
  }
}

TEST(FusionEngine, ALargeMisalignmentIsSaid) {
  EngineHarness engine("fusion", {}, vehicle());
  Square square(engine, -178.0);
  for (int t = 0; t < 400; ++t) square.second(true);
  bool said = false;
  for (const auto& health : engine.health)
    said = said || health.text.view().find("the DVL is turned by -178") != std::string_view::npos;
  EXPECT_TRUE(said);
}

TEST(FusionEngine, OnlyTheErrorStateFilterHasAMisalignment) {
  for (const char* name : {"windowed-ci", "plain-ci"}) {
    EngineHarness engine("fusion", variant(name), vehicle());
    for (int t = 0; t < 10; ++t) second(engine, t, true, true);
    EXPECT_FALSE(engine.rows.back().solution.heading_bias);
  }
}

TEST_P(FusionVariant, ALateFixIsComparedAtItsOwnTime) {
  EngineHarness engine("fusion", variant(GetParam()), vehicle());
  Square square(engine, 0.0);
  for (int t = 0; t < 300; ++t) square.second(true, 2.0);
  EXPECT_LT(square.error_m(), 0.2);
  EXPECT_LT(*engine.verdicts.back().residual_m, 0.2);
}

TEST_P(FusionVariant, PureDeadReckoningStaysKnownBesideTheCorrections) {
  EngineHarness engine("fusion", variant(GetParam()), vehicle());
  Square square(engine, 3.0);
  double largest_m = 0.0;
  for (int t = 0; t < 400; ++t) {
    square.second(true);
    largest_m = std::max(largest_m, engine.verdicts.back().dr_residual_m.value_or(0.0));
  }
  // Half way round the square, 141 m from its start, 3 degrees are 7.4 m.
  EXPECT_NEAR(largest_m, 141.4 * 3.0 * kRadPerDeg, 0.7);
}

TEST_P(FusionVariant, ASingleFalseFixIsRefusedAndSaidSo) {
  EngineHarness engine("fusion", variant(GetParam()), vehicle());
  for (int t = 0; t < 30; ++t) second(engine, t, true, true, t == 20 ? 80.0 : 0.0);
  int refused = 0;
  for (const auto& verdict : engine.verdicts)
    if (verdict.accepted && !*verdict.accepted) {
      ++refused;
      EXPECT_NEAR(*verdict.residual_m, 80.0, 1.0);
      EXPECT_LT(*verdict.gate_m, 7.0);
    }
  EXPECT_EQ(refused, 1);
  EXPECT_NEAR(engine.rows.back().east_m, 0.0, 0.1);
}

TEST_P(FusionVariant, AReturnFarOffIsTakenAfterFixesAgreeAndSaid) {
  EngineHarness engine("fusion", variant(GetParam()), vehicle());
  int t = 0;
  for (; t < 20; ++t) second(engine, t, true, true);
  for (; t < 60; ++t) second(engine, t, true, true, 50.0);  // the DVL saw nothing of these 50 m
  EXPECT_NEAR(engine.rows.back().east_m, 50.0, 1.0);
  ASSERT_EQ(engine.health.size(), 1u);
  EXPECT_NE(engine.health[0].text.view().find("set anew"), std::string_view::npos);
}

TEST(FusionEngine, ASecondGnssThatAgreesServesWhenTheFirstIsLost) {
  EngineHarness engine("fusion", {}, vehicle());
  int t = 0;
  for (; t < 100; ++t) {
    second(engine, t, true, true);
    engine.tell(t + 0.95, gnss_at(t + 0.95, 1.0), kSecondGnss);
  }
  for (; t < 120; ++t) {
    second(engine, t, true, false);
    engine.tell(t + 0.95, gnss_at(t + 0.95, 1.0), kSecondGnss);
  }
  EXPECT_TRUE(engine.verdicts.back().accepted.value_or(false));
  EXPECT_TRUE(engine.health.empty());
}

TEST(FusionEngine, AFixOfTheShipIsNoFixOfTheVehicle) {
  EngineHarness engine("fusion", {}, {of(Body::vehicle), of(Body::ship)});
  engine.tell(1, gnss_at(0, 0), 1);
  ASSERT_EQ(engine.verdicts.size(), 1u);
  EXPECT_FALSE(engine.verdicts[0].accepted.has_value());
  EXPECT_FALSE(engine.verdicts[0].residual_m.has_value());
  EXPECT_TRUE(engine.rows.empty());
}

TEST_P(FusionVariant, UsblIsPlacedFromTheShipAndUsedWithoutGnss) {
  // Ship at rest heading east; the transponder 100 m on her starboard side, that is south.
  EngineHarness engine("fusion", variant(GetParam()),
                       {of(Body::vehicle, "dvl"), of(Body::ship, "ship"), of(Body::vehicle, "usbl")});
  for (int t = 0; t < 60; ++t) {
    engine.tell(t, gnss_at(0, 0), 1);
    engine.tell(t, heading_deg(90), 1);
    for (int k = 0; k < 5; ++k) {
      engine.tell(t + 0.1 + 0.2 * k, heading_deg(0), 0);
      engine.tell(t + 0.1 + 0.2 * k, ahead(0.0), 0);
    }
    if (t % 8 == 0) engine.tell(t + 0.95, UsblRelative{.x_m = 0.0, .y_m = 100.0, .down_m = 40.0}, 2);
  }
  EXPECT_EQ(engine.mode(), Mode::B);
  ASSERT_FALSE(engine.rows.empty());
  EXPECT_NEAR(engine.rows.back().north_m, -100.0, 0.1);
  EXPECT_NEAR(engine.rows.back().east_m, 0.0, 0.1);
  EXPECT_EQ(engine.rows.back().solution.position_source, PositionSource::usbl);
}

TEST(UsblFixes, TheTransceiversPlaceOnTheShipIsAllowedForOnce) {
  // As above, with the transceiver 7 m forward on the ship: 7 m east of her reference point.
  std::vector<SourceInfo> sources{of(Body::vehicle, "dvl"), of(Body::ship, "ship"),
                                  of(Body::vehicle, "usbl")};
  sources[2].lever = {7.0, 0.0, 5.0};
  for (const char* name : {"fusion", "dead-reckoning"}) {
    EngineHarness engine(name, {}, sources);
    for (int t = 0; t < 60; ++t) {
      engine.tell(t, gnss_at(0, 0), 1);
      engine.tell(t, heading_deg(90), 1);
      for (int k = 0; k < 5; ++k) {
        engine.tell(t + 0.1 + 0.2 * k, heading_deg(0), 0);
        engine.tell(t + 0.1 + 0.2 * k, ahead(0.0), 0);
      }
      if (t % 8 == 0) engine.tell(t + 0.95, UsblRelative{.x_m = 0.0, .y_m = 100.0, .down_m = 40.0}, 2);
    }
    EXPECT_NEAR(engine.rows.back().north_m, -100.0, 0.1) << name;
    EXPECT_NEAR(engine.rows.back().east_m, 7.0, 0.1) << name;
  }
}

TEST_P(FusionVariant, AntennaIsBroughtToTheReferencePoint) {
  auto sources = vehicle();
  sources[kGnss].lever = {10.0, 0.0, -2.0};  // the antenna is 10 m forward
  EngineHarness engine("fusion", variant(GetParam()), sources);
  for (int t = 0; t < 20; ++t) {
    engine.tell(t, heading_deg(90), kDvl);
    engine.tell(t, ahead(0.0), kDvl);
    engine.tell(t + 0.5, gnss_at(0, 10), kGnss);
  }
  EXPECT_NEAR(engine.rows.back().east_m, 0.0, 1e-3);
}

TEST(FusionEngine, OutputRateIsAtMostTheConfigured) {
  Options options;
  options.navigation.output_hz = 1.0;
  EngineHarness engine("fusion", options, vehicle());
  for (int t = 0; t < 50; ++t) second(engine, t, true, true);
  EXPECT_NEAR(static_cast<double>(engine.rows.size()), 49.0, 2.0);
}

TEST(Engines, AnUnknownNameIsRefusedWithTheKnownOnes) {
  const auto engine = make_engine("kalman", {});
  ASSERT_FALSE(engine.ok());
  EXPECT_NE(engine.error().line().find("fusion"), std::string::npos);
}

}  // namespace
}  // namespace leadline::nav
