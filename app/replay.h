#pragma once

#include <string>
#include <vector>

#include "app/exit_status.h"

namespace leadline::app {

struct ReplayOptions {
  std::vector<std::string> inputs;
  std::string config;
  std::vector<std::string> engines;
  std::string csv;
  std::string speed = "max";
  bool progress = false;
};

/// `leadline replay`: logs through decoders and engines, as fast as they go or paced.
[[nodiscard]] Exit replay(const ReplayOptions& options);

}  // namespace leadline::app
