#include "core/nav/engines/reckoning_filter.h"

#include <algorithm>
#include <cmath>

namespace leadline::nav {
namespace {

constexpr std::size_t kMostPairs = 512;
constexpr double kPairEvery_s = 5.0;
constexpr int kFewestInliers = 20;
constexpr double kWellKnown_deg = 0.5;
/// One sigma after an alignment: a compass is off by another angle on the next leg.
constexpr double kAlignedSd_deg = 1.0;
/// A scale beyond this is no scale: the fixes or the velocities are wrong.
constexpr double kWidestScale = 0.2;
constexpr double kLeastScaleSd = 0.002;

std::variant<PlainCi, WindowedCi, ErrorState> filter_of(const Options& options) {
  const double gamma_m = options.aiding.gnss_drms_m;
  if (options.fusion.variant == "plain-ci") return PlainCi(gamma_m);
  if (options.fusion.variant == "windowed-ci") return WindowedCi(gamma_m);
  ErrorState::Settings settings;
  if (options.aiding.dvl_misalignment_deg > 0.0) settings.alpha_sd_deg = options.aiding.dvl_misalignment_deg;
  if (options.aiding.dvl_scale_ppm > 0.0) settings.scale_sd = options.aiding.dvl_scale_ppm * 1e-6;
  return ErrorState(settings);
}

}  // namespace

bool estimates_misalignment(const FusionOptions& options) {
  return options.variant != "plain-ci" && options.variant != "windowed-ci";
}

ReckoningFilter::ReckoningFilter(const Options& options) : filter_(filter_of(options)) {
  if (error_state() != nullptr) pairs_.reserve(kMostPairs);
}

void ReckoningFilter::reset(const Eigen::Matrix2d& P) {
  std::visit([&](auto& filter) { filter.reset(P); }, filter_);
}

Eigen::Vector2d ReckoningFilter::over_ground(const Eigen::Vector2d& v_measured) const {
  return error_state() != nullptr ? error_state()->over_ground(v_measured) : v_measured;
}

void ReckoningFilter::predict(const Eigen::Vector2d& v_ne_mps, double dt_s) {
  std::visit([&](auto& filter) { (void)filter.predict(v_ne_mps, dt_s); }, filter_);
}

FixResult ReckoningFilter::fix(const Eigen::Vector2d& residual, double t_s, double gamma_m,
                               double declared_sd_m) {
  return std::visit([&](auto& filter) { return filter.fix(residual, t_s, gamma_m, declared_sd_m); }, filter_);
}

std::optional<HeadingAlignment> ReckoningFilter::align(double t_s, const ReckonedAndFixed& pair,
                                                       double gamma_m) {
  auto* filter = std::get_if<ErrorState>(&filter_);
  if (filter == nullptr || aligned_) return std::nullopt;
  if (!pairs_.empty() && t_s - last_pair_s_ < kPairEvery_s) return std::nullopt;
  last_pair_s_ = t_s;
  if (pairs_.size() == kMostPairs) {
    for (std::size_t k = 0; k < kMostPairs / 2; ++k) pairs_[k] = pairs_[2 * k];
    pairs_.resize(kMostPairs / 2);
  }
  pairs_.push_back(pair);
  largest_gamma_m_ = std::max(largest_gamma_m_, gamma_m);
  if (pairs_.size() < kFewestInliers) return std::nullopt;
  const auto found = align_heading(pairs_, largest_gamma_m_, workspace_);
  if (!found || found->inliers < kFewestInliers || found->sd_alpha_rad > kWellKnown_deg * kRadPerDeg ||
      std::abs(found->scale - 1.0) > kWidestScale)
    return std::nullopt;
  aligned_ = true;
  pairs_.clear();
  const double apart_rad = Angle::rad(found->alpha_rad - filter->alpha_rad()).wrapped_pi().rad();
  if (std::abs(apart_rad) < 3.0 * kWellKnown_deg * kRadPerDeg) return std::nullopt;
  filter->align(found->alpha_rad, kAlignedSd_deg * kRadPerDeg, 1.0 - found->scale,
                std::max(found->sd_alpha_rad, kLeastScaleSd));
  return found;
}

Eigen::Matrix2d ReckoningFilter::P() const {
  if (const auto* filter = error_state()) return filter->stated_covariance();
  return std::visit([](const auto& filter) -> Eigen::Matrix2d { return filter.P(); }, filter_);
}

const DriftSinceFix& ReckoningFilter::drift() const {
  return std::visit([](const auto& filter) -> const DriftSinceFix& { return filter.drift(); }, filter_);
}

std::optional<Angle> ReckoningFilter::misalignment() const {
  if (const auto* filter = error_state()) return Angle::rad(filter->alpha_rad());
  return std::nullopt;
}

}  // namespace leadline::nav
