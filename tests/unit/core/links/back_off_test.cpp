#include "core/links/back_off.h"

#include <gtest/gtest.h>

namespace leadline::links {
namespace {

using std::chrono::milliseconds;

TEST(BackOff, DoublesFromTheFirstToTheLastWithinAQuarter) {
  for (std::uint32_t seed = 1; seed <= 50; ++seed) {
    BackOff back_off(milliseconds(1000), milliseconds(30000), seed);
    double expected_ms = 1000.0;
    for (int i = 0; i < 10; ++i) {
      const double ms = static_cast<double>(back_off.next().count());
      EXPECT_GE(ms, std::max(1000.0, 0.74 * expected_ms));
      EXPECT_LE(ms, std::min(30000.0, 1.26 * expected_ms));
      expected_ms = std::min(30000.0, 2.0 * expected_ms);
    }
    back_off.reset();
    EXPECT_LE(back_off.next().count(), 1250);
  }
}

TEST(BackOff, TwoLinksDoNotComeBackTogether) {
  BackOff one(milliseconds(1000), milliseconds(30000), 1), other(milliseconds(1000), milliseconds(30000), 2);
  int same = 0;
  for (int i = 0; i < 10; ++i) same += one.next() == other.next();
  EXPECT_LT(same, 5);
}

}  // namespace
}  // namespace leadline::links
