#pragma once

#include <optional>
#include <variant>

#include "core/nav/alignment/heading_alignment.h"
#include "core/nav/engines/options.h"
#include "core/nav/filters/covariance_intersection.h"
#include "core/nav/filters/error_state.h"
#include "core/nav/filters/windowed_covariance.h"
#include "core/types/angle.h"

namespace leadline::nav {

/// The misalignment and scale of the DVL are states of the filter: no one else need allow for them.
[[nodiscard]] bool estimates_misalignment(const FusionOptions& options);

/// The filter [navigation.fusion] names, as one thing: corrects dead reckoning by fixes. The caller keeps the
/// position (see PlainCi).
///
/// error-state also starts from a heading alignment (navigation-fusion 1.4) once that knows the misalignment
/// to 0.5 degrees from 20 fixes or more, when its own estimate lies elsewhere: a filter that is linear about
/// small angles finds a mount that is wrong by degrees slowly, and one by 180 degrees never.
class ReckoningFilter {
 public:
  explicit ReckoningFilter(const Options& options);

  void reset(const Eigen::Matrix2d& P);
  [[nodiscard]] Eigen::Vector2d over_ground(const Eigen::Vector2d& v_measured) const;
  void predict(const Eigen::Vector2d& v_ne_mps, double dt_s);
  FixResult fix(const Eigen::Vector2d& residual, double t_s, double gamma_m, double declared_sd_m);

  /// One fix beside pure dead reckoning, accepted or not; one in 5 s is kept, since the errors of closer ones
  /// are hardly independent. The alignment, when the filter has just started anew from it.
  std::optional<HeadingAlignment> align(double t_s, const ReckonedAndFixed& pair, double gamma_m);
  /// Dead reckoning was interrupted: what was collected for the alignment is of no use.
  void forget_pairs() { pairs_.clear(); }

  /// As the filter states it now.
  [[nodiscard]] Eigen::Matrix2d P() const;
  [[nodiscard]] const DriftSinceFix& drift() const;
  /// Of the misalignment beyond the calibration; empty where it is no state.
  [[nodiscard]] std::optional<Angle> misalignment() const;

 private:
  [[nodiscard]] const ErrorState* error_state() const { return std::get_if<ErrorState>(&filter_); }

  std::variant<PlainCi, WindowedCi, ErrorState> filter_;
  bool aligned_ = false;
  std::vector<ReckonedAndFixed>
      pairs_;  // thinned by half when full: a long baseline counts, not their number
  double last_pair_s_ = 0.0, largest_gamma_m_ = 0.0;
  AlignmentWorkspace workspace_;
};

}  // namespace leadline::nav
