#include "core/sim/sensors/view.h"

#include <Eigen/Geometry>

#include "core/geo/geodesy.h"

namespace leadline::sim {

View::View(const Truth& t, const Pose& pose)
    : truth(t),
      C_bs(pose.C_bs),
      C_ns(t.C_nb * pose.C_bs),
      lever_b(pose.lever_b),
      lever_n(t.C_nb * pose.lever_b),
      v_n(t.v_n + t.C_nb * t.w_nb_b.cross(pose.lever_b)),
      attitude(pose.C_bs == Eigen::Matrix3d::Identity() ? t.attitude
                                                        : Rotation<Ned, Instrument>(C_ns).euler()),
      depth_m(t.depth_m + lever_n.z()) {}

Geodetic View::position() const {
  if (lever_n.x() == 0.0 && lever_n.y() == 0.0) return truth.position;
  return geo::displaced(truth.position, lever_n.x(), lever_n.y(), -truth.depth_m);
}

EulerAngles plus(const EulerAngles& a, const Eigen::Vector3d& d) {
  return {a.roll + Angle::rad(d.x()), a.pitch + Angle::rad(d.y()),
          (a.heading + Angle::rad(d.z())).wrapped_2pi()};
}

}  // namespace leadline::sim
