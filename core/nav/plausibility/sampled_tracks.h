#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>

namespace leadline::nav {

/// One quantity once a second over the last minute; a second in which nobody spoke is empty.
class SampledTrack {
 public:
  static constexpr std::size_t kSeconds = 64;
  void push(double value) {
    values_[next_] = value;
    next_ = (next_ + 1) % kSeconds;
    used_ = used_ || std::isfinite(value);
  }
  [[nodiscard]] bool used() const { return used_; }
  /// `ago` seconds before the newest; NaN: empty.
  [[nodiscard]] double at(std::size_t ago) const {
    return values_[(next_ + 2 * kSeconds - 1 - ago) % kSeconds];
  }

 private:
  static std::array<double, kSeconds> empty() {
    std::array<double, kSeconds> values{};
    values.fill(std::numeric_limits<double>::quiet_NaN());
    return values;
  }
  std::array<double, kSeconds> values_ = empty();
  std::size_t next_ = 0;
  bool used_ = false;
};

/// How two tracks go together: the slope of y on x, the share of the smaller one's variance it explains, and
/// the spread of both.
struct Regression {
  std::size_t count = 0;
  double slope = 0.0, r2 = 0.0, sd_x = 0.0, sd_y = 0.0, span_x = 0.0, span_y = 0.0;
};
/// step 0: of the values; else of their changes over `step` seconds, which no constant drift touches.
[[nodiscard]] Regression regress(const SampledTrack& y, const SampledTrack& x, std::size_t step);
/// The median of y / x where both are above `least`; empty with fewer than ten.
[[nodiscard]] std::optional<double> median_ratio(const SampledTrack& y, const SampledTrack& x, double least);
/// The direction of y - x and the largest distance from it of nine tenths of them; empty with fewer than 20.
struct Offset {
  double mean_rad, spread_rad;
};
[[nodiscard]] std::optional<Offset> offset(const SampledTrack& y, const SampledTrack& x);

}  // namespace leadline::nav
