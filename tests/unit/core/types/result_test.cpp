#include "core/types/result.h"

#include <gtest/gtest.h>

#include <memory>

namespace leadline {
namespace {

Result<int> half(int n) {
  if (n % 2 != 0) return Error{"odd number", "half", "give an even one"};
  return n / 2;
}

TEST(Result, HoldsAValue) {
  const auto r = half(8);
  ASSERT_TRUE(r.ok());
  EXPECT_TRUE(static_cast<bool>(r));
  EXPECT_EQ(r.value(), 4);
}

TEST(Result, HoldsAnErrorInOneLine) {
  const auto r = half(7);
  ASSERT_FALSE(r);
  EXPECT_EQ(r.error().line(), "half: odd number; give an even one");
  EXPECT_EQ((Error{"odd number", "", ""}.line()), "odd number");
}

TEST(Result, MovesItsValueOut) {
  Result<std::unique_ptr<int>> r(std::make_unique<int>(5));
  const std::unique_ptr<int> p = std::move(r).value();
  EXPECT_EQ(*p, 5);
}

TEST(Result, WithoutAValueIsDoneOrAnError) {
  EXPECT_TRUE(Result<void>().ok());
  const Result<void> failed = Error{"disk full", "a.leadline", ""};
  EXPECT_FALSE(failed.ok());
  EXPECT_EQ(failed.error().line(), "a.leadline: disk full");
}

TEST(ResultDeathTest, AskingForWhatIsNotThereIsOurBug) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  EXPECT_DEATH((void)half(7).value(), "broken promise");
  EXPECT_DEATH((void)half(8).error(), "broken promise");
}

}  // namespace
}  // namespace leadline
