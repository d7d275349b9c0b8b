#pragma once

#include <string>

#include "app/exit_status.h"

namespace leadline::app {

/// `leadline list engines|decoders|links`
[[nodiscard]] Exit list(const std::string& what, bool json);

}  // namespace leadline::app
