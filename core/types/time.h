#pragma once

#include <chrono>
#include <compare>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace leadline {

using Duration = std::chrono::nanoseconds;

/// Length in seconds, for kernels.
[[nodiscard]] constexpr double seconds(Duration d) { return static_cast<double>(d.count()) * 1e-9; }
/// Nearest nanosecond; |s| below 9.2e9 s.
[[nodiscard]] Duration duration(double seconds);

/// UTC, nanoseconds since 1970-01-01T00:00:00Z without leap seconds: when something was true.
/// Range 1678 to 2262.
struct Time {
  std::int64_t ns = 0;

  constexpr auto operator<=>(const Time&) const = default;
  constexpr Duration operator-(Time o) const { return Duration(ns - o.ns); }
  constexpr Time operator+(Duration d) const { return {ns + d.count()}; }
  constexpr Time operator-(Duration d) const { return {ns - d.count()}; }
};

/// When a byte was heard: UTC at start plus steady elapsed time, a multiple of 1 us, never going back
/// within one run. The order of everything. Only a source's latency rule (flow/source_clock.h) turns an
/// Arrival into a Time.
struct Arrival {
  std::int64_t ns = 0;

  constexpr auto operator<=>(const Arrival&) const = default;
  constexpr Duration operator-(Arrival o) const { return Duration(ns - o.ns); }
  constexpr Arrival operator+(Duration d) const { return {ns + d.count()}; }
  /// The instant named by this arrival, as the host's clock read it.
  [[nodiscard]] constexpr Time host() const { return {ns}; }
};

/// The arrival at the nearest microsecond of a host time.
[[nodiscard]] Arrival arrival_at(Time host);

/// Calendar date and time of day, UTC. second may be 60 (leap second).
struct Civil {
  int year = 1970, month = 1, day = 1;
  int hour = 0, minute = 0, second = 0;
  std::int32_t nanosecond = 0;
};

/// Empty when a field is out of its calendar range (30 February, hour 24, year outside 1700..2260).
/// Second 60 is carried to 00:00:00 of the next minute.
[[nodiscard]] std::optional<Time> from_civil(const Civil& civil);
[[nodiscard]] Civil to_civil(Time time);

/// Seconds since 1970 as a decimal number, to the nearest nanosecond; |s| below 9.2e9.
[[nodiscard]] Time from_unix(double unix_s);
/// Seconds since 1970; exact to 0.12 us until 2038.
[[nodiscard]] double to_unix(Time time);

/// "2026-11-22T12:35:19.500Z" with `decimals` 0..9 fractional digits, rounded to nearest.
[[nodiscard]] std::string iso8601(Time time, int decimals = 3);

/// "YYYY-MM-DDThh:mm:ss[.f...][Z]" or with a blank for the T; empty when it is anything else.
[[nodiscard]] std::optional<Time> parse_iso8601(std::string_view text);
/// "YYYY-MM-DD"; midnight UTC.
[[nodiscard]] std::optional<Time> parse_date(std::string_view text);

/// GPS minus UTC, seconds, at a UTC time: 0 before 1980-01-06, 18 since 2017 (IERS Bulletin C).
[[nodiscard]] int gps_minus_utc_s(Time utc);
/// The UTC time of a clock that runs on GPS time.
[[nodiscard]] Time utc_from_gps(Time gps);

}  // namespace leadline
