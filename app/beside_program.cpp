#include "app/beside_program.h"

#include <system_error>

#include "plugins/host/plugin_folders.h"

namespace leadline::app {

std::filesystem::path installed_or_beside(const std::string& place, const std::string& name) {
  std::error_code failed;
  const std::filesystem::path program = program_folder();
  const auto installed = program / ".." / place / name;
  return std::filesystem::exists(installed, failed) ? installed : program / name;
}

}  // namespace leadline::app
