#pragma once

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdint>

namespace leadline::app {

/// How late many things were: quantiles to 1 % of themselves, in fixed memory however long it goes on.
class Lateness {
 public:
  void add(std::chrono::nanoseconds late) {
    const double us = std::max(0.0, static_cast<double>(late.count()) * 1e-3);
    max_us_ = std::max(max_us_, us);
    ++count_;
    const double place = std::log1p(us) / kStep;
    ++counts_[static_cast<std::size_t>(std::min(place, static_cast<double>(kPlaces - 1)))];
  }
  [[nodiscard]] std::uint64_t count() const { return count_; }
  [[nodiscard]] double max_ms() const { return max_us_ * 1e-3; }
  /// The lateness that a share of all did not exceed; 0 when there was nothing.
  [[nodiscard]] double quantile_ms(double share) const {
    const auto wanted = static_cast<std::uint64_t>(std::ceil(share * static_cast<double>(count_)));
    std::uint64_t below = 0;
    for (std::size_t i = 0; i < kPlaces; ++i)
      if ((below += counts_[i]) >= wanted && below > 0)
        return std::min(max_us_, std::expm1((static_cast<double>(i) + 0.5) * kStep)) * 1e-3;
    return max_ms();
  }

 private:
  static constexpr double kStep = 0.02;
  static constexpr std::size_t kPlaces = 1200;  // to e^24 us, seven hours
  std::array<std::uint64_t, kPlaces> counts_{};
  std::uint64_t count_ = 0;
  double max_us_ = 0.0;
};

}  // namespace leadline::app
