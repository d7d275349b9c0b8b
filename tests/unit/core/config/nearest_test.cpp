#include "core/config/nearest.h"

#include <gtest/gtest.h>

namespace leadline::config {
namespace {

TEST(EditDistance, CountsSingleMistakes) {
  EXPECT_EQ(edit_distance("gnss_drm_m", "gnss_drms_m"), 1);
  EXPECT_EQ(edit_distance("kitten", "sitting"), 3);
  EXPECT_EQ(edit_distance("nmae", "name"), 1);  // swapped neighbours
  EXPECT_EQ(edit_distance("", "abc"), 3);
  EXPECT_EQ(edit_distance("Rate-Hz", "rate_hz"), 0);
}

TEST(EditDistance, IsSymmetricAndZeroForTheSame) {
  const std::vector<std::string> words = {"",          "a",    "name",    "nmae",
                                          "latency_s", "date", "rate_hz", "gyro_bias_deg_h"};
  for (const auto& a : words)
    for (const auto& b : words) {
      EXPECT_EQ(edit_distance(a, b), edit_distance(b, a));
      EXPECT_EQ(edit_distance(a, b) == 0, a == b);
    }
}

TEST(Nearest, FindsTheLikeliestKey) {
  const std::vector<std::string> known = {"gnss_drms_m", "usbl_drms_m", "dvl_noise_mps", "lat_deg",
                                          "latency_s"};
  EXPECT_EQ(nearest("gnss_drm_m", known), "gnss_drms_m");
  EXPECT_EQ(nearest("usbl_drm_m", known), "usbl_drms_m");
  EXPECT_EQ(nearest("DVL_NOISE", known), "dvl_noise_mps");
  EXPECT_EQ(nearest("lat", known), "lat_deg");  // only its unit left out
}

TEST(Nearest, IsSilentWhenNothingIsNear) {
  const std::vector<std::string> known = {"name", "link", "decoder"};
  EXPECT_FALSE(nearest("colour", known));
  EXPECT_FALSE(nearest("x", known));
  EXPECT_FALSE(nearest("", known));
  EXPECT_FALSE(nearest("name", {}));
  EXPECT_FALSE(nearest(std::string(100'000, 'n'), known));
}

}  // namespace
}  // namespace leadline::config
