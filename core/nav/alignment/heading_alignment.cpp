#include "core/nav/alignment/heading_alignment.h"

#include <algorithm>
#include <cmath>

namespace leadline::nav {
namespace {

using Eigen::Vector2d;

constexpr int kRounds = 10, kFewest = 3;
/// Sum of squares about the mean below which nothing has moved.
constexpr double kStill_m2 = 1e-6;
/// The median of a Rayleigh distribution over its sigma an axis.
constexpr double kRayleighMedian = 1.177;

double median(std::vector<double>& values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  if (values.size() % 2 == 1) return *middle;
  return 0.5 * (*middle + *std::max_element(values.begin(), middle));
}

}  // namespace

std::optional<HeadingAlignment> align_heading(std::span<const ReckonedAndFixed> pairs, double gamma_m,
                                              AlignmentWorkspace& workspace) {
  if (!(gamma_m > 0.0) || !std::isfinite(gamma_m)) return std::nullopt;
  for (const auto& pair : pairs)
    if (!pair.d.allFinite() || !pair.z.allFinite()) return std::nullopt;
  auto& inlier = workspace.inlier;
  auto& residuals = workspace.residuals;
  inlier.assign(pairs.size(), 1);
  residuals.resize(pairs.size());

  HeadingAlignment found{};
  for (int round = 0; round < kRounds; ++round) {
    const int m = static_cast<int>(std::count(inlier.begin(), inlier.end(), 1));
    if (m < kFewest) return std::nullopt;
    Vector2d d_mean = Vector2d::Zero(), z_mean = Vector2d::Zero();
    for (std::size_t k = 0; k < pairs.size(); ++k)
      if (inlier[k] != 0) d_mean += pairs[k].d / m, z_mean += pairs[k].z / m;
    double C = 0.0, S = 0.0, moved_m2 = 0.0;
    for (std::size_t k = 0; k < pairs.size(); ++k) {
      if (inlier[k] == 0) continue;
      const Vector2d d = pairs[k].d - d_mean, z = pairs[k].z - z_mean;
      C += d.dot(z);
      S += d.x() * z.y() - d.y() * z.x();
      moved_m2 += d.squaredNorm();
    }
    if (!(moved_m2 > kStill_m2)) return std::nullopt;
    found.alpha_rad = std::atan2(S, C);
    found.scale = std::hypot(C, S) / moved_m2;
    found.inliers = m;

    const double c = std::cos(found.alpha_rad), s = std::sin(found.alpha_rad);
    double squares_m2 = 0.0;
    for (std::size_t k = 0; k < pairs.size(); ++k) {
      const Vector2d d = pairs[k].d - d_mean;
      const Vector2d turned = found.scale * Vector2d(c * d.x() - s * d.y(), s * d.x() + c * d.y());
      residuals[k] = (pairs[k].z - z_mean - turned).norm();
      if (inlier[k] != 0) squares_m2 += residuals[k] * residuals[k];
    }
    found.sd_alpha_rad = std::sqrt(squares_m2 / 2.0 / (m - 2)) / std::sqrt(moved_m2);
    workspace.sorted = residuals;
    found.spread_m = std::max(gamma_m, std::sqrt(2.0) * median(workspace.sorted) / kRayleighMedian);
    bool same = true;
    for (std::size_t k = 0; k < pairs.size(); ++k) {
      const char in = residuals[k] < 3.0 * found.spread_m ? 1 : 0;
      same = same && in == inlier[k];
      inlier[k] = in;
    }
    if (same) break;
  }
  return found;
}

}  // namespace leadline::nav
