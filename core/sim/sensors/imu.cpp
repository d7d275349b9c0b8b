#include "core/sim/sensors/imu.h"

#include <Eigen/Geometry>
#include <array>
#include <cmath>

#include "core/sim/truth/earth.h"

namespace leadline::sim {
namespace {

constexpr double kStandardGravity = 9.80665;  // what makers mean by g
constexpr double kRpsPerDegH = kRadPerDeg / 3600.0;
constexpr double kRadPerDegSqrtH = kRadPerDeg / 60.0;  // 1 deg/sqrt(h) as rad/sqrt(s)

/// Specific force at a place off the reference point, which turns and swings with the body.
Eigen::Vector3d specific_force(const Truth& truth, const Eigen::Vector3d& lever_b) {
  if (lever_b.isZero()) return truth.f_b;
  const Eigen::Vector3d w_in_b = truth.w_ib_b - truth.w_nb_b;
  const Eigen::Vector3d alpha = truth.alpha_nb_b - truth.w_nb_b.cross(w_in_b);
  // A metre deeper gravity is 3e-6 m/s2 stronger: in half an hour that would be metres.
  const double lat = truth.position.lat.rad(), down_m = (truth.C_nb * lever_b).z();
  const Eigen::Vector3d stronger_n =
      earth_at(lat, -truth.depth_m - down_m).g_n - earth_at(lat, -truth.depth_m).g_n;
  return truth.f_b + alpha.cross(lever_b) + truth.w_ib_b.cross(truth.w_ib_b.cross(lever_b)) -
         truth.C_nb.transpose() * stronger_n;
}

}  // namespace

void InertialIncrement::cover(const Motion& motion, const Eigen::Vector3d& lever_b, double from_s,
                              double to_s) {
  const double h = to_s - from_s;
  if (h <= 0.0) return;
  const Truth a = motion.inertial_at(from_s), m = motion.inertial_at(0.5 * (from_s + to_s)),
              b = motion.inertial_at(to_s);
  dt_s += h;
  angle += h / 6.0 * (a.w_ib_b + 4.0 * m.w_ib_b + b.w_ib_b);
  velocity +=
      h / 6.0 * (specific_force(a, lever_b) + 4.0 * specific_force(m, lever_b) + specific_force(b, lever_b));
}

Imu::Triad Imu::triad(double bias, double wander, double wander_s, double scale_ppm, double noise,
                      double quantum) {
  const auto three = [&](double sigma) {
    const double x = random_.normal(), y = random_.normal();
    return Eigen::Vector3d(x * sigma, y * sigma, random_.normal() * sigma);
  };
  const Eigen::Vector3d b = three(bias), s = three(scale_ppm * 1e-6);
  const GaussMarkov x(wander, wander_s, random_), y(wander, wander_s, random_), z(wander, wander_s, random_);
  return {b, s, Eigen::Vector3d::Zero(), {x, y, z}, noise, quantum};
}

Imu::Imu(const ImuOptions& o, const Eigen::Matrix3d& C_bs, Random random)
    : options_(o),
      C_bs_(C_bs),
      random_(random),
      gyro_(triad(o.gyro_bias_deg_h * kRpsPerDegH, o.gyro_wander_deg_h * kRpsPerDegH, o.gyro_wander_s,
                  o.gyro_scale_ppm, o.gyro_noise_deg_sqrt_h * kRadPerDegSqrtH, o.gyro_quantum_rad)),
      accel_(triad(o.accel_bias_mg * 1e-3 * kStandardGravity, o.accel_wander_mg * 1e-3 * kStandardGravity,
                   o.accel_wander_s, o.accel_scale_ppm, o.accel_noise_ug_sqrt_hz * 1e-6 * kStandardGravity,
                   o.accel_quantum_mps)) {}

/// An increment as the instrument gives it; what a whole number of quanta leaves over comes with the next.
Eigen::Vector3d Imu::sense(Triad& t, const Eigen::Vector3d& ideal, double dt_s) {
  Eigen::Vector3d increment = ideal.cwiseProduct(Eigen::Vector3d::Ones() + t.scale) + t.bias * dt_s;
  for (int i = 0; i < 3; ++i)
    increment[i] += t.wander[i].advance(dt_s, random_) * dt_s + t.noise * std::sqrt(dt_s) * random_.normal();
  if (t.quantum <= 0.0) return increment;
  const Eigen::Vector3d whole = t.carried + increment;
  Eigen::Vector3d given;
  for (int i = 0; i < 3; ++i) given[i] = std::round(whole[i] / t.quantum) * t.quantum;
  t.carried = whole - given;
  return given;
}

ImuSample Imu::measure(const InertialIncrement& truth) {
  LL_EXPECT(truth.dt_s > 0.0);
  const Eigen::Vector3d angle = sense(gyro_, C_bs_.transpose() * truth.angle, truth.dt_s);
  const Eigen::Vector3d velocity = sense(accel_, C_bs_.transpose() * truth.velocity, truth.dt_s);
  const double per = options_.increments ? 1.0 : 1.0 / truth.dt_s;
  return {options_.increments, Vec3<Instrument>::from(angle * per), Vec3<Instrument>::from(velocity * per)};
}

std::span<const Key<ImuOptions>> imu_keys() {
  using O = ImuOptions;
  static const std::array<Key<O>, 13> keys{{
      {"increments", &O::increments, "angles and velocities over each interval instead of rates"},
      {"gyro_bias_deg_h", &O::gyro_bias_deg_h, "constant, one sigma of each axis", 0, 1e6},
      {"gyro_noise_deg_sqrt_h", &O::gyro_noise_deg_sqrt_h, "angle random walk", 0, 1e4},
      {"gyro_wander_deg_h", &O::gyro_wander_deg_h, "correlated bias, one sigma", 0, 1e6},
      {"gyro_wander_s", &O::gyro_wander_s, "its time constant", 0, 1e6},
      {"gyro_scale_ppm", &O::gyro_scale_ppm, "one sigma of each axis", 0, 1e6},
      {"gyro_quantum_rad", &O::gyro_quantum_rad, "least step of an angle increment; 0: none", 0, 1},
      {"accel_bias_mg", &O::accel_bias_mg, "constant, one sigma of each axis", 0, 1e6},
      {"accel_noise_ug_sqrt_hz", &O::accel_noise_ug_sqrt_hz, "velocity random walk", 0, 1e6},
      {"accel_wander_mg", &O::accel_wander_mg, "correlated bias, one sigma", 0, 1e6},
      {"accel_wander_s", &O::accel_wander_s, "its time constant", 0, 1e6},
      {"accel_scale_ppm", &O::accel_scale_ppm, "one sigma of each axis", 0, 1e6},
      {"accel_quantum_mps", &O::accel_quantum_mps, "least step of a velocity increment; 0: none", 0, 10},
  }};
  return keys;
}

}  // namespace leadline::sim
