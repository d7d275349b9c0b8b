// Ideal inertial sensors, integrated by a strapdown that shares nothing with the generator but the WGS-84
// numbers, come back to the truth.

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <deque>
#include <optional>

#include "core/geo/geodesy.h"
#include "tests/unit/core/sim/simulated.h"

namespace leadline::sim {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

/// North-east-down strapdown at the IMU's own rate: midpoint rates, two-sample-free increments.
class Strapdown {
 public:
  Strapdown(const Truth& start, const Vector3d& lever_b) : lever_b_(lever_b) {
    C_ = start.C_nb;
    lat_ = start.position.lat.rad(), lon_ = start.position.lon.rad(), h_ = -start.depth_m;
    v_ = start.v_n + C_ * start.w_nb_b.cross(lever_b);
    const Vector3d lever_n = C_ * lever_b;
    const Earth e = earth(lat_, h_);
    lat_ += lever_n.x() / e.north_m, lon_ += lever_n.y() / (e.east_m * std::cos(lat_)), h_ -= lever_n.z();
  }

  void add(const Vector3d& dtheta, const Vector3d& dvel, double dt) {
    // Where the velocity will be in the middle, to first order: second order in the result.
    const Vector3d v_mid = v_ + 0.5 * step(C_, dvel, v_, lat_, h_, dt);
    const double lat_mid = lat_ + 0.5 * dt * v_.x() / earth(lat_, h_).north_m, h_mid = h_ - 0.5 * dt * v_.z();
    const Earth e = earth(lat_mid, h_mid);
    const Vector3d w_in = rate(e, v_mid, lat_mid);
    // Rotation and sculling over the interval: half of the angle, turned back half of the frame.
    const Matrix3d C_mid = turn(-0.5 * dt * w_in) * C_ * turn(0.5 * dtheta);
    const Vector3d dv = step(C_mid, dvel, v_mid, lat_mid, h_mid, dt);
    const Vector3d v_bar = v_ + 0.5 * dv;
    lat_ += dt * v_bar.x() / e.north_m;
    lon_ += dt * v_bar.y() / (e.east_m * std::cos(lat_mid));
    h_ -= dt * v_bar.z();
    v_ += dv;
    C_ = turn(-dt * w_in) * C_ * turn(dtheta);
    if (++count_ % 100 == 0) C_ = Eigen::Quaterniond(C_).normalized().toRotationMatrix();
  }

  struct Miss {
    double horizontal_m, down_m, speed_mps, angle_rad;
  };
  [[nodiscard]] Miss miss(const Truth& truth) const {
    const Vector3d lever_n = C_ * lever_b_;
    const Geodetic here =
        geo::displaced({Angle::rad(lat_), Angle::rad(lon_)}, -lever_n.x(), -lever_n.y(), h_);
    const auto off = geo::difference(truth.position, here, h_);
    const Vector3d v_here = truth.v_n + truth.C_nb * truth.w_nb_b.cross(lever_b_);
    return {std::hypot(off.north_m, off.east_m), -truth.depth_m - (h_ + lever_n.z()), (v_ - v_here).norm(),
            Eigen::AngleAxisd(C_ * truth.C_nb.transpose()).angle()};
  }

 private:
  struct Earth {
    double north_m, east_m, g, spin_n, spin_d;
  };
  static Earth earth(double lat, double h) {
    constexpr double a = 6378137.0, f = 1.0 / 298.257223563, e2 = f * (2.0 - f), w = 7.292115e-5;
    const double s = std::sin(lat), q = 1.0 - e2 * s * s;
    const double g0 = 9.7803253359 * (1.0 + 0.00193185265241 * s * s) / std::sqrt(q);
    const double g =
        g0 * (1.0 - 2.0 * h / a * (1.0 + f + 3.449786507e-3 - 2.0 * f * s * s) + 3.0 * h * h / (a * a));
    return {a * (1.0 - e2) / (q * std::sqrt(q)) + h, a / std::sqrt(q) + h, g, w * std::cos(lat), -w * s};
  }
  static Vector3d rate(const Earth& e, const Vector3d& v, double lat) {
    return {e.spin_n + v.y() / e.east_m, -v.x() / e.north_m, e.spin_d - v.y() * std::tan(lat) / e.east_m};
  }
  static Vector3d step(const Matrix3d& C, const Vector3d& dvel, const Vector3d& v, double lat, double h,
                       double dt) {
    const Earth e = earth(lat, h);
    const Vector3d spin(e.spin_n, 0.0, e.spin_d);
    return C * dvel - dt * (rate(e, v, lat) + spin).cross(v) + Vector3d(0, 0, e.g * dt);
  }
  static Matrix3d turn(const Vector3d& angle) {
    const double size = angle.norm();
    if (size == 0.0) return Matrix3d::Identity();
    return Eigen::AngleAxisd(size, angle / size).toRotationMatrix();
  }

