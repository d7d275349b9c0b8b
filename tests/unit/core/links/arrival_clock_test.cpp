#include "core/links/arrival_clock.h"

#include <gtest/gtest.h>

namespace leadline::links {
namespace {

constexpr std::int64_t kS = 1'000'000'000;
std::int64_t elapsed_ns, wall_ns;
const SystemClocks kMade{[] { return elapsed_ns; }, [] { return wall_ns; }};

class ArrivalClockTest : public testing::Test {
 protected:
  ArrivalClockTest() {
    elapsed_ns = 5 * kS;
    wall_ns = 1'795'350'919 * kS + 1'234;
    clock_ = ArrivalClock(kMade);
  }
  static void pass(std::int64_t ns) { elapsed_ns += ns, wall_ns += ns; }
  ArrivalClock clock_{kMade};
};

TEST_F(ArrivalClockTest, IsUtcAtTheStartPlusWhatElapsedInWholeMicroseconds) {
  EXPECT_EQ(clock_.now().ns, 1'795'350'919 * kS + 1'000);
  pass(2 * kS + 600);
  EXPECT_EQ(clock_.now().ns, 1'795'350'921 * kS + 2'000);
}

TEST_F(ArrivalClockTest, SettingTheWallClockChangesNoArrival) {
  for (const std::int64_t step : {3600 * kS, -10 * kS, -86'400 * kS, -1'795'350'000 * kS, 700'000'000 * kS}) {
    const Arrival before = clock_.now();
    const Duration step_before = clock_.wall_step();
    wall_ns += step;
    EXPECT_EQ(clock_.now(), before);
    EXPECT_EQ((clock_.wall_step() - step_before).count(), step);
    EXPECT_EQ(clock_.wall().ns, wall_ns);
    pass(kS);
    EXPECT_EQ(clock_.now().ns, before.ns + kS);
  }
}

TEST_F(ArrivalClockTest, TheKernelsStampIsTakenAsAnAge) {
  pass(10 * kS);
  wall_ns += 3600 * kS;  // set forward: the stamp is by the same clock, so its age is right
  EXPECT_EQ(clock_.heard_at(wall_ns - 3'000'000).ns, clock_.now().ns - 3'000'000);
}

TEST_F(ArrivalClockTest, AStampFromBeforeAStepIsNotBelieved) {
  const std::int64_t stamp = wall_ns;
  wall_ns += 3600 * kS;
  EXPECT_EQ(clock_.heard_at(stamp), clock_.now());
  wall_ns -= 7200 * kS;
  EXPECT_EQ(clock_.heard_at(stamp), clock_.now());
}

}  // namespace
}  // namespace leadline::links
