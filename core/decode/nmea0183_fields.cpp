#include "core/decode/nmea0183_fields.h"

#include "core/decode/nmea0183_words.h"
#include "core/decode/number.h"

namespace leadline::decode::nmea0183 {
namespace {

constexpr std::int64_t kNsPerSecond = 1'000'000'000;

bool is_digit(char c) { return c >= '0' && c <= '9'; }
int two_digits(const char* p) {
  return is_digit(p[0]) && is_digit(p[1]) ? (p[0] - '0') * 10 + (p[1] - '0') : -1;
}

/// ".s..." as ns, digits beyond the ninth dropped; -1 when it is anything else.
std::int64_t fraction_ns(std::string_view text) {
  if (text.empty()) return 0;
  if (text.front() != '.' || text.size() < 2) return -1;
  std::int64_t ns = 0, unit = kNsPerSecond / 10;
  for (const char c : text.substr(1)) {
    if (!is_digit(c)) return -1;
    ns += (c - '0') * unit;
    unit /= 10;
  }
  return ns;
}

}  // namespace

Fields::Fields(std::string_view text) : text_(text) {
  const auto size = static_cast<std::uint16_t>(text.size());
  count_ = 1;
  starts_[0] = 0;
  const auto comma_at = [&](std::size_t i) {
    starts_[static_cast<std::size_t>(count_)] = static_cast<std::uint16_t>(i + 1);
    return count_ == kMost || (++count_, false);  // the rest is not wanted
  };
  std::size_t i = 0;
  for (; i + 8 <= size; i += 8)
    for (std::uint64_t commas = each_equal(load_word(text.data() + i), ','); commas != 0;
         commas &= commas - 1)
      if (comma_at(i + static_cast<std::size_t>(first_byte(commas)))) return;
  for (; i < size; ++i)
    if (text[i] == ',' && comma_at(i)) return;
  starts_[static_cast<std::size_t>(count_)] = static_cast<std::uint16_t>(size + 1);
}

char Fields::letter(int n) {
  const std::string_view field = text(n);
  if (field.size() > 1) refuse(kReasonFields);
  return field.size() == 1 ? field[0] : '\0';
}

std::optional<double> Fields::number(int n) {
  const std::string_view field = text(n);
  if (field.empty()) return std::nullopt;
  const auto value = parse_number(field);
  if (!value) refuse(kReasonFields);
  return value;
}

std::optional<double> Fields::number(int n, double lowest, double highest) {
  const auto value = number(n);
  if (value && (*value < lowest || *value > highest)) refuse(kReasonRange);
  return value;
}

std::optional<std::uint32_t> Fields::digits(int n, std::uint32_t highest) {
  const std::string_view field = text(n);
  if (field.empty()) return std::nullopt;
  const auto value = parse_digits(field);
  if (!value)
    refuse(kReasonFields);
  else if (*value > highest)
    refuse(kReasonRange);
  return value;
}

std::optional<Angle> Fields::heading(int n) {
  const auto value = number(n, 0.0, 360.0);
  if (!value) return std::nullopt;
  return Angle::deg(*value == 360.0 ? 0.0 : *value);
}

std::optional<Angle> Fields::angle(int n, double limit_deg) {
  const auto value = number(n, -limit_deg, limit_deg);
  if (!value) return std::nullopt;
  return Angle::deg(*value);
}

std::optional<std::int64_t> Fields::time_of_day(int n) {
  const std::string_view field = text(n);
  if (field.empty()) return std::nullopt;
  if (field.size() < 6) {
    refuse(kReasonFields);
    return std::nullopt;
  }
  const int hour = two_digits(field.data()), minute = two_digits(field.data() + 2),
            second = two_digits(field.data() + 4);
  const std::int64_t ns = fraction_ns(field.substr(6));
  if (hour < 0 || minute < 0 || second < 0 || ns < 0) {
    refuse(kReasonFields);
    return std::nullopt;
  }
  if (hour > 23 || minute > 59 || second > 60) refuse(kReasonRange);
  return std::int64_t{(hour * 60 + minute) * 60 + second} * kNsPerSecond + ns;
}

std::optional<double> Fields::degrees(int n, char positive, char negative, double limit) {
  const auto value = number(n);
  const char side = letter(n + 1);
  if (!value || side == '\0') return std::nullopt;
  if (side != positive && side != negative) {
    refuse(kReasonFields);
    return std::nullopt;
  }
  if (*value < 0.0 || *value >= 100.0 * 181.0) {
    refuse(kReasonRange);
    return std::nullopt;
  }
  const double whole = static_cast<double>(static_cast<int>(*value) / 100), minutes = *value - whole * 100.0;
  const double size = whole + minutes / 60.0;
  if (minutes >= 60.0 || size > limit) refuse(kReasonRange);
  return side == positive ? size : -size;
}

std::optional<Geodetic> Fields::position(int n) {
  const auto lat = degrees(n, 'N', 'S', 90.0), lon = degrees(n + 2, 'E', 'W', 180.0);
  if (!lat || !lon) return std::nullopt;
  return Geodetic{Angle::deg(*lat), Angle::deg(*lon == 180.0 ? -180.0 : *lon)};
}

std::optional<Angle> Fields::directed(int n, char positive, char negative) {
  const auto value = angle(n, 180.0);
  const char side = letter(n + 1);
  if (!value || side == '\0') return std::nullopt;
  if (side != positive && side != negative) refuse(kReasonFields);
  return side == positive ? *value : -*value;
}

}  // namespace leadline::decode::nmea0183
