#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/exit_status.h"

namespace leadline::app {

struct RecordOptions {
  std::string config, session;
  std::optional<double> duration_s;  ///< empty: until SIGINT or SIGTERM
  std::vector<std::string> plugin_paths;
};

/// `leadline record`: links in, navigation, outputs, session stored; without a window.
[[nodiscard]] Exit record(const RecordOptions& options);

}  // namespace leadline::app
