#include "core/nav/alignment/heading_alignment.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/unit/core/nav/simulated_survey.h"

namespace leadline::nav {
namespace {

using Eigen::Vector2d;
using test::SimulatedSurvey;

Vector2d turned(const Vector2d& v, double angle_rad) {
  const double c = std::cos(angle_rad), s = std::sin(angle_rad);
  return {c * v.x() - s * v.y(), s * v.x() + c * v.y()};
}

std::vector<ReckonedAndFixed> surveyed(std::uint64_t seed, double duration_s) {
  SimulatedSurvey survey(seed);
  std::vector<ReckonedAndFixed> pairs;
  Vector2d reckoned = Vector2d::Zero();
  while (survey.t_s() < duration_s) {
    survey.step();
    reckoned += survey.dvl_mps() * SimulatedSurvey::kStep_s;
    if (survey.fix()) pairs.push_back({reckoned, *survey.fix()});
  }
  return pairs;
}

double off_deg(const HeadingAlignment& found, double mounted_deg) {
  return Angle::rad(found.alpha_rad - mounted_deg * kRadPerDeg).wrapped_pi().deg();
}

struct Band {
  double duration_s, limit_deg;
  double worst_deg = 0.0, squares = 0.0;
  int within = 0, tried = 0;

  void add(double error_deg) {
    worst_deg = std::max(worst_deg, error_deg);
    squares += error_deg * error_deg;
    within += error_deg <= limit_deg;
    ++tried;
  }
  void print() const {
    std::printf("%5.0f s: worst %.2f deg, rms %.2f deg, %d of %d within %.2f deg\n", duration_s, worst_deg,
                std::sqrt(squares / tried), within, tried, limit_deg);
  }
};

/// A hundred seeds, each at four mounts.
void align_surveys(double longest_s, std::vector<Band>& bands) {
  AlignmentWorkspace workspace;
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    const auto aligned = surveyed(seed, longest_s);
    for (const double mounted_deg : {-178.0, 0.0, 3.0, 45.0}) {
      auto pairs = aligned;
      for (auto& pair : pairs) pair.d = turned(pair.d, -mounted_deg * kRadPerDeg);
      for (auto& band : bands) {
        const auto count = static_cast<std::size_t>(band.duration_s / SimulatedSurvey::kFixEvery_s);
        const auto found = align_heading({pairs.data(), std::min(count, pairs.size())},
                                         SimulatedSurvey::kGamma_m, workspace);
        ASSERT_TRUE(found);
        band.add(std::abs(off_deg(*found, mounted_deg)));
      }
    }
  }
  for (const auto& band : bands) band.print();
}

TEST(HeadingAlignment, FindsAnyMountWithinItsBandAfterTenAndTwentyMinutesAndThreeHours) {
  std::vector<Band> bands{{600.0, 1.2}, {1200.0, 0.8}, {10800.0, 0.35}};
  align_surveys(10800.0, bands);
  for (const auto& band : bands) EXPECT_EQ(band.within, band.tried);
}

TEST(HeadingAlignment, FiveMinutesAreShort) {
  // 37 fixes on 150 m: one sigma is 0.8 deg with every outlier known, so 2.5 deg is three of them.
  std::vector<Band> bands{{300.0, 2.5}};
  align_surveys(300.0, bands);
  EXPECT_GE(bands[0].within, 98 * bands[0].tried / 100);
  EXPECT_LE(bands[0].worst_deg, 3.5);
}

TEST(HeadingAlignment, ExactPairsGiveTheExactTurnAndScale) {
  AlignmentWorkspace workspace;
  for (const double deg : {-179.0, -90.0, 0.0, 12.5, 180.0}) {
    std::vector<ReckonedAndFixed> pairs;
    test::Pcg random(5);
    for (int k = 0; k < 50; ++k) {
      const Vector2d d = 300.0 * random.normal2();
      pairs.push_back({d, 0.997 * turned(d, deg * kRadPerDeg) + Vector2d(1e4, -2e3)});
    }
    const auto found = align_heading(pairs, 5.0, workspace);
    ASSERT_TRUE(found);
    EXPECT_NEAR(off_deg(*found, deg), 0.0, 1e-9);
    EXPECT_NEAR(found->scale, 0.997, 1e-12);
    EXPECT_EQ(found->inliers, 50);
  }
}

TEST(HeadingAlignment, OneWildFixIsLeftOut) {
  std::vector<ReckonedAndFixed> pairs;
  test::Pcg random(6);
  for (int k = 0; k < 40; ++k) {
    const Vector2d d(10.0 * k, 0.0);
    pairs.push_back({d, d + random.normal2()});
  }
  pairs[7].z += Vector2d(0.0, 5000.0);
  AlignmentWorkspace workspace;
  const auto found = align_heading(pairs, 1.5, workspace);
  ASSERT_TRUE(found);
  EXPECT_EQ(workspace.inlier[7], 0);
  EXPECT_NEAR(off_deg(*found, 0.0), 0.0, 0.3);
}

TEST(HeadingAlignment, NothingIsFoundWhereNothingMovedOrAValueIsNotFinite) {
  AlignmentWorkspace workspace;
  std::vector<ReckonedAndFixed> pairs(30, {Vector2d(1.0, 1.0), Vector2d(2.0, 0.0)});
  EXPECT_FALSE(align_heading(pairs, 5.0, workspace));
  EXPECT_FALSE(align_heading({}, 5.0, workspace));
  for (std::size_t k = 0; k < pairs.size(); ++k) pairs[k].d.x() = static_cast<double>(k);
  EXPECT_TRUE(align_heading(pairs, 5.0, workspace));
  EXPECT_FALSE(align_heading(pairs, 0.0, workspace));
  pairs[3].z.y() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(align_heading(pairs, 5.0, workspace));
}

}  // namespace
}  // namespace leadline::nav
