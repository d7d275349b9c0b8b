#pragma once

#include <filesystem>
#include <string>

#include "core/types/result.h"

class QObject;

namespace leadline {

enum class PluginKind { engine, decoder };
[[nodiscard]] constexpr const char* name_of(PluginKind kind) {
  return kind == PluginKind::engine ? "engine" : "decoder";
}

/// What a plugin's file says of itself without any of its code being run.
struct PluginMetadata {
  std::string name;
  PluginKind kind = PluginKind::engine;
  std::string sha256;  ///< of the file, lower-case hex
};
/// Error: the file is no plugin of this program's interface; says what it is instead and what to do.
[[nodiscard]] Result<PluginMetadata> read_metadata(const std::filesystem::path& file);

/// Runs the plugin's code for the first time and makes its root object, which lives until the program ends:
/// plugins are never unloaded. Every symbol is resolved now. Error: it cannot be loaded, or threw.
[[nodiscard]] Result<QObject*> load_root(const std::filesystem::path& file);

}  // namespace leadline
