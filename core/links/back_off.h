#pragma once

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <random>

namespace leadline::links {

/// How long to wait before the next try: twice as long each time from `first` to `last`, each a quarter more
/// or less by chance, so that many links that fell together do not come back together.
class BackOff {
 public:
  using Wait = std::chrono::milliseconds;

  BackOff(Wait first, Wait last, std::uint32_t seed)
      : first_(first), last_(last), next_(first), random_(seed) {}

  [[nodiscard]] Wait next() {
    const double factor = std::uniform_real_distribution<double>(0.75, 1.25)(random_);
    const Wait wait(static_cast<Wait::rep>(static_cast<double>(next_.count()) * factor));
    next_ = std::min(last_, next_ * 2);
    return std::clamp(wait, first_, last_);
  }
  void reset() { next_ = first_; }

 private:
  Wait first_, last_, next_;
  std::minstd_rand random_;
};

}  // namespace leadline::links
