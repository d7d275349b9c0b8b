// One hour of a simulated survey and the positions an independent reference made of it (SOURCE.md).

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <cmath>
#include <cstdlib>
#include <memory>
#include <string>

#include "core/nav/alignment/heading_alignment.h"
#include "core/nav/filters/covariance_intersection.h"
#include "core/nav/filters/error_state.h"
#include "core/nav/filters/windowed_covariance.h"
#include "core/types/rotation.h"
#include "tests/support/csv_columns.h"

namespace leadline::nav {
namespace {

using Eigen::Vector2d;

constexpr double kGamma_m = 5.0, kDt_s = 0.2;

class Fusion1h : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    table_ = std::make_unique<test::CsvColumns>(test::data_path("reference-navigation/fusion_1h.csv"));
    ASSERT_EQ(table_->rows().size(), 18000U);
  }
  static void TearDownTestSuite() { table_.reset(); }
  static std::size_t column(const std::string& name) { return table_->column(name); }

  /// The reference's own alignment over all fixes.
  static Eigen::Matrix2d aligned() {
    const std::string notes = test::read_text(test::data_path("reference-navigation/fusion_1h.txt"));
    const auto yaw_at = notes.find("yaw_rad ");
    EXPECT_NE(yaw_at, std::string::npos);
    const double yaw = std::strtod(notes.c_str() + yaw_at + 8, nullptr);
    EXPECT_NEAR(yaw, 0.045181882, 1e-9);
    Eigen::Matrix2d turn;
    turn << std::cos(yaw), -std::sin(yaw), std::sin(yaw), std::cos(yaw);
    return turn;
  }

  struct Run {
    double worst_m = 0.0, rms_m = 0.0;  // against the reference; against the truth after ten minutes
    int fixes = 0, accepted = 0, other_verdicts = 0;
  };
  /// Drives a filter with the file; over_ground turns the unaligned velocity. verdicts: the reference's
  /// column of them, empty where it has none.
  template <class Filter, class OverGround>
  static Run run(Filter& filter, OverGround over_ground, const std::string& reference,
                 const std::string& verdicts) {
    const auto t = column("t"), vn = column("vN_unaligned"), ve = column("vE_unaligned");
    const auto fix_new = column("fix_new"), fix_n = column("fix_N"), fix_e = column("fix_E");
    const auto true_n = column("true_N"), true_e = column("true_E");
    const auto ref_n = column(reference + "_N"), ref_e = column(reference + "_E");
    const auto ref_accepted = verdicts.empty() ? t : column(verdicts);
    Run run;
    Vector2d position = Vector2d::Zero();
    double squares_m2 = 0.0, since_ten_minutes = 0.0;
    for (const auto& row : table_->rows()) {
      const Vector2d v = over_ground(Vector2d(row[vn], row[ve]));
      filter.predict(v, kDt_s);
      position += v * kDt_s;
      if (row[fix_new] > 0.5) {
        const FixResult result = filter.fix(Vector2d(row[fix_n], row[fix_e]) - position, row[t], kGamma_m);
        position += result.step;
        ++run.fixes;
        run.accepted += result.accepted;
        if (!verdicts.empty()) run.other_verdicts += result.accepted != (row[ref_accepted] > 0.5);
      } else if (!verdicts.empty()) {
        run.other_verdicts += row[ref_accepted] >= 0.0;
      }
      run.worst_m =
          std::max({run.worst_m, std::abs(position.x() - row[ref_n]), std::abs(position.y() - row[ref_e])});
      if (row[t] > 600.0) {
        squares_m2 += (position - Vector2d(row[true_n], row[true_e])).squaredNorm();
        since_ten_minutes += 1.0;
      }
    }
    run.rms_m = std::sqrt(squares_m2 / since_ten_minutes);
    std::printf("%s: largest difference %.2e m, RMS error %.4f m, %d of %d fixes accepted\n",
                reference.c_str(), run.worst_m, run.rms_m, run.accepted, run.fixes);
    return run;
  }

  static inline std::unique_ptr<test::CsvColumns> table_;
};

