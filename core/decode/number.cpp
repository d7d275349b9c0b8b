#include "core/decode/number.h"

#include <array>
#include <charconv>
#include <cmath>

namespace leadline::decode {
namespace {

constexpr std::array<double, 23> kPowersOfTen = {1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                                 1e8,  1e9,  1e10, 1e11, 1e12, 1e13, 1e14, 1e15,
                                                 1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};
constexpr std::uint64_t kExactInteger = std::uint64_t{1} << 53;

bool is_digit(char c) { return c >= '0' && c <= '9'; }

std::optional<double> rounded(std::string_view text) {
  if (!text.empty() && text.front() == '+') text.remove_prefix(1);
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value)) return std::nullopt;
  return value;
}

}  // namespace

std::optional<double> parse_number(std::string_view text) {
  std::size_t i = 0;
  const bool negative = !text.empty() && text[0] == '-';
  if (negative || (!text.empty() && text[0] == '+')) ++i;
  std::uint64_t mantissa = 0;
  int digits = 0, decimals = 0;
  for (; i < text.size() && is_digit(text[i]); ++i, ++digits) mantissa = mantissa * 10 + (text[i] - '0');
  if (digits == 0) return std::nullopt;
  if (i < text.size() && text[i] == '.') {
    for (++i; i < text.size() && is_digit(text[i]); ++i, ++decimals)
      mantissa = mantissa * 10 + (text[i] - '0');
    if (decimals == 0) return std::nullopt;
  }
  digits += decimals;
  if (i != text.size() || digits > 20) return std::nullopt;
  // An integer below 2^53 over an exact power of ten is correctly rounded by one division (Clinger 1990).
  if (digits <= 19 && mantissa <= kExactInteger) {
    const double value = static_cast<double>(mantissa) / kPowersOfTen[static_cast<std::size_t>(decimals)];
    return negative ? -value : value;
  }
  return rounded(text);
}

std::optional<double> parse_scientific(std::string_view text) {
  const auto digit_at = [&](std::size_t i) { return i < text.size() && is_digit(text[i]); };
  const bool sign = !text.empty() && (text[0] == '-' || text[0] == '+');
  if (text.size() > 40 || !digit_at(sign ? 1 : 0)) return std::nullopt;  // refuses nan, inf and ".5"
  return rounded(text);
}

std::optional<std::uint32_t> parse_digits(std::string_view text) {
  if (text.empty() || text.size() > 9) return std::nullopt;
  std::uint32_t value = 0;
  for (const char c : text) {
    if (!is_digit(c)) return std::nullopt;
    value = value * 10 + static_cast<std::uint32_t>(c - '0');
  }
  return value;
}

std::optional<std::uint8_t> parse_hex_byte(std::string_view text) {
  if (text.size() != 2) return std::nullopt;
  std::uint8_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + 2, value, 16);
  if (error != std::errc() || end != text.data() + 2) return std::nullopt;
  return value;
}

}  // namespace leadline::decode
