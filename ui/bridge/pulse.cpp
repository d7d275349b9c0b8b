#include "ui/bridge/pulse.h"

#include <algorithm>

namespace leadline::ui {
namespace {

constexpr std::int64_t kFarthestClockNs = 60'000'000'000;

}  // namespace

Time believable(Time valid, Arrival arrival) {
  // As unsigned: a broken clock may be further away than a Duration goes.
  const auto before = static_cast<std::uint64_t>(arrival.ns) - static_cast<std::uint64_t>(valid.ns);
  const bool near = before + static_cast<std::uint64_t>(kFarthestClockNs) <=
                    2 * static_cast<std::uint64_t>(kFarthestClockNs);
  return near ? valid : arrival.host();
}

void Pulse::beat(Time t) {
  if (last_ && t <= *last_) return;
  if (last_) {
    intervals_s_[at_] = static_cast<float>(seconds(t - *last_));
    at_ = static_cast<std::uint8_t>((at_ + 1) % intervals_s_.size());
    count_ = static_cast<std::uint8_t>(std::min<std::size_t>(count_ + 1U, intervals_s_.size()));
  }
  last_ = t;
}

double Pulse::period_s() const {
  if (count_ < 2) return 0.0;
  auto sorted = intervals_s_;
  const auto end = sorted.begin() + count_;
  const auto quartile = sorted.begin() + (3 * count_ - 1) / 4;
  std::nth_element(sorted.begin(), quartile, end);
  return static_cast<double>(*quartile);
}

void RecentCount::add(Arrival arrival) {
  const std::int64_t bin = arrival.ns / kBinNs;
  if (!first_) {
    first_ = arrival;
    newest_bin_ = bin;
  }
  if (bin < newest_bin_) return;
  if (bin - newest_bin_ >= static_cast<std::int64_t>(kBins)) {
    bins_.fill(0);
  } else {
    for (auto b = newest_bin_ + 1; b <= bin; ++b) bins_[static_cast<std::size_t>(b) % kBins] = 0;
  }
  newest_bin_ = bin;
  auto& count = bins_[static_cast<std::size_t>(bin) % kBins];
  if (count < UINT16_MAX) ++count;
}

int RecentCount::count(Arrival now) const {
  if (!first_) return 0;
  const std::int64_t now_bin = now.ns / kBinNs;
  int sum = 0;
  for (auto b = newest_bin_; b > newest_bin_ - static_cast<std::int64_t>(kBins); --b)
    if (b <= now_bin && now_bin - b < static_cast<std::int64_t>(kBins))
      sum += bins_[static_cast<std::size_t>(b) % kBins];
  return sum;
}

double RecentCount::rate_hz(Arrival now) const {
  if (!first_) return 0.0;
  return count(now) / std::clamp(seconds(now - *first_), 1.0, 5.0);
}

}  // namespace leadline::ui
