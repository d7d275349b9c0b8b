#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>

#include "core/types/angle.h"

namespace leadline::test {

/// PCG-XSH-RR 64/32 (O'Neill 2014) with Box-Muller: the same numbers with every library.
class Pcg {
 public:
  explicit Pcg(std::uint64_t seed) : state_(seed + kIncrement) { next(); }

  std::uint32_t next() {
    const std::uint64_t old = state_;
    state_ = old * 6364136223846793005ULL + kIncrement;
    const auto shifted = static_cast<std::uint32_t>(((old >> 18U) ^ old) >> 27U);
    const auto turn = static_cast<std::uint32_t>(old >> 59U);
    return (shifted >> turn) | (shifted << ((32U - turn) & 31U));
  }
  /// Open interval (0, 1).
  double uniform() { return (next() + 0.5) / 4294967296.0; }
  double uniform(double low, double high) { return low + (high - low) * uniform(); }
  double normal() { return std::sqrt(-2.0 * std::log(uniform())) * std::cos(2.0 * kPi * uniform()); }
  Eigen::Vector2d normal2() {
    const double first = normal();
    return {first, normal()};
  }
  Eigen::Vector2d direction() {
    const double angle = uniform(0.0, 2.0 * kPi);
    return {std::cos(angle), std::sin(angle)};
  }

 private:
  static constexpr std::uint64_t kIncrement = 1442695040888963407ULL;
  std::uint64_t state_;
};

/// Kim 2010's survey: a lawn-mower at 0.5 m/s (legs of 450 m, steps of 60 m, turns at 6 deg/s), an aligned
/// DVL at 5 Hz, a fix of gamma 5 m every 8 s, 6.65 % of them thrown up to 200 m off. North, east.
class SimulatedSurvey {
 public:
  static constexpr double kStep_s = 0.2, kGamma_m = 5.0, kFixEvery_s = 8.0;

  explicit SimulatedSurvey(std::uint64_t seed) : random_(seed) {}

  double outlier_share = 0.0665;
  Eigen::Vector2d dvl_fault_mps = Eigen::Vector2d::Zero();

  void step() {
    constexpr double kLegs_m[] = {450.0, 60.0, 450.0, 60.0};
    constexpr double kHeadings_deg[] = {0.0, 90.0, 180.0, 90.0};
    ++steps_;
    const double t = t_s();
    const double speed = 0.5 * (1.0 + 0.1 * std::sin(2.0 * kPi * t / 200.0));
    along_m_ += speed * kStep_s;
    if (along_m_ > kLegs_m[leg_ % 4]) along_m_ = 0.0, ++leg_;
    const double turn = kHeadings_deg[leg_ % 4] - heading_deg_;
    heading_deg_ += std::clamp(turn, -6.0 * kStep_s, 6.0 * kStep_s);

    const double heading = (heading_deg_ + 2.0 * std::sin(2.0 * kPi * t / 40.0)) * kRadPerDeg;
    const double sway = 0.05 * std::sin(2.0 * kPi * t / 70.0);
    const Eigen::Vector2d velocity = turned({speed, sway}, heading);
    truth_ += velocity * kStep_s;

    ahrs_wander_deg_ +=
        -ahrs_wander_deg_ * kStep_s / 1800.0 + 0.15 * std::sqrt(2.0 * kStep_s / 1800.0) * random_.normal();
    const double heading_error = (ahrs_wander_deg_ + 0.1 * random_.normal()) * kRadPerDeg;
    const Eigen::Vector2d measured =
        1.003 * Eigen::Vector2d(speed, sway) + Eigen::Vector2d(0.0005, -0.00025) + 0.010 * random_.normal2();
    dvl_mps_ = turned(measured, heading + heading_error) + dvl_fault_mps;

    fix_.reset();
    if (steps_ % std::lround(kFixEvery_s / kStep_s) != 0) return;
    fix_ = truth_ + kGamma_m / std::sqrt(2.0) * random_.normal2();
    outlier_ = random_.uniform() < outlier_share;
    if (outlier_) *fix_ = truth_ + random_.uniform(3.0 * kGamma_m, 200.0) * random_.direction();
  }

  [[nodiscard]] double t_s() const { return static_cast<double>(steps_) * kStep_s; }
  [[nodiscard]] const Eigen::Vector2d& truth() const { return truth_; }
  [[nodiscard]] const Eigen::Vector2d& dvl_mps() const { return dvl_mps_; }
  [[nodiscard]] const std::optional<Eigen::Vector2d>& fix() const { return fix_; }
  [[nodiscard]] bool fix_is_outlier() const { return outlier_; }

 private:
  static Eigen::Vector2d turned(const Eigen::Vector2d& v, double angle) {
    const double c = std::cos(angle), s = std::sin(angle);
    return {c * v.x() - s * v.y(), s * v.x() + c * v.y()};
  }

  Pcg random_;
  std::int64_t steps_ = 0;
  std::size_t leg_ = 0;
  double along_m_ = 0.0, heading_deg_ = 0.0, ahrs_wander_deg_ = 0.0;
  Eigen::Vector2d truth_ = Eigen::Vector2d::Zero(), dvl_mps_ = Eigen::Vector2d::Zero();
  std::optional<Eigen::Vector2d> fix_;
  bool outlier_ = false;
};

/// Root of the mean square, and the largest, of some errors.
struct ErrorFigures {
  double sum_of_squares = 0.0, largest = 0.0;
  long count = 0;
  void add(double error) {
    sum_of_squares += error * error;
    largest = std::max(largest, error);
    ++count;
  }
  void add(const ErrorFigures& others) {
    sum_of_squares += others.sum_of_squares;
    largest = std::max(largest, others.largest);
    count += others.count;
  }
  [[nodiscard]] double rms() const { return std::sqrt(sum_of_squares / static_cast<double>(count)); }
};

}  // namespace leadline::test
