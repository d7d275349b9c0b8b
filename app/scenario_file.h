#pragma once

#include <string>
#include <vector>

#include "core/sim/scenario.h"

namespace leadline::app {

/// A scenario, or everything that is wrong with it: a line a problem, file:line: key: what is wrong.
struct LoadedScenario {
  sim::Scenario scenario;
  std::vector<std::string> problems;
};
[[nodiscard]] LoadedScenario load_scenario(const std::string& path);
[[nodiscard]] LoadedScenario parse_scenario(const std::string& text, const std::string& file);

}  // namespace leadline::app
