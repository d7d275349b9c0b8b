#pragma once

#include <string>
#include <vector>

#include "core/flow/decoder.h"
#include "plugins/host/plugin_host.h"

namespace leadline::app {

/// The plugins beside the program, installed with it, and of each --plugin-path folder. What is refused is
/// said.
[[nodiscard]] PluginHost load_plugins(const std::vector<std::string>& plugin_paths);

}  // namespace leadline::app
