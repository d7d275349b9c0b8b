#pragma once

#include <array>
#include <complex>
#include <cstdint>
#include <optional>

#include "core/nav/motion/body_attitude.h"

namespace leadline::nav {

/// One DVL's bottom track against positions of the same body: fixes at least 2 s apart of the last 64 s are
/// laid over the summed-up velocities under each of 40 readings of them (turned by 0, 90, 180, 270 deg;
/// mirrored or not; metres, feet or knots), the offset by the median, the cost by squared residuals in the
/// fixes' sigma cut off at 4 sigma, so that outliers weigh the same under every reading. The DVL is accused
/// when a reading beats every calibration (turns up to 40 deg, scales 0.7 to 1.4) by a log likelihood ratio
/// of 15, twice running or once by 20 (the sigma taken from the residuals where they are larger than stated),
/// 70 % of the fixes lie within 3.5 sigma of it, and it moved max(8 m, 4 drms), half as much again for a
/// scale. The turn and scale told are the least squares over the inliers.
class DisplacementCheck {
 public:
  using Complex = std::complex<double>;  ///< north + i east

  void velocity(Time t, Complex v, double heading_rad);
  struct Misreading {
    bool mirrored = false;  ///< and no rotation explains it
    double turn_deg = 0.0, scale = 1.0, travelled_m = 0.0;
    double heading_rad = 0.0, heading_span_rad = 0.0;  ///< as read during the window
  };
  enum class Verdict : std::uint8_t { open, well, misread };
  /// A fix of the body true at t, from a fixed origin; the misreading in found() when the verdict is one.
  Verdict fix(Time t, Complex p, double sd_axis_m);
  [[nodiscard]] const Misreading& found() const { return found_; }
  void reset();

 private:
  static constexpr std::size_t kPoints = 32;
  struct Summed {
    Complex plain, mirrored;
  };
  struct Point {
    Time t;
    Complex p, plain, mirrored;
    double sd_m, heading_rad;
  };
  struct Reading {
    bool mirrored = false;
    double turn_deg = 0.0, scale = 1.0;
    bool operator==(const Reading&) const = default;
    [[nodiscard]] Complex factor() const { return std::polar(scale, turn_deg * kRadPerDeg); }
  };
  struct Fit {
    double cost = 0.0, noise = 1.0;  ///< noise: median squared residual over its expectation
    std::size_t inliers = 0;
    double travelled_m = 0.0;
  };
  [[nodiscard]] const Point& point(std::size_t i) const { return points_[(first_ + i) % kPoints]; }
  [[nodiscard]] Fit fit(const Reading& reading, double noise) const;
  [[nodiscard]] Misreading refined(const Reading& reading, const Fit& fit) const;
  Verdict evaluate();

  std::optional<Time> last_;
  Complex v_{}, folded_{};
  double heading_rad_ = 0.0;
  Summed sum_;
  RecentValues<Summed> track_;
  std::optional<Time> kept_;
  std::array<Point, kPoints> points_{};
  std::size_t first_ = 0, count_ = 0;
  Reading last_best_;
  int times_ = 0;
  Misreading found_;
};

}  // namespace leadline::nav
