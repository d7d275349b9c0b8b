#include "core/links/overload.h"

#include <gtest/gtest.h>

namespace leadline::links {
namespace {

constexpr std::int64_t kMs = 1'000'000;

TEST(Overload, InTimeEverythingIsDecoded) {
  Overload overload(2);
  for (int i = 0; i < 10'000; ++i) EXPECT_TRUE(overload.decode(0, 1000, {i * kMs}, {i * kMs + 10 * kMs}));
  EXPECT_EQ(overload.not_decoded(0), 0U);
}

TEST(Overload, TheLinkThatFloodsIsNotDecodedUntilTheCoreHasCaughtUp) {
  Overload overload(3);
  const Arrival heard{1'000'000 * kMs};
  for (int i = 0; i < 50; ++i) {
    (void)overload.decode(0, 82, heard, heard);
    (void)overload.decode(1, 60, heard, heard);
    (void)overload.decode(2, 900, heard, heard);
  }
  const Arrival late{heard.ns + 200 * kMs};
  EXPECT_FALSE(overload.decode(2, 900, heard, late));
  EXPECT_TRUE(overload.decode(0, 82, heard, late)) << "the others are decoded, late as they are";
  EXPECT_TRUE(overload.decode(1, 60, heard, late));
  EXPECT_FALSE(overload.decode(2, 900, heard, {heard.ns + 50 * kMs})) << "not yet caught up";
  EXPECT_TRUE(overload.decode(2, 900, heard, {heard.ns + 10 * kMs}));
  EXPECT_TRUE(overload.decode(2, 900, heard, {heard.ns + 100 * kMs})) << "late by less than 150 ms";
  EXPECT_EQ(overload.not_decoded(2), 2U);
}

TEST(Overload, WhereNobodyFloodsAllAreDecodedLate) {
  Overload overload(4);
  const Arrival heard{1'000'000 * kMs}, late{heard.ns + 900 * kMs};
  for (int i = 0; i < 100; ++i)
    for (std::size_t link = 0; link < 4; ++link) {
      const bool decoded = overload.decode(link, 100, heard, late);
      if (i > 0) {
        EXPECT_TRUE(decoded);
      }
    }
}

}  // namespace
}  // namespace leadline::links
