#pragma once

#include <cstdint>
#include <optional>

#include "core/types/time.h"

namespace leadline::decode::nmea0183 {

/// Which day a time of day belongs to, and which century a two-digit year (wire-formats 1.1).
class Dating {
 public:
  /// host: to date with while there is neither an arrival nor a date.
  explicit Dating(std::optional<Time> host) : host_(host) {}

  /// The instant within 12 h of the reference: the source's newest date when at most 5 s old, else the
  /// arrival, else (plain streams) the last instant dated, else the host time. Empty when there is none of
  /// them.
  [[nodiscard]] std::optional<Time> instant(std::int64_t time_of_day_ns, std::optional<Arrival> arrival);
  /// A date and time the source gave in full. False when it is 1024 or 2048 weeks off the arrival, within a
  /// day: GPS weeks counted over, not a date to go by.
  [[nodiscard]] bool learn(Time full, std::optional<Arrival> arrival);
  /// Within -50..+49 years of the host's year.
  [[nodiscard]] int full_year(int two_digits, std::optional<Arrival> arrival) const;

 private:
  std::optional<Time> host_;
  std::optional<Time> last_;  // the newest instant dated or learnt
  struct Learnt {
    Time time;
    Arrival arrival;
  };
  std::optional<Learnt> learnt_;
};

}  // namespace leadline::decode::nmea0183
