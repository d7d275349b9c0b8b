#include "core/nav/plausibility/sampled_tracks.h"

#include <algorithm>

#include "core/types/angle.h"

namespace leadline::nav {

Regression regress(const SampledTrack& y, const SampledTrack& x, std::size_t step) {
  const auto value = [step](const SampledTrack& track, std::size_t i) {
    return step == 0 ? track.at(i) : track.at(i) - track.at(i + step);
  };
  Regression r;
  double mean_x = 0.0, mean_y = 0.0, low_x = 0.0, high_x = 0.0, low_y = 0.0, high_y = 0.0;
  const std::size_t end = SampledTrack::kSeconds - step;
  for (std::size_t i = 0; i < end; ++i) {
    const double vx = value(x, i), vy = value(y, i);
    if (!std::isfinite(vx) || !std::isfinite(vy)) continue;
    if (r.count++ == 0) low_x = high_x = vx, low_y = high_y = vy;
    low_x = std::min(low_x, vx), high_x = std::max(high_x, vx);
    low_y = std::min(low_y, vy), high_y = std::max(high_y, vy);
    mean_x += vx, mean_y += vy;
  }
  if (r.count < 3) return {};
  const double n = static_cast<double>(r.count);
  mean_x /= n, mean_y /= n;
  double xx = 0.0, xy = 0.0, yy = 0.0;
  for (std::size_t i = 0; i < end; ++i) {
    const double vx = value(x, i) - mean_x, vy = value(y, i) - mean_y;
    if (!std::isfinite(vx) || !std::isfinite(vy)) continue;
    xx += vx * vx, xy += vx * vy, yy += vy * vy;
  }
  r.sd_x = std::sqrt(xx / n), r.sd_y = std::sqrt(yy / n);
  r.span_x = high_x - low_x, r.span_y = high_y - low_y;
  if (xx > 0.0 && yy > 0.0) r.slope = xy / xx, r.r2 = xy * xy / (xx * yy);
  return r;
}

std::optional<double> median_ratio(const SampledTrack& y, const SampledTrack& x, double least) {
  std::array<double, SampledTrack::kSeconds> ratios{};
  std::size_t n = 0;
  for (std::size_t i = 0; i < ratios.size(); ++i)
    if (y.at(i) > least && x.at(i) > least) ratios[n++] = y.at(i) / x.at(i);
  if (n < 10) return std::nullopt;
  const auto middle = ratios.begin() + static_cast<std::ptrdiff_t>(n / 2);
  std::nth_element(ratios.begin(), middle, ratios.begin() + static_cast<std::ptrdiff_t>(n));
  return *middle;
}

std::optional<Offset> offset(const SampledTrack& y, const SampledTrack& x) {
  double c = 0.0, s = 0.0;
  std::size_t n = 0;
  for (std::size_t i = 0; i < SampledTrack::kSeconds; ++i) {
    const double d = y.at(i) - x.at(i);
    if (std::isfinite(d)) c += std::cos(d), s += std::sin(d), ++n;
  }
  if (n < 20) return std::nullopt;
  const double mean = std::atan2(s, c);
  std::array<double, SampledTrack::kSeconds> off{};
  n = 0;
  for (std::size_t i = 0; i < SampledTrack::kSeconds; ++i) {
    const double d = y.at(i) - x.at(i);
    if (std::isfinite(d)) off[n++] = std::abs(Angle::rad(d - mean).wrapped_pi().rad());
  }
  const auto most = off.begin() + static_cast<std::ptrdiff_t>(9 * n / 10);
  std::nth_element(off.begin(), most, off.begin() + static_cast<std::ptrdiff_t>(n));
  return Offset{mean, *most};
}

}  // namespace leadline::nav
