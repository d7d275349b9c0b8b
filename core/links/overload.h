#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/types/time.h"

namespace leadline::links {

/// Which frames a core that cannot keep up leaves undecoded: those of the link that brings most of the
/// bytes, and only while frames are old when their turn comes. So the others are late by `kLate` at most for
/// long, and a core that is slow for everybody's sake decodes everything late.
class Overload {
 public:
  static constexpr Duration kLate{150'000'000}, kCaughtUp{20'000'000};
  static constexpr double kMostShare = 0.5;

  explicit Overload(std::size_t links) : bytes_(links), not_decoded_(links) {}

  /// Of the next frame in order, taken at `now`: is there time to decode it?
  [[nodiscard]] bool decode(std::size_t link, std::size_t bytes, Arrival heard, Arrival now);
  [[nodiscard]] std::uint64_t not_decoded(std::size_t link) const { return not_decoded_[link]; }

 private:
  std::vector<double> bytes_;  // of each link, forgotten with a time constant of a second
  std::vector<std::uint64_t> not_decoded_;
  double all_ = 0.0;
  Arrival faded_;
  bool late_ = false;
};

}  // namespace leadline::links
