#pragma once

#include <memory>
#include <string>
#include <vector>

#include "app/configuration.h"
#include "core/flow/bus.h"
#include "core/geo/magnetic.h"

namespace leadline::app {

/// A configuration made to run: the bus with a decoder for each source, the engines in the order of their
/// names, the ship's own track and the plausibility watch. Sinks are attached by whoever runs it.
struct Graph {
  std::shared_ptr<const geo::MagneticModel> magnetic;  ///< null: there is none; then see `magnetic_error`
  std::optional<Error> magnetic_error;  ///< set when a magnetic heading needs the model that is missing
  std::unique_ptr<Bus> bus;
  std::vector<std::unique_ptr<Engine>> engines;
  std::vector<std::string> engine_names;
};

/// engine_names: none given, the configured one. Error: an engine this build does not have.
[[nodiscard]] Result<Graph> make_graph(const Configuration& configuration, const PluginHost& plugins,
                                       std::vector<std::string> engine_names);

}  // namespace leadline::app
