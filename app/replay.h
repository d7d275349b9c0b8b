#pragma once

#include <string>
#include <vector>

#include "app/exit_status.h"

namespace leadline::app {

struct ReplayOptions {
  std::vector<std::string> inputs;
  std::string config;  ///< empty: the one a session among the inputs carries
  std::vector<std::string> engines;
  std::string session;  ///< where to keep it; empty: nowhere
  bool force = false;   ///< replace a session that is there
  std::string csv;
  std::string speed = "max";
  bool progress = false;
  std::vector<std::string> plugin_paths;
};

/// `leadline replay`: logs and sessions through decoders and engines, as fast as they go or paced.
[[nodiscard]] Exit replay(const ReplayOptions& options);

}  // namespace leadline::app
