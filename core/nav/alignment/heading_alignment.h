#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>
#include <vector>

namespace leadline::nav {

/// Where dead reckoning by the unaligned velocity stood, and where a fix was, at the same time. North, east;
/// metres, each from an origin of its own.
struct ReckonedAndFixed {
  Eigen::Vector2d d, z;
};

struct HeadingAlignment {
  double alpha_rad;     ///< clockwise, to add to the direction of the velocity: v <- Rot(alpha) v; (-pi, pi]
  double scale;         ///< reference distance over DVL distance
  double sd_alpha_rad;  ///< formal: the wander of the heading sensor is not in it
  double spread_m;      ///< robust 2-D RMS of the residuals, at least the gamma given
  int inliers;          ///< of all; the residual of each is below three times the spread
};

/// Vectors that one alignment after the other reuses, so that only growth allocates.
struct AlignmentWorkspace {
  std::vector<double> residuals, sorted;
  std::vector<char> inlier;  ///< after a call: 1 where the pair was used
};

/// Kim 2010's heading alignment in the plane as a closed form (navigation-fusion 1.4): any angle, no start
/// value; fixes farther than three times the spread are left out, up to 10 rounds. gamma_m > 0: 2-D RMS of a
/// fix. Empty: fewer than 3 usable pairs, none of which moved, or a value that is not finite.
/// 5 min of a 0.5 m/s survey, gamma 5 m, fixes 8 s apart: within 2.5 deg; 20 min 0.8 deg; 3 h 0.35 deg.
[[nodiscard]] std::optional<HeadingAlignment> align_heading(std::span<const ReckonedAndFixed> pairs,
                                                            double gamma_m, AlignmentWorkspace& workspace);

}  // namespace leadline::nav
