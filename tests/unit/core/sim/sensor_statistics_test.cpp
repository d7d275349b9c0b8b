// Each error model against its own keys, over 20 seeds.

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numeric>

#include "core/geo/geodesy.h"
#include "core/sim/sensors/sensor_options.h"

namespace leadline::sim {
namespace {

constexpr int kSeeds = 20;
const Geodetic kHere{Angle::deg(36.0), Angle::deg(130.0)};

/// A body that lies still, or drives straight on.
Truth still(double t_s, double heading_deg = 0.0, double depth_m = 0.0) {
  Truth truth;
  truth.t_s = t_s;
  truth.position = kHere;
  truth.depth_m = depth_m;
  truth.v_n = truth.a_n = truth.w_nb_b = truth.alpha_nb_b = Eigen::Vector3d::Zero();
  truth.attitude = {Angle(), Angle(), Angle::deg(heading_deg)};
  truth.C_nb = Rotation<Ned, BodyFrame>::zyx(truth.attitude).matrix();
  truth.seabed_m = depth_m + 40.0;
  return truth;
}

/// Mean, sigma and correlation of a series.
struct Series {
  std::vector<double> x;
  void add(double value) { x.push_back(value); }
  [[nodiscard]] double mean() const {
    return std::accumulate(x.begin(), x.end(), 0.0) / static_cast<double>(x.size());
  }
  [[nodiscard]] double rms() const {
    return std::sqrt(std::inner_product(x.begin(), x.end(), x.begin(), 0.0) / static_cast<double>(x.size()));
  }
  [[nodiscard]] double sd() const { return std::sqrt(rms() * rms() - mean() * mean()); }
};

/// Covariance at a lag over variance, from several runs of one process whose mean is 0.
double correlation(const std::vector<Series>& runs, std::size_t lag) {
  double zero = 0, at = 0;
  for (const auto& run : runs)
    for (std::size_t i = 0; i + lag < run.x.size(); ++i)
      zero += run.x[i] * run.x[i], at += run.x[i] * run.x[i + lag];
  return at / zero;
}
double rms_of(const std::vector<Series>& runs) {
  double sum = 0;
  for (const auto& run : runs) sum += run.rms() * run.rms() / static_cast<double>(runs.size());
  return std::sqrt(sum);
}

/// A model of each seed, asked `count` times every dt_s.
template <class Model, class Options>
std::vector<Series> runs_of(const Options& options, int count, double dt_s,
                            const std::function<double(Model&, double)>& ask) {
  std::vector<Series> runs;
  for (int seed = 1; seed <= kSeeds; ++seed) {
    Model model(options, Random(static_cast<std::uint64_t>(seed), "it"));
    for (Series& run = runs.emplace_back(); static_cast<int>(run.x.size()) < count;)
      run.add(ask(model, static_cast<double>(run.x.size()) * dt_s));
  }
  return runs;
}

double gnss_north(Gnss& gnss, double t_s) {
  const Truth truth = still(t_s);
  return geo::difference(kHere, gnss.measure(View(truth, {})).position).north_m;
}

TEST(SensorStatistics, GnssWhiteErrorHasItsDrmsAndGrowsWithTheHdop) {
  const auto white = runs_of<Gnss>(GnssOptions{.drms_m = 2.0}, 2000, 1.0, gnss_north);
  EXPECT_NEAR(rms_of(white), 2.0 / std::sqrt(2.0), 0.03);
  EXPECT_NEAR(correlation(white, 1), 0.0, 0.02);

  // At its crest the HDOP is half as large again.
  Series crest;
  for (int seed = 1; seed <= kSeeds * 100; ++seed) {
    Gnss gnss(GnssOptions{.drms_m = 2.0, .hdop_variation = 0.5, .hdop_period_s = 400.0},
              Random(static_cast<std::uint64_t>(seed), "it"));
    crest.add(gnss_north(gnss, 100.0));
  }
  EXPECT_NEAR(crest.rms(), 3.0 / std::sqrt(2.0), 0.1);
}

TEST(SensorStatistics, GnssCorrelatedErrorHasItsSigmaAndTimeConstant) {
  const auto runs =
      runs_of<Gnss>(GnssOptions{.correlated_drms_m = 3.0, .correlation_s = 300.0}, 20000, 10.0, gnss_north);
  EXPECT_NEAR(rms_of(runs), 3.0 / std::sqrt(2.0), 0.06);
  EXPECT_NEAR(correlation(runs, 30), std::exp(-1.0), 0.02);
}

TEST(SensorStatistics, GnssDropoutsTakeTheirShareAndLastAsLong) {
  const auto runs = runs_of<Gnss>(GnssOptions{.dropout_share = 0.1, .dropout_mean_s = 20.0}, 20000, 1.0,
                                  [](Gnss& gnss, double t_s) {
                                    const Truth truth = still(t_s);
                                    return gnss.measure(View(truth, {})).fix ? 0.0 : 1.0;
                                  });
  double lost = 0, outages = 0;
  for (const auto& run : runs)
    for (std::size_t i = 1; i < run.x.size(); ++i) lost += run.x[i], outages += run.x[i] > run.x[i - 1];
  EXPECT_NEAR(lost / (kSeeds * 20000.0), 0.1, 0.01);
  EXPECT_NEAR(lost / outages, 20.0, 1.5);
}

TEST(SensorStatistics, UsblFixesHaveTheirDrmsTheirOutliersAndTheirMisses) {
  const UsblOptions options{.drms_m = 5.0,
                            .depth_noise_m = 2.0,
                            .outlier_share = 0.0665,
                            .outlier_from_m = 15.0,
                            .outlier_to_m = 200.0,
                            .miss_share = 0.1};
  Series good, radius, depth;
  double replies = 0, asked = 0;
  for (int seed = 1; seed <= kSeeds; ++seed) {
    Usbl usbl(options, Random(static_cast<std::uint64_t>(seed), "it"));
    for (int i = 0; i < 2000; ++i, ++asked) {
      const Truth ship = still(i * 8.0, 70.0), vehicle = still(i * 8.0, 0.0, 500.0);
      const auto m = usbl.measure(View(ship, {}), vehicle);
      replies += m.reply;
      (m.outlier ? radius : good).add(m.outlier ? m.ne_m.norm() : m.ne_m.x());
      if (!m.outlier) good.add(m.ne_m.y());
      depth.add(m.depth_m - 500.0);
    }
  }
  EXPECT_NEAR(good.rms(), 5.0 / std::sqrt(2.0), 0.05);
  EXPECT_NEAR(static_cast<double>(radius.x.size()) / asked, 0.0665, 0.004);
  EXPECT_NEAR(radius.mean(), 107.5, 4.0);
  EXPECT_NEAR(radius.sd(), 185.0 / std::sqrt(12.0), 2.0);
  EXPECT_NEAR(replies / asked, 0.9, 0.006);
  EXPECT_NEAR(depth.rms(), 2.0, 0.03);
}

TEST(SensorStatistics, UsblErrorsGrowWithTheRangeAndTheShipsAttitude) {
  const auto sigma = [](const UsblOptions& options) {
    const auto runs = runs_of<Usbl>(options, 1000, 1.0, [](Usbl& usbl, double t_s) {
      const Truth ship = still(t_s), vehicle = still(t_s, 0.0, 1000.0);
      return usbl.measure(View(ship, {}), vehicle).ne_m.x();
    });
    return rms_of(runs);
  };
  EXPECT_NEAR(sigma({.range_noise_percent = 1.0}), 10.0 / std::sqrt(2.0), 0.15);
  EXPECT_NEAR(sigma({.tilt_noise_deg = 0.5}), 1000.0 * 0.5 * kRadPerDeg, 0.2);
  const auto correlated = runs_of<Usbl>(UsblOptions{.correlated_drms_m = 3.0, .correlation_s = 300.0}, 4000,
                                        30.0, [](Usbl& usbl, double t_s) {
                                          const Truth ship = still(t_s), vehicle = still(t_s, 0.0, 1000.0);
                                          return usbl.measure(View(ship, {}), vehicle).ne_m.x();
                                        });
  EXPECT_NEAR(rms_of(correlated), 3.0 / std::sqrt(2.0), 0.08);
  EXPECT_NEAR(correlation(correlated, 10), std::exp(-1.0), 0.03);
}

TEST(SensorStatistics, DvlHasItsNoiseScaleBiasAndLock) {
  const DvlOptions options{.noise_mps = 0.01,
                           .scale_percent = 0.3,
                           .bias_x_mps = 0.002,
                           .bias_y_mps = -0.001,
                           .beam_loss_share = 0.1,
                           .ping_loss_share = 0.05};
  Series x, y;
  double locks = 0, pings = 0;
  for (int seed = 1; seed <= kSeeds; ++seed) {
    Dvl dvl(options, Eigen::Matrix3d::Identity(), Random(static_cast<std::uint64_t>(seed), "it"));
    for (int i = 0; i < 2000; ++i, ++pings) {
      Truth truth = still(0.2 * i, 90.0, 20.0);
      truth.v_n = {0.0, 2.0, 0.0};
      const auto m = dvl.measure(View(truth, {}), Water({}));
      x.add(m.v_s.x()), y.add(m.v_s.y());
      locks += m.bottom;
    }
  }
  EXPECT_NEAR(x.mean(), 2.0 * 1.003 + 0.002, 2e-4);
  EXPECT_NEAR(y.mean(), -0.001, 2e-4);
  EXPECT_NEAR(x.sd(), 0.01, 2e-4);
  EXPECT_NEAR(y.sd(), 0.01, 2e-4);
  const double three_of_four = std::pow(0.9, 4) + 4 * 0.1 * std::pow(0.9, 3);
  EXPECT_NEAR(locks / pings, 0.95 * three_of_four, 0.006);
}

TEST(SensorStatistics, DvlLocksWithinItsReachOnly) {
  Dvl dvl(DvlOptions{.min_altitude_m = 1.0, .max_altitude_m = 110.0}, Eigen::Matrix3d::Identity(),
          Random(1, "it"));
  for (const double above_m : {0.5, 1.5, 60.0, 109.0, 111.0}) {
    Truth truth = still(0.0, 0.0, 20.0);
    truth.seabed_m = 20.0 + above_m;
    const auto m = dvl.measure(View(truth, {}), Water({}));
    EXPECT_EQ(m.bottom, above_m >= 1.0 && above_m <= 110.0) << above_m;
    if (m.bottom) {
      EXPECT_NEAR(m.range_m[0], above_m, 1e-9) << "level over a flat bottom";
    }
  }
}

TEST(SensorStatistics, AhrsHeadingIsWhitePlusWander) {
  const auto heading = [](Ahrs& ahrs, double t_s) {
    const Truth truth = still(t_s, 10.0);
    return (ahrs.measure(View(truth, {})).attitude.heading - Angle::deg(10.0)).wrapped_pi().deg();
  };
  const auto white = runs_of<Ahrs>(AhrsOptions{.heading_noise_deg = 0.1}, 2000, 0.1, heading);
  EXPECT_NEAR(rms_of(white), 0.1, 0.002);
  EXPECT_NEAR(correlation(white, 1), 0.0, 0.02);
  const auto wander = runs_of<Ahrs>(AhrsOptions{.heading_wander_deg = 0.45, .heading_wander_s = 1800.0},
                                    10000, 90.0, heading);
  EXPECT_NEAR(rms_of(wander), 0.45, 0.015);
  EXPECT_NEAR(correlation(wander, 20), std::exp(-1.0), 0.03);
  const auto roll = runs_of<Ahrs>(AhrsOptions{.tilt_noise_deg = 0.05}, 2000, 0.1, [](Ahrs& ahrs, double t_s) {
    const Truth truth = still(t_s);
    return ahrs.measure(View(truth, {})).attitude.roll.deg();
  });
  EXPECT_NEAR(rms_of(roll), 0.05, 0.001);
  const auto rate = runs_of<Ahrs>(AhrsOptions{.rate_noise_dps = 0.05}, 2000, 0.1, [](Ahrs& ahrs, double t_s) {
    const Truth truth = still(t_s);
    return ahrs.measure(View(truth, {})).rate_z_rps * kDegPerRad;
  });
  EXPECT_NEAR(rms_of(rate), 0.05, 0.001);
}

TEST(SensorStatistics, CompassGivesBackTheTruthWhenDeviationAndDeclinationAreAdded) {
  const CompassOptions o{.declination_deg = -7.79,
                         .deviation_a_deg = 0.5,
                         .deviation_b_deg = 3.0,
                         .deviation_c_deg = -2.0,
                         .deviation_d_deg = 1.0,
                         .deviation_e_deg = 0.4};
  Compass compass(o, nullptr, Time{}, Random(1, "it"));
  for (int heading = 0; heading < 360; heading += 15) {
    const Truth truth = still(heading, heading);
    const double h = compass.measure(View(truth, {})).heading.rad();
    const double deviation =
        0.5 + 3.0 * std::sin(h) - 2.0 * std::cos(h) + std::sin(2 * h) + 0.4 * std::cos(2 * h);
    const Angle back = Angle::rad(h) + Angle::deg(deviation - 7.79);
    EXPECT_NEAR((back - Angle::deg(heading)).wrapped_pi().deg(), 0.0, 1e-9) << heading;
  }
  Series noise;
  for (int seed = 1; seed <= kSeeds; ++seed) {
    Compass noisy(CompassOptions{.declination_deg = 0.0, .noise_deg = 0.5}, nullptr, Time{},
                  Random(static_cast<std::uint64_t>(seed), "it"));
    for (int i = 0; i < 1000; ++i) {
      const Truth truth = still(i, 90.0);
      noise.add(noisy.measure(View(truth, {})).heading.deg() - 90.0);
    }
  }
  EXPECT_NEAR(noise.rms(), 0.5, 0.01);
}

/// One axis of a gyro and an accelerometer at rest without gravity, as increments of dt.
struct Rest {
  Series gyro, accel;
};
Rest at_rest(const ImuOptions& options, std::uint64_t seed, int count, double dt_s) {
  Imu imu(options, Eigen::Matrix3d::Identity(), Random(seed, "it"));
  Rest rest;
  InertialIncrement none;
  none.dt_s = dt_s;
  for (int i = 0; i < count; ++i) {
    const ImuSample sample = imu.measure(none);
    rest.gyro.add(sample.gyro.x), rest.accel.add(sample.accel.y);
  }
  return rest;
}

/// Allan deviation of rates made of increments, at m samples.
double allan(const Series& increments, std::size_t m, double dt_s) {
  const double tau_s = static_cast<double>(m) * dt_s;
  std::vector<double> mean;
  for (std::size_t i = 0; i + m <= increments.x.size(); i += m)
    mean.push_back(std::accumulate(increments.x.begin() + static_cast<std::ptrdiff_t>(i),
                                   increments.x.begin() + static_cast<std::ptrdiff_t>(i + m), 0.0) /
                   tau_s);
  double sum = 0;
  for (std::size_t i = 1; i < mean.size(); ++i) sum += (mean[i] - mean[i - 1]) * (mean[i] - mean[i - 1]);
  return std::sqrt(0.5 * sum / static_cast<double>(mean.size() - 1));
}

TEST(SensorStatistics, ImuNoiseLiesOnTheAllanLineOfARandomWalk) {
  const ImuOptions options{
      .increments = true, .gyro_noise_deg_sqrt_h = 0.01, .accel_noise_ug_sqrt_hz = 100.0};
  const double arw = 0.01 * kRadPerDeg / 60.0, vrw = 100e-6 * 9.80665;
  for (const std::size_t m : {1u, 100u, 1000u}) {
    double gyro = 0, accel = 0;
    for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
      const Rest rest = at_rest(options, seed, 12000, 0.01);
      gyro += std::pow(allan(rest.gyro, m, 0.01), 2) / kSeeds,
          accel += std::pow(allan(rest.accel, m, 0.01), 2) / kSeeds;
    }
    const double tau_s = 0.01 * static_cast<double>(m), tolerance = m == 1000 ? 0.16 : 0.03;
    EXPECT_NEAR(std::sqrt(gyro) / (arw / std::sqrt(tau_s)), 1.0, tolerance) << tau_s;
    EXPECT_NEAR(std::sqrt(accel) / (vrw / std::sqrt(tau_s)), 1.0, tolerance) << tau_s;
  }
}

TEST(SensorStatistics, ImuWanderMakesItsAllanHump) {
  // A Gauss-Markov bias of time constant T peaks at 1.89 T with 0.437 * sqrt(2) of its sigma.
  const ImuOptions options{.increments = true, .gyro_wander_deg_h = 1.0, .gyro_wander_s = 10.0};
  double square = 0;
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed)
    square += std::pow(allan(at_rest(options, seed, 40000, 0.1).gyro, 189, 0.1), 2) / kSeeds;
  const double sigma = kRadPerDeg / 3600.0;
  EXPECT_NEAR(std::sqrt(square) / sigma, 0.618, 0.035);
}

