#pragma once

#include <optional>

#include "core/types/time.h"

namespace leadline::nav {

/// Lets at most `rate_hz` rows a second through.
class RowPace {
 public:
  explicit RowPace(double rate_hz) : shortest_(duration(1.0 / rate_hz) - Duration(1'000'000)) {}

  /// Rows never go back in time; ones closer than the pace (a millisecond's jitter granted) are left out.
  bool due(Time t) {
    if (last_ && (t <= *last_ || t - *last_ < shortest_)) return false;
    last_ = t;
    return true;
  }

 private:
  Duration shortest_;
  std::optional<Time> last_;
};

}  // namespace leadline::nav
