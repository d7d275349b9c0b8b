#pragma once

#include <string>

#include "app/exit_status.h"
#include "plugins/host/plugin_host.h"

namespace leadline::app {

/// `leadline list engines|decoders|links`
[[nodiscard]] Exit list(const std::string& what, const PluginHost& plugins, bool json);

}  // namespace leadline::app
