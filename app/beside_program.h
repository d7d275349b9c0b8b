#pragma once

#include <filesystem>
#include <string>

namespace leadline::app {

/// Where a part of this program lies: PREFIX/<place>/<name> when installed, otherwise <name> beside the
/// program in its build folder.
[[nodiscard]] std::filesystem::path installed_or_beside(const std::string& place, const std::string& name);

}  // namespace leadline::app
