#pragma once

#include <Eigen/Core>
#include <Eigen/LU>
#include <cmath>

#include "core/types/angle.h"
#include "core/types/vec3.h"

namespace leadline {

/// Roll (positive: starboard down), pitch (positive: bow up), heading (clockwise from true north).
struct EulerAngles {
  Angle roll, pitch, heading;
};

/// Takes vectors of frame From into frame To: v_to = R v_from.
template <class To, class From>
class Rotation {
 public:
  Rotation() : matrix_(Eigen::Matrix3d::Identity()) {}
  explicit Rotation(const Eigen::Matrix3d& matrix) : matrix_(matrix) {}

  /// Rz(heading) Ry(pitch) Rx(roll), the ZYX convention (Kim 2010 eq. 1; product page, `mount`).
  [[nodiscard]] static Rotation zyx(const EulerAngles& e) {
    const double cf = cos(e.roll), sf = sin(e.roll), ct = cos(e.pitch), st = sin(e.pitch);
    const double cp = cos(e.heading), sp = sin(e.heading);
    Eigen::Matrix3d m;
    m << cp * ct, cp * st * sf - sp * cf, sp * sf + cp * cf * st,  //
        sp * ct, cp * cf + sf * st * sp, st * sp * cf - cp * sf,   //
        -st, ct * sf, ct * cf;
    return Rotation(m);
  }

  [[nodiscard]] const Eigen::Matrix3d& matrix() const { return matrix_; }
  [[nodiscard]] Rotation<From, To> inverse() const { return Rotation<From, To>(matrix_.transpose()); }
  Vec3<To> operator*(const Vec3<From>& v) const { return Vec3<To>::from(matrix_ * v.eigen()); }
  template <class Other>
  Rotation<To, Other> operator*(const Rotation<From, Other>& o) const {
    return Rotation<To, Other>(matrix_ * o.matrix());
  }

  /// Roll in (-pi, pi], pitch in [-pi/2, pi/2], heading in [0, 2 pi); singular at pitch +-90 degrees.
  [[nodiscard]] EulerAngles euler() const {
    const auto& m = matrix_;
    return {Angle::rad(std::atan2(m(2, 1), m(2, 2))),
            Angle::rad(-std::asin(std::fmin(1.0, std::fmax(-1.0, m(2, 0))))),
            Angle::rad(std::atan2(m(1, 0), m(0, 0))).wrapped_2pi()};
  }

 private:
  Eigen::Matrix3d matrix_;
};

}  // namespace leadline
