#pragma once

#include <gtest/gtest.h>

#include <functional>
#include <string>
#include <vector>

#include "app/scenario_file.h"
#include "core/sim/simulation.h"
#include "tests/support/files.h"

namespace leadline::sim {

inline const std::vector<std::string>& shipped_scenarios() {
  static const std::vector<std::string> kNames{"deep-survey",   "deep-survey-paper", "outage",
                                               "false-cluster", "hover-run",         "north-run",
                                               "waypoint-run",  "mount-calibration", "mine-disposal"};
  return kNames;
}

inline Scenario shipped(const std::string& name) {
  auto loaded = app::load_scenario(test::data_path("scenarios/" + name + ".toml"));
  for (const auto& problem : loaded.problems) ADD_FAILURE() << problem;
  return std::move(loaded.scenario);
}

/// The same scenario with one of its sensors alone, or several.
inline Scenario only(Scenario scenario, const std::vector<std::string>& names) {
  std::vector<SensorSetup> kept;
  for (const auto& name : names)
    for (const auto& sensor : scenario.sensors)
      if (sensor.options.name == name) kept.push_back(sensor);
  EXPECT_EQ(kept.size(), names.size());
  scenario.sensors = kept;
  return scenario;
}

/// Nothing of a simulation but what a test asks for.
struct Listener : SimulationOutput {
  void truth(Body, Time, const Truth&) override {}
  void telegram(std::size_t, Arrival, std::string_view, bool) override {}
};

}  // namespace leadline::sim
