// Two real boats: bottom track, compass and GGA in one file. The figures are those of an independent decoding
// (tests/data/dvl_pd0_adcp/SOURCE.md); a flipped sign, a roll of 180 degrees or a second tilt moves them far
// off.

#include <gtest/gtest.h>

#include <algorithm>

#include "core/nav/motion/dvl_velocity.h"
#include "tests/support/files.h"
#include "tests/support/recording.h"

namespace leadline {
namespace {

using test::Instrument;

Instrument adcp(const std::string& file) {
  return {.name = "adcp",
          .decoder = "trdi-pd0",
          .path = test::data_path("dvl_pd0_adcp/" + file),
          .stamped = false};
}

test::Replayed dead_reckoned(const Instrument& instrument) {
  return test::replay({instrument}, nav::Options{}, Body::ship, {"dead-reckoning"});
}

test::TurnAndScale turn_against_fixes(const test::Replayed& replayed) {
  const auto track = replayed.solutions(0);
  const auto fixes = replayed.verdicts(0);
  std::vector<std::pair<geo::NorthEast, geo::NorthEast>> pairs;
  for (const auto& fix : fixes)
    if (const auto here = test::position_at(track, fix.t, fixes.front().value.position))
      pairs.emplace_back(*here, geo::difference(fixes.front().value.position, fix.value.position));
  return test::best_turn(pairs);
}

double run_m(const test::Replayed& replayed) {
  const auto track = replayed.solutions(0);
  double run = 0.0;
  for (std::size_t i = 1; i < track.size(); ++i)
    run += std::hypot(*track[i].value.vel_north_mps, *track[i].value.vel_east_mps) *
           seconds(track[i].t - track[i - 1].t);
  return run;
}

TEST(Winriver01, UncalibratedDeadReckoningEndsAQuarterOfAKilometreOff) {
  const auto replayed = dead_reckoned(adcp("winriver01.PD0"));
  const auto fixes = replayed.verdicts(0);
  ASSERT_FALSE(fixes.empty());
  ASSERT_TRUE(fixes.back().value.residual_m);
  std::printf("winriver01: %.1f m off after %.1f m\n", *fixes.back().value.residual_m, run_m(replayed));
  EXPECT_NEAR(*fixes.back().value.residual_m, 256.0, 10.0);
  EXPECT_NEAR(run_m(replayed), 654.0, 15.0);
}

TEST(Winriver01, BestTurnAndScale) {
  const auto best = turn_against_fixes(dead_reckoned(adcp("winriver01.PD0")));
  std::printf("winriver01: turn %.2f deg, scale %.4f, RMS %.2f m over %d fixes\n", best.turn_deg, best.scale,
              best.rms_m, best.points);
  EXPECT_NEAR(best.turn_deg, -23.3, 1.0);
  EXPECT_NEAR(best.scale, 1.035, 0.01);
  EXPECT_LE(best.rms_m, 7.0);
}

TEST(Winriver01, MagneticHeadingIsTurnedByTheDeclinationOfPlaceAndDate) {
  auto instrument = adcp("winriver01.PD0");
  instrument.settings.heading_magnetic = true;
  const auto models = geo::MagneticModel::load(std::string(LEADLINE_BINARY_DIR) + "/magnetic");
  ASSERT_TRUE(models.ok());
  const auto as_true = dead_reckoned(adcp("winriver01.PD0")).solutions(0);
  const auto as_magnetic =
      test::replay({instrument}, nav::Options{}, Body::ship, {"dead-reckoning"}, &models.value())
          .solutions(0);
  ASSERT_EQ(as_true.size(), as_magnetic.size());
  for (std::size_t i = 0; i < as_true.size(); ++i)
    EXPECT_NEAR((*as_magnetic[i].value.heading - *as_true[i].value.heading).wrapped_pi().deg(), -16.76, 0.02);
}

TEST(RiverPro, BestTurnAndScale) {
  const auto best = turn_against_fixes(dead_reckoned(adcp("RiverPro_test01.PD0")));
  std::printf("RiverPro: turn %.2f deg, scale %.4f, RMS %.2f m over %d fixes\n", best.turn_deg, best.scale,
              best.rms_m, best.points);
  EXPECT_NEAR(best.turn_deg, 4.4, 1.0);
  EXPECT_NEAR(best.scale, 0.999, 0.01);
  EXPECT_LE(best.rms_m, 2.5);
}

class RiverProFused : public ::testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Variants, RiverProFused, ::testing::Values("error-state", "windowed-ci", "plain-ci"),
                         [](const auto& tested) {
                           std::string name = tested.param;
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

TEST_P(RiverProFused, FixResidualsLieInsideTwoStatedSigmas) {
  auto instrument = adcp("RiverPro_test01.PD0");
  instrument.info.calibration.heading = Angle::deg(4.4);
  nav::Options options;
  options.fusion.variant = GetParam();
  const auto replayed = test::replay({instrument}, options, Body::ship, {"fusion"});
  const auto track = replayed.solutions(0);
  int inside = 0, compared = 0;
  std::size_t row = 0;
  for (const auto& fix : replayed.verdicts(0)) {
    while (row + 1 < track.size() && track[row + 1].t <= fix.t) ++row;
    if (!fix.value.residual_m || track[row].t > fix.t) continue;
    const double gamma = options.aiding.gnss_drms_m;
    const double sigma =
        std::sqrt(track[row].value.var_north_m2 + track[row].value.var_east_m2 + gamma * gamma);
    ++compared;
    if (*fix.value.residual_m < 2.0 * sigma) ++inside;
  }
  const double share = static_cast<double>(inside) / compared;
  std::printf("RiverPro: %.1f %% of %d fix residuals inside two stated sigmas\n", 100.0 * share, compared);
  EXPECT_GT(compared, 200);
  EXPECT_GT(share, 0.95);
}

struct FusedBoat {
  std::optional<Angle> misalignment;
  double late_rms_m = 0.0;  // of the fixes' residuals in the second half
  int accepted = 0, rejected = 0;
};
/// An uncalibrated boat, as the product starts it.
FusedBoat fused_boat(const std::string& file, const std::string& variant) {
  nav::Options options;
  options.fusion.variant = variant;
  const auto replayed = test::replay({adcp(file)}, options, Body::ship, {"fusion"});
  FusedBoat boat;
  boat.misalignment = replayed.solutions(0).back().value.heading_bias;
  const auto fixes = replayed.verdicts(0);
  double squares_m2 = 0.0;
  int late = 0;
  for (std::size_t i = 0; i < fixes.size(); ++i) {
    if (fixes[i].value.accepted) ++(*fixes[i].value.accepted ? boat.accepted : boat.rejected);
    if (i < fixes.size() / 2 || !fixes[i].value.residual_m) continue;
    squares_m2 += *fixes[i].value.residual_m * *fixes[i].value.residual_m;
    ++late;
  }
  boat.late_rms_m = std::sqrt(squares_m2 / late);
  std::printf("%s, %s: residuals of the second half RMS %.2f m, %d accepted, %d rejected", file.c_str(),
              variant.c_str(), boat.late_rms_m, boat.accepted, boat.rejected);
  if (boat.misalignment) std::printf(", misalignment %+.2f deg", boat.misalignment->deg());
  std::printf("\n");
  return boat;
}

TEST(BoatsFused, FindTheirOwnMisalignment) {
  struct Boat {
    const char* file;
    double best_turn_deg;  // that of BestTurnAndScale
    double late_rms_m;
  };
  // A compass is off by another angle on every course: the filter's misalignment is that of the latest legs.
  for (const Boat& boat : {Boat{"winriver01.PD0", -23.3, 10.0},
                           {"winriver02.PD0", -25.6, 2.0},
                           {"RiverPro_test01.PD0", 4.4, 2.0}}) {
    const FusedBoat fused = fused_boat(boat.file, "error-state");
    ASSERT_TRUE(fused.misalignment);
    EXPECT_NEAR(fused.misalignment->deg(), boat.best_turn_deg, 3.0);
    EXPECT_LT(fused.late_rms_m, boat.late_rms_m);
  }
}

TEST(BoatsFused, WithoutAMisalignmentToEstimateRareFixesAreSoonRefused) {
  for (const char* variant : {"windowed-ci", "plain-ci"}) {
    const FusedBoat fused = fused_boat("winriver01.PD0", variant);
    EXPECT_FALSE(fused.misalignment);
    EXPECT_LT(fused.accepted, 5) << "its 23 degrees throw it out of the gate between two fixes";
    EXPECT_GT(fused.late_rms_m, 100.0);
  }
}

TEST(Winriver02, BestTurnAndScale) {
  const auto best = turn_against_fixes(dead_reckoned(adcp("winriver02.PD0")));
  std::printf("winriver02: turn %.2f deg, scale %.4f, RMS %.2f m over %d fixes\n", best.turn_deg, best.scale,
              best.rms_m, best.points);
  EXPECT_NEAR(best.turn_deg, -25.6, 3.0);
}

TEST(EarthFrameBoat, VelocityIsUndoneByItsOwnHeadingAndRedoneByABetterOne) {
  const auto replayed = dead_reckoned(adcp("RDI_withBT.000"));
  SourceInfo source;
  int checked = 0;
  for (const auto& ping : replayed.all<DvlVelocity>()) {
    if (!ping.value.valid || ping.value.reference != DvlReference::bottom) continue;
    ASSERT_EQ(ping.value.frame, DvlFrame::earth);
    ASSERT_TRUE(ping.value.applied);
    EulerAngles own{ping.value.applied->roll, ping.value.applied->pitch, ping.value.applied->heading};
    const auto same = nav::velocity_ned(ping.value, source, own);
    EXPECT_NEAR(same.x, ping.value.x_mps, 1e-12);
    EXPECT_NEAR(same.y, ping.value.y_mps, 1e-12);
    own.heading = own.heading + Angle::deg(10.0);
    const auto turned = nav::velocity_ned(ping.value, source, own);
    const double before = std::atan2(same.y, same.x), after = std::atan2(turned.y, turned.x);
    if (std::hypot(same.x, same.y) > 0.0) {
      EXPECT_NEAR(Angle::rad(after - before).wrapped_pi().deg(), 10.0, 1e-6);
    }
    ++checked;
  }
  EXPECT_EQ(checked, 901);
}

}  // namespace
}  // namespace leadline