  Vector3d lever_b_, v_;
  Matrix3d C_;
  double lat_, lon_, h_;
  long count_ = 0;
};

/// Integrates as it listens and keeps the worst miss.
struct Closure final : SimulationOutput {
  explicit Closure(const Vector3d& lever) : lever_b(lever) {}
  void truth(Body body, Time t, const Truth& truth) override {
    if (body != Body::vehicle) return;
    if (!strapdown) strapdown.emplace(truth, lever_b), last = t;
    waiting.emplace_back(t, truth);
    compare();
  }
  void measured(std::size_t, Time t, Time, const Measurement& m) override {
    const auto& sample = std::get<ImuSample>(m);
    strapdown->add(sample.gyro.eigen(), sample.accel.eigen(), seconds(t - last));
    last = t;
    compare();
  }
  void telegram(std::size_t, Arrival, std::string_view, bool) override {}

  void compare() {
    while (!waiting.empty() && waiting.front().first <= last) {
      if (waiting.front().first == last) {
        end = strapdown->miss(waiting.front().second);
        worst_m = std::max(worst_m, end.horizontal_m);
        ++compared;
      }
      waiting.pop_front();
    }
  }

  Vector3d lever_b;
  std::optional<Strapdown> strapdown;
  Time last;
  std::deque<std::pair<Time, Truth>> waiting;
  Strapdown::Miss end{};
  double worst_m = 0.0;
  int compared = 0;
};

Closure close(Scenario scenario, const MountOptions& mount, double rate_hz) {
  SensorSetup imu;
  imu.options.name = "imu", imu.options.kind = "imu", imu.options.rate_hz = rate_hz;
  imu.mount = mount;
  imu.errors = ImuOptions{.increments = true};
  scenario.sensors = {imu};
  scenario.options.truth_hz = 1.0;
  scenario.options.step_s = 0.01;
  Closure closure({mount.x_m, mount.y_m, mount.z_m});
  Simulation(scenario, 1, nullptr).run(closure);
  std::cout << "  " << scenario.options.name << ", " << scenario.options.duration_s << " s at " << rate_hz
            << " Hz: worst " << closure.worst_m << " m, end " << closure.end.horizontal_m << " m, down "
            << closure.end.down_m << " m, " << closure.end.speed_mps << " m/s, " << closure.end.angle_rad
            << " rad (" << closure.compared << " comparisons)\n";
  return closure;
}

TEST(StrapdownClosure, NorthRunClosesWithinFiveCentimetresInThirtyMinutes) {
  const Closure closure = close(shipped("north-run"), {}, 100.0);
  EXPECT_GT(closure.compared, 1790);
  EXPECT_LT(closure.worst_m, 0.05);
  EXPECT_LT(std::abs(closure.end.down_m), 0.05);
  EXPECT_LT(closure.end.speed_mps, 1e-3);
  EXPECT_LT(closure.end.angle_rad, 1e-6);
}

TEST(StrapdownClosure, TurnsCloseToo) {
  Scenario scenario = shipped("waypoint-run");
  scenario.options.duration_s = 700.0;
  const Closure closure = close(scenario, {}, 100.0);
  EXPECT_LT(closure.worst_m, 0.05);
  EXPECT_LT(closure.end.angle_rad, 1e-6);
}

// Off the reference point in a rolling, diving, heaving vehicle: angular acceleration, current, shear and the
// gravity of another depth count. Left out of each, it misses by centimetres.
TEST(StrapdownClosure, AnInstrumentOffTheReferencePointInRoughWaterCloses) {
  Scenario scenario = shipped("mine-disposal");
  scenario.options.duration_s = 150.0;
  const Closure closure = close(scenario, {.x_m = 0.8, .y_m = -0.3, .z_m = 0.4}, 100.0);
  EXPECT_LT(closure.worst_m, 0.005);
  EXPECT_LT(std::abs(closure.end.down_m), 0.002);
  EXPECT_LT(closure.end.speed_mps, 1e-4);
  EXPECT_LT(closure.end.angle_rad, 1e-7);
}

TEST(StrapdownClosure, AMountTurnsTheSampleOnly) {
  Scenario scenario = shipped("mine-disposal");
  scenario.options.duration_s = 20.0;
  std::vector<ImuSample> straight, turned;
  struct Keep final : Listener {
    explicit Keep(std::vector<ImuSample>& s) : samples(s) {}
    void measured(std::size_t, Time, Time, const Measurement& m) override {
      samples.push_back(std::get<ImuSample>(m));
    }
    std::vector<ImuSample>& samples;
  };
  for (auto* into : {&straight, &turned}) {
    SensorSetup imu;
    imu.options.name = "imu", imu.options.kind = "imu", imu.options.rate_hz = 50.0;
    imu.errors = ImuOptions{};
    if (into == &turned) imu.mount = {.roll_deg = 180.0, .yaw_deg = 30.0};
    scenario.sensors = {imu};
    Keep keep(*into);
    Simulation(scenario, 1, nullptr).run(keep);
  }
  const Matrix3d C_bs =
      Rotation<BodyFrame, Instrument>::zyx({Angle::deg(180), Angle(), Angle::deg(30)}).matrix();
  ASSERT_EQ(straight.size(), turned.size());
  for (std::size_t i = 0; i < straight.size(); ++i) {
    ASSERT_LT((C_bs * turned[i].accel.eigen() - straight[i].accel.eigen()).norm(), 1e-12);
    ASSERT_LT((C_bs * turned[i].gyro.eigen() - straight[i].gyro.eigen()).norm(), 1e-12);
  }
}

}  // namespace
}  // namespace leadline::sim
