#include "core/types/time.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

namespace leadline {
namespace {

constexpr std::int64_t kNsPerSecond = 1'000'000'000;
constexpr std::int64_t kNsPerDay = 86'400 * kNsPerSecond;

std::int64_t days_from_civil(int y, int m, int d) {
  return std::chrono::sys_days(std::chrono::year(y) / m / d).time_since_epoch().count();
}

// Days since 1970 on which GPS minus UTC grew by one second (IERS Bulletin C).
constexpr std::array<int, 18> kLeapDays = {4199, 4564, 4929,  5660,  6574,  7305,  7670,  8217,  8582,
                                           8947, 9496, 10043, 10592, 13149, 14245, 15522, 16617, 17167};

/// Exactly `count` decimal digits at the front of `text`, which loses them; -1 when they are not there.
int take_digits(std::string_view& text, int count) {
  if (static_cast<int>(text.size()) < count) return -1;
  int value = 0;
  for (int i = 0; i < count; ++i) {
    const char c = text[static_cast<std::size_t>(i)];
    if (c < '0' || c > '9') return -1;
    value = value * 10 + (c - '0');
  }
  text.remove_prefix(static_cast<std::size_t>(count));
  return value;
}

bool take(std::string_view& text, char wanted) {
  if (text.empty() || text.front() != wanted) return false;
  text.remove_prefix(1);
  return true;
}

bool take_date(std::string_view& text, Civil& c) {
  c.year = take_digits(text, 4);
  if (c.year < 0 || !take(text, '-')) return false;
  c.month = take_digits(text, 2);
  if (c.month < 0 || !take(text, '-')) return false;
  c.day = take_digits(text, 2);
  return c.day >= 0;
}

}  // namespace

Duration duration(double s) { return Duration(std::llround(s * 1e9)); }

Arrival arrival_at(Time host) {
  const std::int64_t us = (host.ns >= 0 ? host.ns + 500 : host.ns - 499) / 1000;
  return {us * 1000};
}

std::optional<Time> from_civil(const Civil& c) {
  if (c.year < 1700 || c.year > 2260 || c.month < 1 || c.month > 12 || c.day < 1) return std::nullopt;
  const auto ymd = std::chrono::year(c.year) / c.month / c.day;
  if (!ymd.ok() || c.hour < 0 || c.hour > 23 || c.minute < 0 || c.minute > 59 || c.second < 0 ||
      c.second > 60 || c.nanosecond < 0 || c.nanosecond >= kNsPerSecond)
    return std::nullopt;
  const std::int64_t s = (c.hour * 60 + c.minute) * 60 + c.second;
  return Time{days_from_civil(c.year, c.month, c.day) * kNsPerDay + s * kNsPerSecond + c.nanosecond};
}

Civil to_civil(Time t) {
  std::int64_t day = t.ns / kNsPerDay, rest = t.ns % kNsPerDay;
  if (rest < 0) rest += kNsPerDay, --day;
  const std::chrono::year_month_day ymd{std::chrono::sys_days(std::chrono::days(day))};
  const auto s = static_cast<int>(rest / kNsPerSecond);
  return {static_cast<int>(ymd.year()),
          static_cast<int>(static_cast<unsigned>(ymd.month())),
          static_cast<int>(static_cast<unsigned>(ymd.day())),
          s / 3600,
          s / 60 % 60,
          s % 60,
          static_cast<std::int32_t>(rest % kNsPerSecond)};
}

Time from_unix(double unix_s) {
  // Whole seconds apart: a double near 1.8e9 holds only 2e-7 s, and the fraction must not lose more.
  const double whole = std::floor(unix_s);
  return {static_cast<std::int64_t>(whole) * kNsPerSecond + std::llround((unix_s - whole) * 1e9)};
}

double to_unix(Time t) {
  // Whole seconds apart: nanoseconds since 1970 do not fit a double's 53 bits.
  const std::int64_t whole = t.ns / kNsPerSecond, rest = t.ns % kNsPerSecond;
  return static_cast<double>(whole) + static_cast<double>(rest) * 1e-9;
}

std::string iso8601(Time time, int decimals) {
  decimals = std::clamp(decimals, 0, 9);
  std::int64_t unit = 1;
  for (int i = decimals; i < 9; ++i) unit *= 10;
  const Civil c = to_civil(time + Duration(unit / 2));
  std::string text =
      fmt::format("{:04}-{:02}-{:02}T{:02}:{:02}:{:02}", c.year, c.month, c.day, c.hour, c.minute, c.second);
  if (decimals > 0) fmt::format_to(std::back_inserter(text), ".{:0{}}", c.nanosecond / unit, decimals);
  return text + "Z";
}

std::optional<Time> parse_iso8601(std::string_view text) {
  Civil c;
  if (!take_date(text, c) || !(take(text, 'T') || take(text, ' '))) return std::nullopt;
  c.hour = take_digits(text, 2);
  if (c.hour < 0 || !take(text, ':')) return std::nullopt;
  c.minute = take_digits(text, 2);
  if (c.minute < 0 || !take(text, ':')) return std::nullopt;
  c.second = take_digits(text, 2);
  if (c.second < 0) return std::nullopt;
  if (take(text, '.')) {
    int unit = 100'000'000, digits = 0;
    for (; !text.empty() && text.front() >= '0' && text.front() <= '9';
         text.remove_prefix(1), ++digits, unit /= 10)
      c.nanosecond += (text.front() - '0') * unit;
    if (digits == 0) return std::nullopt;
  }
  take(text, 'Z');
  if (!text.empty()) return std::nullopt;
  return from_civil(c);
}

std::optional<Time> parse_date(std::string_view text) {
  Civil c;
  if (!take_date(text, c) || !text.empty()) return std::nullopt;
  return from_civil(c);
}

int gps_minus_utc_s(Time utc) {
  const std::int64_t day = utc.ns / kNsPerDay;
  return static_cast<int>(std::upper_bound(kLeapDays.begin(), kLeapDays.end(), day) - kLeapDays.begin());
}

Time utc_from_gps(Time gps) {
  // The table is by UTC day; one refinement settles the seconds next to a leap.
  const Time first = gps - Duration(gps_minus_utc_s(gps) * kNsPerSecond);
  return gps - Duration(gps_minus_utc_s(first) * kNsPerSecond);
}

}  // namespace leadline
