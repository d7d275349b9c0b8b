#pragma once

#include <Eigen/LU>

#include "core/nav/filters/fix_gate.h"
#include "tests/unit/core/nav/simulated_survey.h"

namespace leadline::nav {

/// The simulated vehicle, a filter that sees innovations, and the position a caller would keep.
template <class Filter>
struct FilteredSurvey {
  FilteredSurvey(std::uint64_t seed, const Filter& made) : survey(seed), filter(made) {}

  std::optional<FixResult> step(bool with_fix = true,
                                const Eigen::Vector2d& false_fix = Eigen::Vector2d::Zero()) {
    survey.step();
    Eigen::Vector2d v = survey.dvl_mps();
    if constexpr (requires { filter.over_ground(v); }) v = filter.over_ground(v);
    filter.predict(v, test::SimulatedSurvey::kStep_s);
    position += v * test::SimulatedSurvey::kStep_s;
    if (!survey.fix() || !with_fix) return std::nullopt;
    const Eigen::Vector2d z =
        false_fix.isZero() ? *survey.fix() : Eigen::Vector2d(survey.truth() + false_fix);
    const FixResult result = filter.fix(z - position, survey.t_s(), test::SimulatedSurvey::kGamma_m);
    position += result.step;
    return result;
  }
  void until(double t_s) {
    while (survey.t_s() < t_s) step();
  }
  [[nodiscard]] double error_m() const { return (position - survey.truth()).norm(); }
  [[nodiscard]] double nees() const {
    const Eigen::Vector2d error = position - survey.truth();
    return error.dot(filter.P().inverse() * error);
  }

  test::SimulatedSurvey survey;
  Filter filter;
  Eigen::Vector2d position = Eigen::Vector2d::Zero();
};

/// What became of good fixes and of outliers.
struct FixCount {
  long good = 0, refused = 0, outliers = 0, accepted = 0;
  void add(const test::SimulatedSurvey& survey, const std::optional<FixResult>& result) {
    if (!result) return;
    if (survey.fix_is_outlier())
      ++outliers, accepted += result->accepted;
    else
      ++good, refused += !result->accepted;
  }
  [[nodiscard]] double good_refused() const {
    return static_cast<double>(refused) / static_cast<double>(good);
  }
  [[nodiscard]] double outliers_accepted() const {
    return static_cast<double>(accepted) / static_cast<double>(outliers);
  }
};

/// From the end of 40 minutes without fixes and with 36 m of drift until the error is below 6 m.
template <class Filter>
double recovery_s(FilteredSurvey<Filter> run, std::uint64_t seed) {
  run.until(1200.0);
  run.survey.dvl_fault_mps = 36.0 / 2400.0 * test::Pcg(seed).direction();
  while (run.survey.t_s() < 3600.0) run.step(false);
  run.survey.dvl_fault_mps.setZero();
  EXPECT_GT(run.error_m(), 15.0) << "the outage must hurt";
  while (run.error_m() >= 6.0 && run.survey.t_s() < 3600.0 + 600.0) run.step();
  return run.survey.t_s() - 3600.0;
}

/// While ten fixes in a row lie 80 m off.
template <class Filter>
double largest_error_under_false_fixes_m(FilteredSurvey<Filter> run, std::uint64_t seed) {
  run.until(1800.0);
  const Eigen::Vector2d false_fix = 80.0 * test::Pcg(seed + 100).direction();
  test::ErrorFigures errors;
  for (int fixes = 0; fixes < 10;) {
    fixes += run.step(true, false_fix).has_value();
    errors.add(run.error_m());
  }
  return errors.largest;
}

}  // namespace leadline::nav
