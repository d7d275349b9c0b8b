#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>

#include "core/messages/measurements.h"
#include "core/sim/random.h"
#include "core/sim/sensors/view.h"
#include "core/types/option_key.h"

namespace leadline::sim {

/// Three gyros and three accelerometers; biases and scales are drawn once a run.
struct ImuOptions {
  bool increments = false;
  double gyro_bias_deg_h = 0.0, gyro_noise_deg_sqrt_h = 0.0, gyro_wander_deg_h = 0.0, gyro_wander_s = 600.0,
         gyro_scale_ppm = 0.0, gyro_quantum_rad = 0.0;
  double accel_bias_mg = 0.0, accel_noise_ug_sqrt_hz = 0.0, accel_wander_mg = 0.0, accel_wander_s = 600.0,
         accel_scale_ppm = 0.0, accel_quantum_mps = 0.0;
};
[[nodiscard]] std::span<const Key<ImuOptions>> imu_keys();

/// What ideal, ideally integrating instruments sense over an interval that ends at a sample.
struct InertialIncrement {
  double dt_s = 0.0;
  Eigen::Vector3d angle = Eigen::Vector3d::Zero(), velocity = Eigen::Vector3d::Zero();  // body axes

  /// Adds [from, to] of the step the motion has under way, by Simpson's rule.
  void cover(const Motion& motion, const Eigen::Vector3d& lever_b, double from_s, double to_s);
};

class Imu {
 public:
  Imu(const ImuOptions& options, const Eigen::Matrix3d& C_bs, Random random);
  /// dt_s above 0.
  [[nodiscard]] ImuSample measure(const InertialIncrement& truth);

 private:
  struct Triad {
    Eigen::Vector3d bias, scale, carried = Eigen::Vector3d::Zero();
    GaussMarkov wander[3];
    double noise, quantum;
  };
  [[nodiscard]] Eigen::Vector3d sense(Triad& triad, const Eigen::Vector3d& ideal, double dt_s);
  [[nodiscard]] Triad triad(double bias, double wander, double wander_s, double scale_ppm, double noise,
                            double quantum);

  ImuOptions options_;
  Eigen::Matrix3d C_bs_;
  Random random_;
  Triad gyro_, accel_;
};

}  // namespace leadline::sim
