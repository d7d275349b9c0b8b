#include "core/nav/filters/fix_gate.h"

#include <algorithm>
#include <cmath>

#include "core/types/expect.h"

namespace leadline::nav {
namespace {

template <std::size_t N>
double median(std::array<double, N>& values, int size) {
  const auto end = values.begin() + size;
  const auto middle = values.begin() + size / 2;
  std::nth_element(values.begin(), middle, end);
  if (size % 2 == 1) return *middle;
  return 0.5 * (*std::max_element(values.begin(), middle) + *middle);
}

}  // namespace

double DriftSinceFix::gate_m(double gamma_m, double declared_sd_m) const {
  return 3.0 * std::hypot(gamma_m, std::max(sd_m(), declared_sd_m));
}

void RejectedFixes::push(double t_s, const Eigen::Vector2d& e, double gamma_m) {
  LL_EXPECT(e.allFinite() && gamma_m > 0.0);
  if (size_ == kKept) {
    std::move(entries_.begin() + 1, entries_.end(), entries_.begin());
    --size_;
  }
  entries_[static_cast<std::size_t>(size_++)] = {t_s, e, gamma_m};
}

std::optional<RejectedFixes::Agreement> RejectedFixes::agreement(const Eigen::Vector2d& correction,
                                                                 const DriftSinceFix& drift) const {
  if (auto few = agreement_of(kShort)) {
    const double believable_m = 3.0 * entries_[static_cast<std::size_t>(size_ - 1)].gamma_m +
                                0.05 * drift.distance_m + 0.05 * drift.since_s;
    if ((few->e - correction).norm() <= believable_m) return few;
  }
  return agreement_of(kLong);
}

std::optional<RejectedFixes::Agreement> RejectedFixes::agreement_of(int n) const {
  if (size_ < n) return std::nullopt;
  const int first = std::max(0, size_ - n - kSpare);
  const int used = size_ - first;

  std::array<double, kKept> north{}, east{};
  for (int i = 0; i < used; ++i) {
    const auto at = static_cast<std::size_t>(i);
    const auto& e = entries_[static_cast<std::size_t>(first) + at].e;
    north[at] = e.x();
    east[at] = e.y();
  }
  const Eigen::Vector2d middle{median(north, used), median(east, used)};

  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  double variances = 0.0, oldest_s = 0.0;
  int good = 0;
  for (int i = first; i < size_; ++i) {
    const Entry& entry = entries_[static_cast<std::size_t>(i)];
    if (!((entry.e - middle).norm() < 2.0 * entry.gamma_m)) {
      if (i >= size_ - 2) return std::nullopt;
      continue;
    }
    if (good == 0) oldest_s = entry.t_s;
    sum += entry.e;
    variances += entry.gamma_m * entry.gamma_m / 2.0;
    ++good;
  }
  if (good < n) return std::nullopt;
  const double newest_s = entries_[static_cast<std::size_t>(size_ - 1)].t_s;
  return Agreement{sum / good, variances / (good * good), good, newest_s - oldest_s};
}

}  // namespace leadline::nav
