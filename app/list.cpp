#include "app/list.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <vector>

#include "core/decode/registry.h"

namespace leadline::app {

Exit list(const std::string& what, const PluginHost& plugins, bool json) {
  struct Entry {
    std::string name, help, plugin;
  };
  std::vector<Entry> entries;
  if (what == "engines") {
    for (const auto& engine : plugins.engines()) entries.push_back({engine.name, engine.help, engine.plugin});
  } else if (what == "decoders") {
    for (const auto& decoder : decode::decoders())
      entries.push_back({std::string(decoder.name), std::string(decoder.help), ""});
    for (const auto& decoder : plugins.decoders())
      entries.push_back({decoder.name, decoder.help, decoder.plugin});
  } else {
    entries.push_back(
        {"file", "a log or one instrument's bytes: INPUT or source=INPUT of `leadline replay`", ""});
  }
  if (json) {
    nlohmann::ordered_json j = nlohmann::ordered_json::array();
    for (const auto& [name, help, plugin] : entries) {
      j.push_back({{"name", name}, {"help", help}});
      if (!plugin.empty()) j.back()["plugin"] = plugin;
    }
    fmt::print("{}\n", j.dump(2));
  } else {
    for (const auto& [name, help, plugin] : entries)
      fmt::print("{:<16} {}{}\n", name, help, plugin.empty() ? "" : " [" + plugin + "]");
  }
  return Exit::done;
}

}  // namespace leadline::app
