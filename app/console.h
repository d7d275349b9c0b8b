#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/exit_status.h"

namespace leadline::app {

struct ConsoleOptions {
  std::string config, session, screenshot, size = "1920x1080", palette;
  std::optional<double> after_s;
  std::vector<std::string> charts, plugin_paths;
};

/// The console's window, or its picture.
[[nodiscard]] Exit console(const ConsoleOptions& options);

}  // namespace leadline::app
