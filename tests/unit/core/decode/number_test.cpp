#include "core/decode/number.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <random>
#include <string>

namespace leadline::decode {
namespace {

TEST(ParseNumber, TakesSignDigitsAndDecimals) {
  EXPECT_EQ(parse_number("0"), 0.0);
  EXPECT_EQ(parse_number("-12.5"), -12.5);
  EXPECT_EQ(parse_number("+000.05"), 0.05);
  EXPECT_EQ(parse_number("5912.34567"), 5912.34567);
  EXPECT_EQ(parse_number("99999999999999999999"), 1e20);
}

TEST(ParseNumber, RefusesWhateverElse) {
  for (const char* text : {"",
                           "+",
                           "-",
                           ".",
                           "5.",
                           ".5",
                           "-.5",
                           "1e5",
                           "1E5",
                           "nan",
                           "NaN",
                           "inf",
                           "-inf",
                           "0x10",
                           " 1",
                           "1 ",
                           "1,5",
                           "1.2.3",
                           "--1",
                           "+-1",
                           "1-",
                           "1.8e308",
                           "123456789012345678901",
                           "1.00000000000000000000"})
    EXPECT_FALSE(parse_number(text)) << text;
  EXPECT_FALSE(parse_number(std::string_view("1\0", 2)));
}

TEST(ParseNumber, RoundsCorrectlyOverAllLengthsOfMantissa) {
  std::mt19937_64 random(7);
  for (int i = 0; i < 20'000; ++i) {
    const int digits = 1 + static_cast<int>(random() % 20), point = static_cast<int>(random() % 20);
    std::string text = random() % 2 == 0 ? "-" : "";
    for (int k = 0; k < digits; ++k) {
      if (k == point && k > 0) text += '.';
      text += static_cast<char>('0' + random() % 10);
    }
    const auto value = parse_number(text);
    ASSERT_TRUE(value) << text;
    EXPECT_EQ(*value, std::strtod(text.c_str(), nullptr)) << text;
  }
}

TEST(ParseScientific, TakesAnExponentAndNothingThatIsNoNumber) {
  EXPECT_EQ(parse_scientific("4e-06"), 4e-06);
  EXPECT_EQ(parse_scientific("-1.25E+2"), -125.0);
  EXPECT_EQ(parse_scientific("+7"), 7.0);
  for (const char* text : {"", "nan", "inf", "-inf", "e5", ".5", "1e", "1e999", "0x1p3", "+-1", "1 ", "- 1"})
    EXPECT_FALSE(parse_scientific(text)) << text;
  EXPECT_FALSE(parse_scientific(std::string(41, '1')));
}

TEST(ParseDigits, TakesOneToNineDigitsOnly) {
  EXPECT_EQ(parse_digits("0"), 0u);
  EXPECT_EQ(parse_digits("0123"), 123u);
  EXPECT_EQ(parse_digits("999999999"), 999'999'999u);
  for (const char* text : {"", "1000000000", "-1", "+1", "1.0", " 1", "a"})
    EXPECT_FALSE(parse_digits(text)) << text;
}

TEST(ParseHexByte, TakesTwoDigitsOfEitherCase) {
  EXPECT_EQ(parse_hex_byte("7e"), 0x7E);
  EXPECT_EQ(parse_hex_byte("7E"), 0x7E);
  EXPECT_EQ(parse_hex_byte("00"), 0);
  for (const char* text : {"", "7", "7E0", "-1", "+1", "0x", "G0", "0G", " 1"})
    EXPECT_FALSE(parse_hex_byte(text)) << text;
}

}  // namespace
}  // namespace leadline::decode
