#pragma once

#include <array>
#include <optional>

#include "core/types/time.h"

namespace leadline::nav {

/// How often something comes: the median of the last 15 intervals, which a gap or a burst does not move.
class Intervals {
 public:
  /// False, and nothing is kept, when `t` is not later than the last one: time does not go back.
  bool event(Time t);

  [[nodiscard]] std::optional<Time> last() const { return last_; }
  /// Empty before the second event.
  [[nodiscard]] std::optional<Duration> median() const;

 private:
  static constexpr std::size_t kKept = 15;
  std::array<Duration, kKept> intervals_{};
  std::size_t size_ = 0, next_ = 0;
  std::optional<Time> last_;
};

}  // namespace leadline::nav
