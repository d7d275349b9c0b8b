#include "core/nav/availability/intervals.h"

#include <algorithm>

namespace leadline::nav {

bool Intervals::event(Time t) {
  if (last_ && t <= *last_) return false;
  if (last_) {
    intervals_[next_] = t - *last_;
    next_ = (next_ + 1) % kKept;
    size_ = std::min(size_ + 1, kKept);
  }
  last_ = t;
  return true;
}

std::optional<Duration> Intervals::median() const {
  if (size_ == 0) return std::nullopt;
  auto sorted = intervals_;
  const auto end = sorted.begin() + static_cast<std::ptrdiff_t>(size_);
  std::sort(sorted.begin(), end);
  return (sorted[(size_ - 1) / 2] + sorted[size_ / 2]) / 2;
}

}  // namespace leadline::nav
