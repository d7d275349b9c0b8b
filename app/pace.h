#pragma once

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <optional>
#include <string>
#include <thread>

#include "app/interrupt.h"
#include "core/types/time.h"

namespace leadline::app {

/// Holds a replay back to a factor of real time.
class Pace {
 public:
  /// "max" (0: not held back) or a factor above 0; empty when it is neither.
  [[nodiscard]] static std::optional<double> parse(const std::string& text) {
    if (text == "max") return 0.0;
    char* end = nullptr;
    const double speed = std::strtod(text.c_str(), &end);
    if (text.empty() || *end != '\0' || !(speed > 0.0) || speed > 1e6) return std::nullopt;
    return speed;
  }

  explicit Pace(double speed) : speed_(speed) {}

  void wait_for(Arrival arrival) {
    if (speed_ <= 0.0) return;
    if (!first_) first_ = arrival, started_ = Steady::now();
    const auto due = started_ + std::chrono::nanoseconds(static_cast<std::int64_t>(
                                    static_cast<double>((arrival - *first_).count()) / speed_));
    while (!interrupted() && Steady::now() < due)
      std::this_thread::sleep_for(
          std::min<Steady::duration>(due - Steady::now(), std::chrono::milliseconds(100)));
  }

 private:
  using Steady = std::chrono::steady_clock;
  double speed_;
  std::optional<Arrival> first_;
  Steady::time_point started_;
};

}  // namespace leadline::app