TEST(SensorStatistics, ImuBiasesAndScalesAreDrawnOnceARun) {
  Series bias, scale, change;
  for (std::uint64_t seed = 1; seed <= 10 * kSeeds; ++seed) {
    const Rest rest =
        at_rest({.increments = true, .gyro_bias_deg_h = 0.1, .accel_bias_mg = 0.1}, seed, 10, 0.01);
    bias.add(rest.gyro.x[0] / 0.01);
    change.add(rest.gyro.x[9] - rest.gyro.x[0]);
    Imu imu(ImuOptions{.increments = true, .accel_scale_ppm = 200.0}, Eigen::Matrix3d::Identity(),
            Random(seed, "it"));
    InertialIncrement ten;
    ten.dt_s = 0.01, ten.velocity = {0.1, 0.1, 0.1};
    scale.add(imu.measure(ten).accel.z / 0.1 - 1.0);
  }
  EXPECT_NEAR(bias.rms() / (0.1 * kRadPerDeg / 3600.0), 1.0, 0.15);
  EXPECT_NEAR(bias.mean() / (0.1 * kRadPerDeg / 3600.0), 0.0, 0.22);
  EXPECT_NEAR(scale.rms(), 200e-6, 30e-6);
  EXPECT_EQ(change.rms(), 0.0);
}

