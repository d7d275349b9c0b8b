#include <cmath>

#include "tests/unit/core/nav/engine_harness.h"
#include "tests/unit/core/nav/simulated_survey.h"

namespace leadline::nav {
namespace {

constexpr SourceId kCompass = 0, kDvl = 1, kGnss = 2, kUsbl = 3;

std::vector<SourceInfo> vehicle() {
  std::vector<SourceInfo> sources(4);
  const char* names[] = {"compass", "dvl", "gnss", "usbl"};
  for (std::size_t i = 0; i < sources.size(); ++i) sources[i].name = names[i];
  return sources;
}

Options options() {
  Options options;
  options.aiding.gnss_drms_m = 0.42;
  options.aiding.heading_noise_deg = 0.5;
  return options;
}

/// A vehicle on the surface at 0.5 m/s on one course, whose compass shows too little by bias_deg.
struct CourseRun {
  CourseRun(EngineHarness& to, double course, double bias) : engine(to), course_deg(course), bias_deg(bias) {}
  void second(bool gnss, double latency_s = 0.0) {
    const double c = std::cos(course_deg * kRadPerDeg), s = std::sin(course_deg * kRadPerDeg);
    for (int k = 1; k <= 10; ++k) {
      const double now = t + 0.1 * k;
      north += 0.05 * c, east += 0.05 * s;
      Heading heading = heading_deg(0);
      heading.heading = Angle::deg(course_deg - bias_deg + 0.5 * random.normal()).wrapped_2pi();
      heading.reference = reference;
      engine.tell(now, heading, kCompass);
      engine.tell(now, Rates{0.0005 * random.normal()}, kCompass);
      if (k % 3 == 0) engine.tell(now, ahead(0.5), kDvl);
    }
    ++t;
    if (!gnss) return;
    const Eigen::Vector2d noise = 0.1 * random.normal2();
    engine.tell_late(t, t - latency_s,
                     gnss_at(north - 0.5 * c * latency_s + noise.x(), east - 0.5 * s * latency_s + noise.y()),
                     kGnss);
  }
  [[nodiscard]] double error_m() const {
    return std::hypot(engine.rows.back().north_m - north, engine.rows.back().east_m - east);
  }
  [[nodiscard]] double bias_error_deg() const {
    return (*engine.rows.back().solution.heading_bias - Angle::deg(bias_deg)).wrapped_pi().deg();
  }
  EngineHarness& engine;
  double course_deg, bias_deg;
  HeadingReference reference = HeadingReference::true_north;
  test::Pcg random{7};
  double north = 0.0, east = 0.0;
  int t = 0;
};

TEST(Ekf7Engine, FindsTheHeadingBiasAndDivesOnIt) {
  for (const double course_deg : {20.0, 178.0}) {
    EngineHarness engine("ekf7", options(), vehicle());
    CourseRun run(engine, course_deg, -6.0);
    for (int i = 0; i < 300; ++i) run.second(true);
    EXPECT_NEAR(run.bias_error_deg(), 0.0, 0.5);
    const Solution surfaced = engine.rows.back().solution;
    EXPECT_NEAR((*surfaced.heading - Angle::deg(course_deg)).wrapped_pi().deg(), 0.0, 0.5);
    EXPECT_NEAR(*surfaced.vel_north_mps, 0.5 * std::cos(course_deg * kRadPerDeg), 0.01);
    EXPECT_EQ(surfaced.position_source, PositionSource::gnss);
    EXPECT_EQ(engine.mode(), Mode::A);
    for (int i = 0; i < 600; ++i) run.second(false);
    EXPECT_LT(run.error_m(), 4.0) << "300 m; 6 degrees would be 31 m";
    EXPECT_EQ(engine.mode(), Mode::E1);
    const Solution dived = engine.rows.back().solution;
    EXPECT_GT(dived.var_north_m2 + dived.var_east_m2, surfaced.var_north_m2 + surfaced.var_east_m2);
    EXPECT_LT(run.error_m(), 3.0 * std::sqrt(dived.var_north_m2 + dived.var_east_m2));
  }
}

TEST(Ekf7Engine, BiasOfAMagneticCompassStartsFromTheDeclinationAndIsShownBesideIt) {
  auto sources = vehicle();
  sources[kCompass].declination = Angle::deg(-7.79);
  EngineHarness engine("ekf7", options(), sources);
  CourseRun run(engine, 30.0, -5.35);
  run.reference = HeadingReference::magnetic_north;
  run.second(true);
  run.second(true);
  EXPECT_NEAR(engine.rows.back().solution.heading_bias->deg(), -7.79, 2.0);
  for (int i = 0; i < 300; ++i) run.second(true);
  EXPECT_NEAR(run.bias_error_deg(), 0.0, 0.5);
  ASSERT_EQ(engine.health.size(), 1u);
  const auto text = engine.health[0].text.view();
  EXPECT_NE(text.find("-7.8 deg of it the declination"), std::string_view::npos) << text;
}

TEST(Ekf7Engine, WithoutAMagneticModelAMagneticCompassServesAllTheSame) {
  EngineHarness engine("ekf7", options(), vehicle());
  CourseRun run(engine, 30.0, -8.0);
  run.reference = HeadingReference::magnetic_north;
  for (int i = 0; i < 300; ++i) run.second(true);
  EXPECT_NEAR(run.bias_error_deg(), 0.0, 0.5);
  ASSERT_EQ(engine.health.size(), 1u);
  EXPECT_NE(engine.health[0].text.view().find("no declination is known"), std::string_view::npos);
}

TEST(Ekf7Engine, AWildFixIsRefusedFarOnesThatAgreeAreTaken) {
  EngineHarness engine("ekf7", options(), vehicle());
  CourseRun run(engine, 0.0, -3.0);
  for (int i = 0; i < 100; ++i) run.second(true);
  engine.tell(run.t + 0.01, gnss_at(run.north + 40.0, run.east), kGnss);
  ASSERT_TRUE(engine.verdicts.back().accepted);
  EXPECT_FALSE(*engine.verdicts.back().accepted);
  EXPECT_NEAR(*engine.verdicts.back().residual_m, 40.0, 0.5);
  for (int i = 0; i < 60; ++i) run.second(true);
  EXPECT_LT(run.error_m(), 0.3);
  run.east += 30.0;  // the DVL saw nothing of these
  for (int i = 0; i < 60; ++i) run.second(true);
  EXPECT_LT(run.error_m(), 0.5);
}

TEST(Ekf7Engine, ALateFixIsComparedAtItsOwnTime) {
  EngineHarness engine("ekf7", options(), vehicle());
  CourseRun run(engine, 0.0, 0.0);
  for (int i = 0; i < 200; ++i) run.second(i > 2, 2.0);
  EXPECT_LT(run.error_m(), 0.3);
}

TEST(Ekf7Engine, APoorGeometryOrAVehicleAtRestLeavesTheFixUnused) {
  EngineHarness engine("ekf7", options(), vehicle());
  CourseRun run(engine, 0.0, 0.0);
  for (int i = 0; i < 30; ++i) run.second(true);
  GnssFix poor = gnss_at(run.north, run.east);
  poor.hdop = 2.5;
  engine.tell(run.t + 0.01, poor, kGnss);
  EXPECT_FALSE(engine.verdicts.back().accepted.has_value());
  EXPECT_TRUE(engine.verdicts.back().residual_m.has_value());
  for (int k = 1; k < 30; ++k) engine.tell(run.t + 0.2 * k, ahead(0.0), kDvl);
  engine.tell(run.t + 6.0, gnss_at(run.north, run.east), kGnss);
  EXPECT_FALSE(engine.verdicts.back().accepted.has_value());
}

TEST(Ekf7Engine, AntennaIsBroughtToTheReferencePoint) {
  auto sources = vehicle();
  sources[kGnss].lever = {3.0, 1.0, -1.0};
  EngineHarness engine("ekf7", options(), sources);
  CourseRun run(engine, 90.0, 0.0);
  // Eastward: 3 m forward is 3 m east, 1 m to starboard is 1 m south.
  for (int i = 0; i < 100; ++i) {
    run.second(false);
    engine.tell(run.t, gnss_at(run.north - 1.0, run.east + 3.0), kGnss);
  }
  EXPECT_LT(run.error_m(), 0.1);
}

TEST(Ekf7Engine, AUsblFixIsNotUsed) {
  EngineHarness engine("ekf7", options(), vehicle());
  CourseRun run(engine, 0.0, 0.0);
  for (int i = 0; i < 10; ++i) run.second(true);
  engine.tell(run.t, UsblGeographic{.position = EngineHarness::place(run.north, run.east + 20.0)}, kUsbl);
  EXPECT_FALSE(engine.verdicts.back().accepted.has_value());
  EXPECT_NEAR(*engine.verdicts.back().residual_m, 20.0, 1.0);
}

}  // namespace
}  // namespace leadline::nav
