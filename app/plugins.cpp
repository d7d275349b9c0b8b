#include "app/plugins.h"

#include "app/talk.h"
#include "core/decode/registry.h"

namespace leadline::app {

PluginHost load_plugins(const std::vector<std::string>& plugin_paths) {
  PluginSearch search;
  search.program = program_folder();
  search.plugin_paths.assign(plugin_paths.begin(), plugin_paths.end());
  for (const auto& decoder : decode::decoders()) search.taken_decoders.emplace_back(decoder.name);
  PluginHost host = PluginHost::load(search);
  for (const auto& refusal : host.refusals()) warning("plugin refused: " + refusal.line());
  for (const auto& plugin : host.plugins()) detail("plugin " + plugin.name + ": " + plugin.file);
  return host;
}

}  // namespace leadline::app