TEST(SensorStatistics, ImuQuantaAreWholeAndLoseNothing) {
  constexpr double kQuantum = 1e-5;
  Imu imu(ImuOptions{.increments = true, .gyro_quantum_rad = kQuantum}, Eigen::Matrix3d::Identity(),
          Random(1, "it"));
  InertialIncrement slow;
  slow.dt_s = 0.01, slow.angle = {2.345e-6, -1.1e-6, 0.0};
  double sum = 0;
  for (int i = 1; i <= 10000; ++i) {
    const double given = imu.measure(slow).gyro.x;
    ASSERT_NEAR(given / kQuantum, std::round(given / kQuantum), 1e-9);
    sum += given;
    ASSERT_LE(std::abs(sum - i * 2.345e-6), 0.5 * kQuantum * 1.001);
  }
}

TEST(SensorStatistics, DepthAndAltitudeHaveTheirErrors) {
  const auto depth = runs_of<DepthSensor>(DepthOptions{.noise_m = 0.1, .bias_m = 0.5, .scale_percent = 1.0},
                                          2000, 1.0, [](DepthSensor& sensor, double t_s) {
                                            const Truth truth = still(t_s, 0.0, 100.0);
                                            return sensor.measure(View(truth, {})).depth_m - 101.5;
                                          });
  EXPECT_NEAR(rms_of(depth), 0.1, 0.002);
  const auto wander = runs_of<DepthSensor>(DepthOptions{.wander_m = 0.3, .wander_s = 600.0}, 10000, 60.0,
                                           [](DepthSensor& sensor, double t_s) {
                                             const Truth truth = still(t_s, 0.0, 100.0);
                                             return sensor.measure(View(truth, {})).depth_m - 100.0;
                                           });
  EXPECT_NEAR(rms_of(wander), 0.3, 0.01);
  EXPECT_NEAR(correlation(wander, 10), std::exp(-1.0), 0.03);
  double echoes = 0, asked = 0;
  Series error;
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    EchoSounder sounder(AltitudeOptions{.noise_percent = 1.0, .miss_share = 0.2}, Random(seed, "it"));
    for (int i = 0; i < 1000; ++i, ++asked) {
      const Truth truth = still(i, 0.0, 10.0);
      const auto m = sounder.measure(View(truth, {}));
      if (m.above_bottom_m) ++echoes, error.add(*m.above_bottom_m - 40.0);
    }
  }
  EXPECT_NEAR(echoes / asked, 0.8, 0.01);
  EXPECT_NEAR(error.rms(), 0.4, 0.01);
}

}  // namespace
}  // namespace leadline::sim
