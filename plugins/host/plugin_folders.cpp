#include "plugins/host/plugin_folders.h"

#include <algorithm>
#include <system_error>

namespace leadline {
namespace {

namespace fs = std::filesystem;

/// The *.so files by name; empty with `failed` set when the folder cannot be read.
std::vector<fs::path> modules_in(const fs::path& folder, std::error_code& failed) {
  std::vector<fs::path> files;
  for (fs::directory_iterator entry(folder, failed), end; !failed && entry != end; entry.increment(failed))
    if (entry->path().extension() == ".so") files.push_back(entry->path());
  std::sort(files.begin(), files.end());
  return files;
}

}  // namespace

fs::path program_folder() {
  std::error_code failed;
  return fs::read_symlink("/proc/self/exe", failed).parent_path();
}

PluginCandidates find_plugins(const PluginSearch& search) {
  PluginCandidates found;
  std::vector<fs::path> seen;
  const auto look_into = [&](const fs::path& folder, bool house) {
    std::error_code failed;
    const fs::path real = fs::canonical(folder, failed);
    std::vector<fs::path> files;
    if (!failed && std::find(seen.begin(), seen.end(), real) != seen.end()) return;
    if (!failed) files = modules_in(real, failed);
    if (failed && !house)
      found.refusals.push_back(Error{"cannot be read as a folder of plugins: " + failed.message(),
                                     folder.string(), "check --plugin-path"});
    if (failed) return;
    seen.push_back(real);
    for (auto& file : files) found.files.push_back({std::move(file), house});
  };
  look_into(search.program / "plugins", true);
  look_into(search.program / ".." / "lib" / "leadline" / "plugins", true);
  for (const auto& folder : search.plugin_paths) look_into(folder, false);
  return found;
}

}  // namespace leadline
