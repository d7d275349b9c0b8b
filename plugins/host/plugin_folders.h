#pragma once

#include <filesystem>
#include <vector>

#include "core/types/result.h"

namespace leadline {

/// Where plugins may come from. Nothing else is looked at: no environment variable, no current folder.
struct PluginSearch {
  std::filesystem::path program;                    ///< the folder of the executable
  std::vector<std::filesystem::path> plugin_paths;  ///< each --plugin-path
  std::vector<std::string> taken_decoders;          ///< names of the decoders linked in
};

/// The folder of the running executable.
[[nodiscard]] std::filesystem::path program_folder();

struct PluginCandidate {
  std::filesystem::path file;  ///< absolute
  bool house = false;          ///< lies in one of the program's own folders
};
struct PluginCandidates {
  std::vector<PluginCandidate> files;
  std::vector<Error> refusals;  ///< folders of --plugin-path that cannot be read
};
/// Every *.so of `<program>/plugins`, of `<program>/../lib/leadline/plugins` and of each --plugin-path, in
/// that order, each folder's by name; a folder named twice counts once. Folders below are not entered.
[[nodiscard]] PluginCandidates find_plugins(const PluginSearch& search);

}  // namespace leadline
