#include "core/links/overload.h"

#include <algorithm>
#include <cmath>

namespace leadline::links {

bool Overload::decode(std::size_t link, std::size_t bytes, Arrival heard, Arrival now) {
  if (const Duration passed = heard - faded_; passed > std::chrono::milliseconds(50)) {
    const double left = std::exp(-seconds(passed));
    for (double& b : bytes_) b *= left;
    all_ *= left;
    faded_ = heard;
  }
  bytes_[link] += static_cast<double>(bytes);
  all_ += static_cast<double>(bytes);
  const Duration late = now - heard;
  if (late > kLate) late_ = true;
  if (late < kCaughtUp) late_ = false;
  if (!late_ || bytes_[link] <= kMostShare * all_) return true;
  ++not_decoded_[link];
  return false;
}

}  // namespace leadline::links
