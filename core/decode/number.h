#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace leadline::decode {

/// [+-]?digits[.digits], at most 20 digits: the only numbers a telegram may hold (no nan, inf, hex, exponent,
/// blanks or locale). Correctly rounded. Empty when the text is anything else.
[[nodiscard]] std::optional<double> parse_number(std::string_view text);

/// parse_number that also takes an exponent (research tables, Water Linked covariances).
[[nodiscard]] std::optional<double> parse_scientific(std::string_view text);

/// 1 to 9 decimal digits and nothing else.
[[nodiscard]] std::optional<std::uint32_t> parse_digits(std::string_view text);

/// Two hex digits, either case.
[[nodiscard]] std::optional<std::uint8_t> parse_hex_byte(std::string_view text);

}  // namespace leadline::decode
