#include "app/list.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <utility>
#include <vector>

#include "core/decode/registry.h"
#include "core/nav/engines/registry.h"

namespace leadline::app {

Exit list(const std::string& what, bool json) {
  std::vector<std::pair<std::string_view, std::string_view>> entries;
  if (what == "engines") {
    for (const auto& engine : nav::engines()) entries.emplace_back(engine.name, engine.help);
  } else if (what == "decoders") {
    for (const auto& decoder : decode::decoders()) entries.emplace_back(decoder.name, decoder.help);
  } else {
    entries.emplace_back("file",
                         "a log or one instrument's bytes: INPUT or source=INPUT of `leadline replay`");
  }
  if (json) {
    nlohmann::ordered_json j = nlohmann::ordered_json::array();
    for (const auto& [name, help] : entries) j.push_back({{"name", name}, {"help", help}});
    fmt::print("{}\n", j.dump(2));
  } else {
    for (const auto& [name, help] : entries) fmt::print("{:<16} {}\n", name, help);
  }
  return Exit::done;
}

}  // namespace leadline::app
