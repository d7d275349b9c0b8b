#include "sessions/recorder/disk_forecast.h"

#include <gtest/gtest.h>

namespace leadline::sessions {
namespace {

constexpr std::uint64_t kGiB = std::uint64_t{1} << 30;
constexpr std::int64_t kS = 1'000'000'000;

TEST(DiskForecast, FollowsTheRateOfTheLastTenMinutes) {
  DiskForecast forecast;
  DiskForecast::Outlook outlook;
  for (int s = 0; s <= 1200; s += 10)
    outlook = forecast.look({s * kS}, {50 * kGiB - static_cast<std::uint64_t>(s) * 1'000'000, 100 * kGiB});
  ASSERT_TRUE(outlook.left);
  const double free = 50.0 * static_cast<double>(kGiB) - 1200e6;
  EXPECT_NEAR(seconds(*outlook.left), free / 1e6, 1.0);
  EXPECT_FALSE(outlook.short_of_space);
}

TEST(DiskForecast, SaysNothingBeforeItKnows) {
  DiskForecast forecast;
  for (int s = 0; s < 30; s += 10)
    EXPECT_FALSE(
        forecast.look({s * kS}, {50 * kGiB - static_cast<std::uint64_t>(s) * kGiB, 100 * kGiB}).left);
}

TEST(DiskForecast, AnHourLeftOrATenthIsTold) {
  DiskForecast fast;
  DiskForecast::Outlook outlook;
  for (int s = 0; s <= 60; s += 10)
    outlook = fast.look({s * kS}, {50 * kGiB - static_cast<std::uint64_t>(s) * 16'000'000, 100 * kGiB});
  EXPECT_TRUE(outlook.short_of_space) << "50 GiB at 16 MB/s last 56 minutes";
  DiskForecast full;
  EXPECT_TRUE(full.look({0}, {9 * kGiB, 100 * kGiB}).short_of_space);
  EXPECT_FALSE(DiskForecast().look({0}, {11 * kGiB, 100 * kGiB}).short_of_space);
}

TEST(DiskForecast, AGrowingDiskHasNoEnd) {
  DiskForecast forecast;
  DiskForecast::Outlook outlook;
  for (int s = 0; s <= 600; s += 10)
    outlook = forecast.look({s * kS}, {50 * kGiB + static_cast<std::uint64_t>(s), 100 * kGiB});
  EXPECT_FALSE(outlook.left);
}

TEST(DiskForecast, AsksTheDiskOfAFile) {
  const auto disk = disk_of(testing::TempDir() + "any.leadline");
  ASSERT_TRUE(disk);
  EXPECT_GT(disk->all_bytes, 0U);
  EXPECT_LE(disk->free_bytes, disk->all_bytes);
}

}  // namespace
}  // namespace leadline::sessions
