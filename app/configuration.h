#pragma once

#include <string>
#include <vector>

#include "core/decode/table.h"
#include "core/flow/source_info.h"
#include "core/flow/source_options.h"
#include "core/nav/engines/options.h"

namespace leadline::app {

struct SourceConfiguration {
  SourceOptions options;
  MountOptions mount;
  decode::TableOptions table;
};

/// One configuration file (version 1), checked.
struct Configuration {
  std::string file;
  std::string vehicle = "vehicle";
  nav::Options navigation;
  std::vector<SourceConfiguration> sources;
  std::vector<CalibrationOptions> calibrations;
  std::vector<OutputOptions> outputs;
};

/// The configuration, or everything that is wrong with it: a line a problem, file:line: key: what is wrong.
struct LoadedConfiguration {
  Configuration configuration;
  std::vector<std::string> problems;
};
[[nodiscard]] LoadedConfiguration load_configuration(const std::string& path);

/// A complete file with every key of this build, its default and its meaning.
[[nodiscard]] std::string example_configuration();

/// What the wiring needs to know of the sources, in the order of the file.
[[nodiscard]] std::vector<SourceInfo> source_infos(const Configuration& configuration);
[[nodiscard]] DecoderSettings decoder_settings(const SourceOptions& options);

}  // namespace leadline::app
