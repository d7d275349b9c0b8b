#include "app/magnetic_models.h"

#include <filesystem>
#include <system_error>

namespace leadline::app {

Result<geo::MagneticModel> load_magnetic_models() {
  std::error_code failed;
  const auto program = std::filesystem::read_symlink("/proc/self/exe", failed).parent_path();
  const auto installed = program / ".." / "share" / "leadline" / "magnetic";
  const bool is_installed = std::filesystem::is_directory(installed, failed);
  return geo::MagneticModel::load((is_installed ? installed : program / "magnetic").string());
}

}  // namespace leadline::app
