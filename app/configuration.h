#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/decode/profile.h"
#include "core/decode/table.h"
#include "core/flow/navigation_options.h"
#include "core/flow/source_info.h"
#include "core/flow/source_options.h"
#include "plugins/host/plugin_host.h"

namespace leadline::app {

struct SourceConfiguration {
  SourceOptions options;
  MountOptions mount;
  decode::TableOptions table;
  decode::ProfileOptions profile;
  std::shared_ptr<SourceSettings>
      plugin;  ///< the keys of a plugin's decoder; null for a decoder of the house
};

/// One configuration file (version 1), checked.
struct Configuration {
  std::string file, text;
  std::string vehicle = "vehicle";
  NavigationSettings navigation;
  EngineTables engine_tables;  ///< [navigation.<table>] of each engine plugin
  std::vector<SourceConfiguration> sources;
  std::vector<CalibrationOptions> calibrations;
  std::vector<OutputOptions> outputs;
};

/// The configuration, or everything that is wrong with it: a line a problem, file:line: key: what is wrong.
struct LoadedConfiguration {
  Configuration configuration;
  std::vector<std::string> problems;
};
[[nodiscard]] LoadedConfiguration load_configuration(const std::string& path, const PluginHost& plugins);
/// The same of a text: the configuration a session carries. file: for its messages.
[[nodiscard]] LoadedConfiguration parse_configuration(const std::string& text, const std::string& file,
                                                      const PluginHost& plugins);

/// A complete file with every key of this build, its default and its meaning.
[[nodiscard]] std::string example_configuration(const PluginHost& plugins);

/// What the wiring needs to know of the sources, in the order of the file.
[[nodiscard]] std::vector<SourceInfo> source_infos(const Configuration& configuration);
[[nodiscard]] DecoderSettings decoder_settings(const SourceOptions& options);
/// A source's decoder, of the house or of a plugin. Error: nobody has it, or its keys make no sense.
[[nodiscard]] Result<std::unique_ptr<Decoder>> decoder_of(const SourceConfiguration& source,
                                                          const PluginHost& plugins,
                                                          const DecoderSettings& settings);

}  // namespace leadline::app
