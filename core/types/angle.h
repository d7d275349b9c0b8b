#pragma once

#include <cmath>
#include <compare>
#include <numbers>

namespace leadline {

inline constexpr double kPi = std::numbers::pi;
inline constexpr double kRadPerDeg = kPi / 180.0;
inline constexpr double kDegPerRad = 180.0 / kPi;

/// A plane angle. Its unit is chosen when it goes in and when it comes out, never between.
class Angle {
 public:
  constexpr Angle() = default;
  [[nodiscard]] static constexpr Angle rad(double value) { return Angle(value); }
  [[nodiscard]] static constexpr Angle deg(double value) { return Angle(value * kRadPerDeg); }

  [[nodiscard]] constexpr double rad() const { return rad_; }
  [[nodiscard]] constexpr double deg() const { return rad_ * kDegPerRad; }

  /// The same direction in [0, 2 pi): headings and courses.
  [[nodiscard]] Angle wrapped_2pi() const {
    double r = std::fmod(rad_, 2.0 * kPi);
    if (r < 0.0) r += 2.0 * kPi;
    return Angle(r >= 2.0 * kPi ? 0.0 : r + 0.0);  // -1e-20 + 2 pi rounds to 2 pi; -0.0 becomes 0.0
  }
  /// The same direction in [-pi, pi): differences of headings, the short way round.
  [[nodiscard]] Angle wrapped_pi() const { return Angle((*this + rad(kPi)).wrapped_2pi().rad_ - kPi); }

  constexpr Angle operator+(Angle o) const { return Angle(rad_ + o.rad_); }
  constexpr Angle operator-(Angle o) const { return Angle(rad_ - o.rad_); }
  constexpr Angle operator-() const { return Angle(-rad_); }
  constexpr Angle operator*(double k) const { return Angle(rad_ * k); }
  constexpr auto operator<=>(const Angle&) const = default;

 private:
  constexpr explicit Angle(double r) : rad_(r) {}
  double rad_ = 0.0;
};

inline double sin(Angle a) { return std::sin(a.rad()); }
inline double cos(Angle a) { return std::cos(a.rad()); }
inline double tan(Angle a) { return std::tan(a.rad()); }

}  // namespace leadline
