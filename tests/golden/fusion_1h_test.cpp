// One hour of a simulated survey and the positions an independent reference made of it (SOURCE.md).

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <cmath>
#include <cstdlib>
#include <map>
#include <string>
#include <vector>

#include "core/nav/filters/covariance_intersection.h"
#include "core/types/rotation.h"
#include "tests/support/files.h"

namespace leadline::nav {
namespace {

using Eigen::Vector2d;

class Fusion1h : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    const std::string text = test::read_text(test::data_path("reference-navigation/fusion_1h.csv"));
    const char* at = text.c_str();
    while (*at != '\0' && *at != '\n') {
      std::string name;
      while (*at != ',' && *at != '\n') name += *at++;
      if (*at == ',') ++at;
      const std::size_t index = columns_.size();
      columns_[name] = index;
    }
    while (*at == '\n' && at[1] != '\0') {
      std::vector<double> row;
      row.reserve(columns_.size());
      do {
        char* end = nullptr;
        row.push_back(std::strtod(at + 1, &end));
        at = end;
      } while (*at == ',');
      ASSERT_EQ(row.size(), columns_.size()) << "row " << rows_.size();
      rows_.push_back(std::move(row));
    }
    ASSERT_EQ(rows_.size(), 18000U);
  }
  static void TearDownTestSuite() {
    columns_.clear();
    rows_.clear();
  }
  static std::size_t column(const char* name) { return columns_.at(name); }

  static inline std::map<std::string, std::size_t> columns_;
  static inline std::vector<std::vector<double>> rows_;
};

TEST_F(Fusion1h, TiltedVelocityIsKims2010Equation1) {
  const auto roll = column("roll"), pitch = column("pitch"), heading = column("heading");
  const auto vx = column("dvl_vx"), vy = column("dvl_vy"), vz = column("dvl_vz");
  const auto north = column("vN_unaligned"), east = column("vE_unaligned");
  double worst_mps = 0.0;
  for (const auto& row : rows_) {
    const auto C_nb = Rotation<Ned, BodyFrame>::zyx(
        {Angle::rad(row[roll]), Angle::rad(row[pitch]), Angle::rad(row[heading])});
    const Vec3<Ned> v_n = C_nb * Vec3<BodyFrame>{row[vx], row[vy], row[vz]};
    worst_mps = std::max({worst_mps, std::abs(v_n.x - row[north]), std::abs(v_n.y - row[east])});
  }
  std::printf("largest difference %.2e m/s\n", worst_mps);
  EXPECT_LT(worst_mps, 1e-9);
}

TEST_F(Fusion1h, PlainCovarianceIntersectionFollowsTheReference) {
  constexpr double kGamma_m = 5.0, kDt_s = 0.2;
  const std::string notes = test::read_text(test::data_path("reference-navigation/fusion_1h.txt"));
  const auto yaw_at = notes.find("yaw_rad ");
  ASSERT_NE(yaw_at, std::string::npos);
  const double yaw = std::strtod(notes.c_str() + yaw_at + 8, nullptr);
  ASSERT_NEAR(yaw, 0.045181882, 1e-9);
  Eigen::Matrix2d aligned;
  aligned << std::cos(yaw), -std::sin(yaw), std::sin(yaw), std::cos(yaw);

  const auto t = column("t"), vn = column("vN_unaligned"), ve = column("vE_unaligned");
  const auto fix_new = column("fix_new"), fix_n = column("fix_N"), fix_e = column("fix_E");
  const auto true_n = column("true_N"), true_e = column("true_E");
  const auto ref_n = column("plainCI_N"), ref_e = column("plainCI_E"), ref_accepted = column("acc_ci");

  PlainCi filter(kGamma_m);
  filter.reset(12.5 * Eigen::Matrix2d::Identity());
  Vector2d position = Vector2d::Zero();
  double worst_m = 0.0, squares_m2 = 0.0, since_ten_minutes = 0.0;
  int fixes = 0, accepted = 0, other_verdicts = 0;
  for (const auto& row : rows_) {
    const Vector2d v = aligned * Vector2d(row[vn], row[ve]);
    filter.predict(v, kDt_s);
    position += v * kDt_s;
    if (row[fix_new] > 0.5) {
      const FixResult result = filter.fix(Vector2d(row[fix_n], row[fix_e]) - position, row[t], kGamma_m);
      position += result.step;
      ++fixes;
      accepted += result.accepted;
      other_verdicts += result.accepted != (row[ref_accepted] > 0.5);
    } else {
      other_verdicts += row[ref_accepted] >= 0.0;
    }
    worst_m = std::max({worst_m, std::abs(position.x() - row[ref_n]), std::abs(position.y() - row[ref_e])});
    if (row[t] > 600.0) {
      squares_m2 += (position - Vector2d(row[true_n], row[true_e])).squaredNorm();
      since_ten_minutes += 1.0;
    }
  }
  const double rms_m = std::sqrt(squares_m2 / since_ten_minutes);
  std::printf("largest difference %.2e m, RMS error %.4f m, %d of %d fixes accepted\n", worst_m, rms_m,
              accepted, fixes);
  EXPECT_LT(worst_m, 1e-6);
  EXPECT_EQ(other_verdicts, 0);
  EXPECT_EQ(fixes, 450);
  EXPECT_NEAR(rms_m, 2.836, 0.0005);
}

}  // namespace
}  // namespace leadline::nav
