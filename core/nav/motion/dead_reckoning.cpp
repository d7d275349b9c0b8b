#include "core/nav/motion/dead_reckoning.h"

#include <algorithm>
#include <cmath>

#include "core/geo/geodesy.h"

namespace leadline::nav {
namespace {

/// Of the larger of the two speeds at its ends: how far off, one sigma, their mean may be in a gap.
constexpr double kGapShare = 0.5;
constexpr double kGapLeastMps = 0.1;
constexpr double kBeyondEndS = 3.0;

}  // namespace

double DeadReckoning::longest_interval_s() const {
  const auto median = intervals_.median();
  return median ? std::max(1.0, 3.0 * seconds(*median)) : kBeyondEndS;
}

void DeadReckoning::push(Time t) {
  time_ = t;
  points_[(first_ + count_) % kPoints] = {t, travelled_};
  if (count_ < kPoints)
    ++count_;
  else
    first_ = (first_ + 1) % kPoints;
}

Geodetic DeadReckoning::from_here(const Eigen::Vector2d& displacement) const {
  return geo::displaced(position_, displacement.x(), displacement.y(), -depth_m_);
}

void DeadReckoning::move(const Eigen::Vector2d& displacement) {
  position_ = from_here(displacement);
  travelled_ += displacement;
  net_ += displacement;
}

void DeadReckoning::start(Time t, const Geodetic& position, const Eigen::Matrix2d& P0) {
  started_ = true;
  position_ = position;
  count_ = first_ = 0;
  travelled_.setZero();
  fixed(P0);
  push(t);
  const auto heard = intervals_.last();
  if (heard && *heard > t && seconds(*heard - t) <= longest_interval_s()) {
    move(last_.v_ne * seconds(*heard - t));
    push(*heard);
  }
}

std::optional<DeadReckoning::Step> DeadReckoning::velocity(Time t, const Velocity& v) {
  const Velocity before = last_;
  const bool first = !intervals_.last().has_value();
  const double longest_s = longest_interval_s();
  hear(t, v);
  if (!started_ || t <= time_) return std::nullopt;
  Step step;
  step.dt_s = seconds(t - time_);
  step.gap = step.dt_s > longest_s;
  if (!step.gap) {
    step.displacement = v.v_ne * step.dt_s;
    noise_var_m2_ += std::pow(v.noise_mps * step.dt_s, 2);
  } else {
    const Eigen::Vector2d v_start = first ? v.v_ne : before.v_ne;
    step.displacement = 0.5 * (v_start + v.v_ne) * step.dt_s;
    const double fastest_mps = std::max({v_start.norm(), v.v_ne.norm(), kGapLeastMps});
    noise_var_m2_ += std::pow(kGapShare * fastest_mps * step.dt_s, 2);
  }
  drift_m_ += v.drift_mps * step.dt_s;
  move(step.displacement);
  push(t);
  return step;
}

void DeadReckoning::hear(Time t, const Velocity& v) {
  if (intervals_.event(t)) last_ = v;
}

void DeadReckoning::advance(Time t, const Eigen::Vector2d& displacement) {
  if (!started_ || t <= time_) return;
  move(displacement);
  push(t);
}

void DeadReckoning::shift(const Eigen::Vector2d& step) {
  position_ = from_here(step);
}

void DeadReckoning::fixed(const Eigen::Matrix2d& P) {
  P0_ = P;
  net_.setZero();
  noise_var_m2_ = drift_m_ = 0.0;
}

std::optional<Geodetic> DeadReckoning::position_at(Time t) const {
  if (!started_) return std::nullopt;
  if (t >= time_) {
    const double beyond_s = seconds(t - time_);
    if (beyond_s == 0.0) return position_;
    const auto heard = intervals_.last();
    if (!heard || seconds(t - *heard) > std::max(kBeyondEndS, longest_interval_s())) return std::nullopt;
    const Eigen::Vector2d ahead = last_.v_ne * beyond_s;
    return from_here(ahead);
  }
  if (t < point(0).t) return std::nullopt;
  std::size_t low = 0, high = count_ - 1;  // point(low).t <= t < point(high).t
  while (high - low > 1) {
    const std::size_t middle = (low + high) / 2;
    (point(middle).t <= t ? low : high) = middle;
  }
  const Point &a = point(low), &b = point(high);
  const Eigen::Vector2d at =
      a.travelled + (b.travelled - a.travelled) * (seconds(t - a.t) / seconds(b.t - a.t));
  const Eigen::Vector2d back = at - travelled_;
  return from_here(back);
}

Eigen::Matrix2d DeadReckoning::grown() const {
  const double along = systematic_.scale * systematic_.scale;
  const double across = systematic_.angle_rad * systematic_.angle_rad;
  const double white = noise_var_m2_ + drift_m_ * drift_m_;
  const double n = net_.x(), e = net_.y(), ne = (along - across) * n * e;
  Eigen::Matrix2d grown;  // by element: exactly symmetric
  grown << along * n * n + across * e * e + white, ne, ne, along * e * e + across * n * n + white;
  return grown;
}

}  // namespace leadline::nav
