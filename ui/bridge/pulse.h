#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "core/types/time.h"

namespace leadline::ui {

/// A device's time where it can be true: a clock more than a minute from the arrival is a wrong clock (the
/// latency shown says so), and age then counts from the arrival.
[[nodiscard]] Time believable(Time valid, Arrival arrival);

/// The nominal interval of something that comes again and again.
class Pulse {
 public:
  /// How many beats a period is made of: who wants the same period again starts that many before.
  static constexpr int kBeats = 13;

  /// A beat not later than the last one is no beat.
  void beat(Time t);
  [[nodiscard]] std::optional<Time> last() const { return last_; }
  /// The upper quartile of the last twelve intervals: neither a lost sample nor sentences that come in bursts
  /// of two or three change it. 0: fewer than two intervals.
  [[nodiscard]] double period_s() const;

 private:
  std::array<float, kBeats - 1> intervals_s_{};
  std::uint8_t count_ = 0, at_ = 0;
  std::optional<Time> last_;
};

/// How many came within the last five seconds.
class RecentCount {
 public:
  void add(Arrival arrival);
  /// A second, over the five before `now`, or since the first one; never over less than one.
  [[nodiscard]] double rate_hz(Arrival now) const;
  [[nodiscard]] int count(Arrival now) const;

 private:
  static constexpr std::int64_t kBinNs = 100'000'000;
  static constexpr std::size_t kBins = 50;
  std::array<std::uint16_t, kBins> bins_{};
  std::int64_t newest_bin_ = 0;
  std::optional<Arrival> first_;
};

}  // namespace leadline::ui
