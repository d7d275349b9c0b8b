#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/sim/sensors/sensor_options.h"
#include "core/sim/truth/motion.h"

namespace leadline::sim {

/// [scenario]
struct ScenarioOptions {
  std::string name = "scenario", start_utc = "2026-11-22T12:00:00Z";
  double duration_s = 600.0, step_s = 0.01, truth_hz = 1.0;
  std::int64_t seed = 1;
  double lat_deg = 37.5, lon_deg = 126.0;
  std::string body = "vehicle", engine = "fusion";
  bool initial_known = true;
};
[[nodiscard]] std::span<const Key<ScenarioOptions>> scenario_keys();

/// Everything a simulation is made from; checked by whoever read it.
struct Scenario {
  ScenarioOptions options;
  WaterOptions water;
  std::optional<Route> vehicle, ship, target;
  std::vector<SensorSetup> sensors;

  [[nodiscard]] Geodetic origin() const;
  [[nodiscard]] Time start() const;
};

/// The leadline.toml that replays what a scenario's sensors say: sources by their names, nominal mounts, what
/// is known of clocks and latencies, sigmas of the aiding. at_start: the truth that `initial_known` gives.
/// links: where each sensor is heard live, by its place in the scenario; empty: nowhere.
[[nodiscard]] std::string replay_configuration(const Scenario& scenario, const Truth& at_start,
                                               std::span<const std::string> links = {});

}  // namespace leadline::sim
