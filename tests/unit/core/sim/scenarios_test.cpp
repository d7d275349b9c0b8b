// The scenarios that are shipped, whole: what they say is what was measured, and the same again.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/unit/core/sim/round_trip.h"
#include "tests/unit/core/sim/simulated.h"

namespace leadline::sim {
namespace {

/// All of it is in the release build's hands; here the first minutes of the long ones, faults brought
/// forward.
Scenario shortened(const std::string& name) {
  Scenario scenario = shipped(name);
  const double longest_s = 240.0;
  if (scenario.options.duration_s <= longest_s) return scenario;
  const double factor = longest_s / scenario.options.duration_s;
  scenario.options.duration_s = longest_s;
  for (auto& sensor : scenario.sensors)
    for (auto& fault : sensor.faults) {
      fault.from_s *= factor;
      if (fault.until_s) fault.until_s = *fault.until_s * factor + 2.0;
    }
  if (name == "north-run" || name == "waypoint-run") scenario.options.duration_s = 40.0;
  return scenario;
}

struct ShippedScenario : testing::TestWithParam<std::string> {};

TEST_P(ShippedScenario, IsDecodedToTheResolutionOfItsTelegrams) {
  const Scenario scenario = shortened(GetParam());
  RoundTrip trip(scenario);
  Simulation(scenario, 11, nullptr).run(trip);
  EXPECT_EQ(trip.refused, 0);
  EXPECT_EQ(trip.damaged_frames == 0, trip.refused_of_damaged == 0);
  EXPECT_GT(trip.facts, 500);
  for (const auto& sensor : scenario.sensors)
    EXPECT_TRUE(std::any_of(trip.worst.begin(), trip.worst.end(),
                            [&](const auto& w) { return w.first.rfind(sensor.options.name + " ", 0) == 0; }))
        << sensor.options.name << " was not heard";
  std::cout << "  " << trip.frames << " frames, " << trip.facts << " facts, " << trip.damaged_frames
            << " damaged\n";
}

/// FNV-1a over everything a listener is given.
struct Digest final : SimulationOutput {
  std::uint64_t hash = 14695981039346656037ULL;
  Arrival last;
  bool in_order = true;
  long frames = 0;
  void truth(Body, Time, const Truth&) override {}
  void telegram(std::size_t sensor, Arrival arrival, std::string_view bytes, bool) override {
    in_order &= arrival >= last && arrival.ns % 1000 == 0;
    last = arrival;
    ++frames;
    mix(static_cast<std::uint8_t>(sensor));
    for (int i = 0; i < 64; i += 8) mix(static_cast<std::uint8_t>(arrival.ns >> i));
    for (const char c : bytes) mix(static_cast<std::uint8_t>(c));
  }
  void mix(std::uint8_t byte) { hash = (hash ^ byte) * 1099511628211ULL; }
};

TEST_P(ShippedScenario, GivesTheSameBytesForTheSameSeedAndOthersForAnother) {
  Scenario scenario = shortened(GetParam());
  scenario.options.duration_s = std::min(scenario.options.duration_s, 30.0);
  Digest first, second, other;
  Simulation(scenario, 3, nullptr).run(first);
  Simulation(scenario, 3, nullptr).run(second);
  Simulation(scenario, 4, nullptr).run(other);
  EXPECT_EQ(first.hash, second.hash);
  EXPECT_NE(first.hash, other.hash);
  EXPECT_TRUE(first.in_order);
  EXPECT_GT(first.frames, 20);
}

INSTANTIATE_TEST_SUITE_P(All, ShippedScenario, testing::ValuesIn(shipped_scenarios()), [](const auto& one) {
  std::string name = one.param;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
});

/// The values one sensor measured.
struct Fixes final : Listener {
  std::vector<double> values;
  std::size_t wanted;
  explicit Fixes(std::size_t sensor) : wanted(sensor) {}
  void measured(std::size_t sensor, Time, Time, const Measurement& m) override {
    if (sensor == wanted) values.push_back(std::get<DvlMeasurement>(m).v_s.x());
  }
};

TEST(Simulation, ASensorMoreDoesNotMoveTheNoiseOfTheOthers) {
  Scenario scenario = shipped("deep-survey");
  scenario.options.duration_s = 60.0;
  const Scenario alone = only(scenario, {"dvl"});
  Fixes with(3), without(0);
  ASSERT_EQ(scenario.sensors[3].options.name, "dvl");
  Simulation(scenario, 1, nullptr).run(with);
  Simulation(alone, 1, nullptr).run(without);
  EXPECT_EQ(with.values, without.values);
  EXPECT_EQ(with.values.size(), 301u);
}

TEST(Simulation, ClocksLatenciesAndJitterAreHeardAsTheKeysSay) {
  Scenario scenario = only(shipped("deep-survey"), {"dvl"});
  scenario.options.duration_s = 400.0;
  auto& o = scenario.sensors[0].options;
  o.latency_s = 0.3, o.jitter_s = 0.01, o.clock_offset_s = -2.5, o.clock_drift_ppm = 100.0;
  struct Times final : Listener {
    Time measured_at, start;
    double worst_clock_s = 0, sum = 0, square = 0, least = 1e9;
    int count = 0;
    void measured(std::size_t, Time t, Time device, const Measurement&) override {
      measured_at = t;
      const double expected = -2.5 + 1e-4 * seconds(t - start);
      worst_clock_s = std::max(worst_clock_s, std::abs(seconds(device - t) - expected));
      times.push_back(t);
    }
    void telegram(std::size_t, Arrival a, std::string_view, bool) override {
      const double delay = seconds(a.host() - times[static_cast<std::size_t>(count++)]);
      sum += delay, least = std::min(least, delay), square += (delay - 0.3) * (delay - 0.3);
    }
    std::vector<Time> times;
  } times;
  times.start = scenario.start();
  Simulation(scenario, 1, nullptr).run(times);
  EXPECT_LT(times.worst_clock_s, 1e-8);
  EXPECT_GE(times.least, 0.3 - 1e-6);
  EXPECT_NEAR(std::sqrt(times.square / times.count), 0.01, 0.0006);
  EXPECT_NEAR(times.sum / times.count - 0.3, 0.01 * std::sqrt(2.0 / kPi), 0.0006);
}

}  // namespace
}  // namespace leadline::sim
