#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "app/exit_status.h"

namespace leadline::app {

struct SimulateOptions {
  std::string scenario, output;
  std::optional<std::int64_t> seed;  ///< instead of the scenario's
  bool force = false;
  bool live = false;  ///< each telegram is sent over its sensor's link when its arrival stamp is due
};

/// `leadline simulate`: truth and every sensor's telegrams of a scenario into a folder: telegrams.tlog,
/// <sensor>.nmea, .pd0 or .csv (the same bytes without arrivals), truth.csv (solution columns, of the
/// scenario's body; <body>_truth.csv of the others) and the leadline.toml that replays them or listens to
/// them live. Interrupted while live, it keeps what was done.
[[nodiscard]] Exit simulate(const SimulateOptions& options);

}  // namespace leadline::app
