#pragma once

#include <string>
#include <vector>

#include "app/exit_status.h"

namespace leadline::app {

/// `leadline info`: what each file holds, every byte of it accounted for, without a configuration.
[[nodiscard]] Exit info(const std::vector<std::string>& files, bool json);

}  // namespace leadline::app
