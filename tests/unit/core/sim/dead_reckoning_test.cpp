// Sensors without errors carry the truth: dead reckoning over the whole deep survey comes back to it, through
// the telegrams and the decoders.

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "core/geo/geodesy.h"
#include "core/nav/engines/registry.h"
#include "tests/unit/core/sim/round_trip.h"
#include "tests/unit/core/sim/simulated.h"

namespace leadline::sim {
namespace {

/// Sums decoded DVL velocities by the trapezoid rule at the true depth; beside it the shipped engine does as
/// it does. Keeps the worst distance from the truth.
class Reckoning final : public SimulationOutput, private DecoderOutput, private EngineOutput {
 public:
  explicit Reckoning(const Scenario& scenario)
      : scenario_(scenario), decoder_(decoder_for(scenario_.sensors[0])) {
    SourceInfo info;
    info.id = 0, info.name = "dvl";
    infos_ = {info};
    Motion motion(*scenario.vehicle, Water(scenario.water), scenario.origin(), scenario.options.step_s);
    start_ = here_ = motion.at(0).position;
    nav::Options options;
    options.navigation.output_hz = 10.0;
    options.initial.lat_deg = here_.lat.deg(), options.initial.lon_deg = here_.lon.deg();
    options.initial.depth_m = motion.at(0).depth_m;
    engine_ = nav::make_engine("dead-reckoning", {.options = options, .sources = infos_}).value();
  }

  double worst_m = 0.0, engine_worst_m = 0.0, engine_allowed_m = 0.0, run_m = 0.0, time_s = 0.0;
  long pings = 0;

  void truth(Body body, Time t, const Truth& truth) override {
    if (body == Body::vehicle) true_at_ = t, truth_ = truth;
  }
  void telegram(std::size_t, Arrival arrival, std::string_view bytes, bool) override {
    arrival_ = arrival;
    decoder_->feed({reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()}, arrival, *this);
  }

 private:
  void frame(const FrameReport& report) override {
    // PD6 says one velocity in three frames, of which one is used.
    ASSERT_TRUE(report.byte_class == ByteClass::decoded || report.byte_class == ByteClass::unused);
  }
  void fact(std::optional<Time> device, const Message& message) override {
    if (const auto* heading = std::get_if<Heading>(&message)) attitude_.heading = heading->heading;
    if (const auto* tilt = std::get_if<Attitude>(&message))
      attitude_.roll = tilt->roll, attitude_.pitch = tilt->pitch;
    if (const auto* v = std::get_if<DvlVelocity>(&message)) ping(*device, *v);
    engine_->take({.valid = *device, .arrival = arrival_, .source = 0, .message = message}, *this);
  }
  void ping(Time t, const DvlVelocity& v) {
    ASSERT_TRUE(v.valid);
    const Vec3<Ned> v_n =
        Rotation<Ned, Instrument>::zyx(attitude_) * Vec3<Instrument>{v.x_mps, v.y_mps, v.z_mps};
    if (pings++ > 0) {
      const double dt = seconds(t - last_);
      here_ = geo::displaced(here_, 0.5 * dt * (v_n.x + v_last_.x), 0.5 * dt * (v_n.y + v_last_.y), -1500.0);
      run_m += std::hypot(v_n.x, v_n.y) * dt, time_s += dt;
    }
    last_ = t, v_last_ = v_n;
    if (t == true_at_) worst_m = std::max(worst_m, distance(here_));
  }
  void publish(Time t, const Message& message, SourceId) override {
    const auto* solution = std::get_if<Solution>(&message);
    if (!solution || t != true_at_) return;
    engine_worst_m = std::max(engine_worst_m, distance(solution->position));
    // It takes the newest velocity for the whole interval (Kim 2010, eq. 3): half an interval of the change
    // of velocity since the start.
    engine_allowed_m = std::max(engine_allowed_m, 0.1 * (truth_.v_n.norm() + 0.56));
  }
  [[nodiscard]] double distance(const Geodetic& p) const {
    const auto off = geo::difference(truth_.position, p, -truth_.depth_m);
    return std::hypot(off.north_m, off.east_m);
  }

  Scenario scenario_;
  std::unique_ptr<Decoder> decoder_;
  std::vector<SourceInfo> infos_;
  std::unique_ptr<Engine> engine_;
  Geodetic start_, here_;
  EulerAngles attitude_;
  Vec3<Ned> v_last_;
  Time last_, true_at_;
  Truth truth_;
  Arrival arrival_;
};

Reckoning reckon(const std::string& format, bool fine) {
  Scenario scenario = only(shipped("deep-survey"), {"dvl"});
  auto& dvl = scenario.sensors[0];
  dvl.options.format = format, dvl.options.jitter_s = 0.0;
  dvl.mount_error = {};
  dvl.errors = DvlOptions{.high_resolution = fine};
  scenario.ship.reset();
  Reckoning reckoning(scenario);
  Simulation(scenario, 1, nullptr).run(reckoning);
  EXPECT_EQ(reckoning.pings, 54001);
  return reckoning;
}

TEST(DeadReckoning, ErrorFreeTablesReturnTheTruthOverThreeHours) {
  const Reckoning r = reckon("table", false);
  std::cout << "  table: worst " << r.worst_m << " m after " << r.run_m << " m; the engine "
            << r.engine_worst_m << " m, allowed " << r.engine_allowed_m << " m (its rectangle rule)\n";
  EXPECT_LT(r.worst_m, 0.1);
  EXPECT_LT(r.engine_worst_m, r.engine_allowed_m);
}

// Half of 1 mm/s in three components and half of 0.01 deg in the angles, all the way in one direction.
void expect_within_digits(const std::string& format, const std::string& name, bool fine) {
  const Reckoning r = reckon(format, fine);
  const double digit_mps = fine ? 0.5e-5 : 0.5e-3, angle_rad = 0.005 * kRadPerDeg;
  const double bound_m = std::sqrt(3.0) * digit_mps * r.time_s + std::sqrt(3.0) * angle_rad * r.run_m;
  // Rounding is as good as random while the vehicle rolls and weaves.
  const double interval_s = 0.2, pings = static_cast<double>(r.pings);
  const double sd_m = std::sqrt(2.0 * pings) * interval_s *
                      std::hypot(digit_mps, angle_rad * r.run_m / r.time_s) / std::sqrt(3.0);
  std::cout << "  " << name << ": worst " << r.worst_m << " m, bound " << bound_m
            << " m, 1 sigma of random rounding " << sd_m << " m; the engine " << r.engine_worst_m << " m\n";
  EXPECT_LT(r.worst_m, bound_m);
  EXPECT_LT(r.worst_m, 10.0 * sd_m + 0.01);
}

TEST(DeadReckoning, Pd0StaysWithinWhatItsDigitsGive) {
  expect_within_digits("trdi-pd0", "PD0", false);
  expect_within_digits("trdi-pd0", "PD0 with 0x5803", true);
}

TEST(DeadReckoning, Pd6StaysWithinWhatItsDigitsGive) { expect_within_digits("trdi-pd6", "PD6", false); }

}  // namespace
}  // namespace leadline::sim