TEST_F(Fusion1h, TiltedVelocityIsKims2010Equation1) {
  const auto roll = column("roll"), pitch = column("pitch"), heading = column("heading");
  const auto vx = column("dvl_vx"), vy = column("dvl_vy"), vz = column("dvl_vz");
  const auto north = column("vN_unaligned"), east = column("vE_unaligned");
  double worst_mps = 0.0;
  for (const auto& row : table_->rows()) {
    const auto C_nb = Rotation<Ned, BodyFrame>::zyx(
        {Angle::rad(row[roll]), Angle::rad(row[pitch]), Angle::rad(row[heading])});
    const Vec3<Ned> v_n = C_nb * Vec3<BodyFrame>{row[vx], row[vy], row[vz]};
    worst_mps = std::max({worst_mps, std::abs(v_n.x - row[north]), std::abs(v_n.y - row[east])});
  }
  std::printf("largest difference %.2e m/s\n", worst_mps);
  EXPECT_LT(worst_mps, 1e-9);
}

TEST_F(Fusion1h, PlainCovarianceIntersectionFollowsTheReference) {
  PlainCi filter(kGamma_m);
  filter.reset(12.5 * Eigen::Matrix2d::Identity());
  const Eigen::Matrix2d turn = aligned();
  const Run run = Fusion1h::run(
      filter, [&](const Vector2d& v) -> Vector2d { return turn * v; }, "plainCI", "acc_ci");
  EXPECT_LT(run.worst_m, 1e-6);
  EXPECT_EQ(run.other_verdicts, 0);
  EXPECT_EQ(run.fixes, 450);
  EXPECT_NEAR(run.rms_m, 2.836, 0.0005);
}

TEST_F(Fusion1h, WindowedCovarianceIntersectionFollowsTheReference) {
  WindowedCi filter(kGamma_m);
  filter.reset(12.5 * Eigen::Matrix2d::Identity());
  const Eigen::Matrix2d turn = aligned();
  const Run run = Fusion1h::run(
      filter, [&](const Vector2d& v) -> Vector2d { return turn * v; }, "localCI", "");
  EXPECT_LT(run.worst_m, 1e-6);
  EXPECT_NEAR(run.rms_m, 0.843, 0.0005);
}

TEST_F(Fusion1h, ErrorStateFilterFollowsTheReference) {
  ErrorState filter({.window_detector = false, .alpha_walk_deg_sqrt_h = 0.1});
  const Run run = Fusion1h::run(
      filter, [&](const Vector2d& v) { return filter.over_ground(v); }, "esekf", "acc_es");
  EXPECT_LT(run.worst_m, 1e-6);
  EXPECT_EQ(run.other_verdicts, 0);
  EXPECT_NEAR(run.rms_m, 0.601, 0.0005);
  EXPECT_NEAR(filter.alpha_rad(), 0.045663523, 1e-8);
  EXPECT_NEAR(filter.s(), 0.003269920, 1e-8);
  EXPECT_NEAR(filter.sd_alpha_rad(), 1.5489e-3, 1e-7);
}

TEST_F(Fusion1h, ErrorStateFilterWithTheWindowDetectorFollowsTheReference) {
  ErrorState filter({});
  const Run run = Fusion1h::run(
      filter, [&](const Vector2d& v) { return filter.over_ground(v); }, "esekfwin", "");
  EXPECT_LT(run.worst_m, 1e-6);
  EXPECT_NEAR(run.rms_m, 0.687, 0.0005);
}

TEST_F(Fusion1h, HeadingAlignmentOverAllFixesFollowsTheReference) {
  const auto vn = column("vN_unaligned"), ve = column("vE_unaligned");
  const auto fix_new = column("fix_new"), fix_n = column("fix_N"), fix_e = column("fix_E");
  std::vector<ReckonedAndFixed> pairs;
  Vector2d reckoned = Vector2d::Zero();
  for (const auto& row : table_->rows()) {
    reckoned += Vector2d(row[vn], row[ve]) * kDt_s;
    if (row[fix_new] > 0.5) pairs.push_back({reckoned, {row[fix_n], row[fix_e]}});
  }
  AlignmentWorkspace workspace;
  const auto found = align_heading(pairs, kGamma_m, workspace);
  ASSERT_TRUE(found);
  std::printf("yaw %.9f rad, scale %.9f, sigma %.4e rad, %d fixes used\n", found->alpha_rad, found->scale,
              found->sd_alpha_rad, found->inliers);
  EXPECT_NEAR(found->alpha_rad, 0.045181882, 1e-7);
  EXPECT_NEAR(found->scale - 1.0, -0.002888716, 1e-7);
  EXPECT_NEAR(found->sd_alpha_rad, 1.117e-3, 1e-6);
  EXPECT_EQ(found->inliers, 423);
}

}  // namespace
}  // namespace leadline::nav
