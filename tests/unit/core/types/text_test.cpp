#include "core/types/text.h"

#include <gtest/gtest.h>

namespace leadline {
namespace {

TEST(Text, KeepsWhatFitsAndCutsTheRest) {
  EXPECT_EQ(Text<8>("checksum").view(), "checksum");
  EXPECT_EQ(Text<8>("checksums").view(), "checksum");
}

TEST(Text, EmptyHoweverItIsMade) {
  EXPECT_TRUE(Text<8>().empty());
  EXPECT_TRUE(Text<8>("").empty());
  EXPECT_TRUE(Text<8>(std::string_view{}).empty());  // data() is null
  EXPECT_EQ(Text<8>(), Text<8>(""));
}

TEST(Text, ComparesByContent) {
  EXPECT_EQ(Text<8>("B07"), Text<8>("B07"));
  EXPECT_FALSE(Text<8>("B07") == Text<8>("B08"));
  EXPECT_FALSE(Text<8>("B07") == Text<8>("B0"));
  EXPECT_EQ(Text<8>(std::string_view("a\0b", 3)).view().size(), 3u);
}

}  // namespace
}  // namespace leadline
