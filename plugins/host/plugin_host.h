#pragma once

#include <chrono>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "plugins/host/plugin_file.h"
#include "plugins/host/plugin_folders.h"
#include "plugins/sdk/decoder_plugin.h"
#include "plugins/sdk/engine_plugin.h"

namespace leadline {

/// One plugin that was loaded; the session stores its file and hash.
struct LoadedPlugin {
  std::string name;
  PluginKind kind = PluginKind::engine;
  std::string file;    ///< absolute
  std::string sha256;  ///< of the file, lower-case hex
  bool house = false;  ///< "navigation" from the program's own folder: its engines run on the core thread
};

/// An engine or decoder and the plugin that brings it.
struct PluginOffer {
  std::string name, help, plugin;
};

/// The options of every engine plugin, at their defaults until a configuration is read into them. One a
/// configuration; a copy is the same options.
class EngineTables {
 public:
  /// The tables below [navigation], in the order of the plugins. No two have the same path.
  [[nodiscard]] std::vector<OptionTable> tables() const;

 private:
  friend class PluginHost;
  std::vector<std::shared_ptr<EngineSettings>> settings_;  // one a plugin, empty for decoders
};

/// The plugins of one run of the program. Loaded once at its start, never unloaded; const functions may be
/// called from several threads.
class PluginHost {
 public:
  /// Loads what find_plugins() names, in its order. A file that is refused is told in refusals() and the rest
  /// starts; of two with the same name (of the plugin, an engine, a decoder or a table) the first stays.
  [[nodiscard]] static PluginHost load(const PluginSearch& search);

  [[nodiscard]] const std::vector<LoadedPlugin>& plugins() const { return plugins_; }
  /// where: the file; what: why; remedy: what to do.
  [[nodiscard]] const std::vector<Error>& refusals() const { return refusals_; }
  [[nodiscard]] const std::vector<PluginOffer>& engines() const { return engines_; }
  [[nodiscard]] const std::vector<PluginOffer>& decoders() const { return decoders_; }
  [[nodiscard]] bool has_engine(std::string_view name) const;
  [[nodiscard]] bool has_decoder(std::string_view name) const;

  [[nodiscard]] EngineTables engine_tables() const;
  /// setup.magnetic is set here. setup.sources and magnetic must outlive a house engine; a third party's
  /// keeps its own copy and
  /// runs in a WatchedEngine. Error: no engine of that name, or its plugin will not make it.
  [[nodiscard]] Result<std::unique_ptr<Engine>> make_engine(
      std::string_view name, const EngineTables& tables, const EngineSetup& setup,
      std::shared_ptr<const geo::MagneticModel> magnetic,
      std::chrono::milliseconds patience = std::chrono::seconds(2)) const;
  /// The ship's own track, from the house plugin. Error: it is not here.
  [[nodiscard]] Result<std::unique_ptr<Engine>> make_ship_track(
      const EngineTables& tables, const EngineSetup& setup,
      std::shared_ptr<const geo::MagneticModel> magnetic) const;

  /// The plausibility watch, from the house plugin. Error: it is not here.
  [[nodiscard]] Result<std::unique_ptr<Engine>> make_plausibility_watch(
      const EngineTables& tables, const EngineSetup& setup,
      std::shared_ptr<const geo::MagneticModel> magnetic) const;

  /// The options a plugin's decoder adds to its [[source]]; empty: no plugin has that decoder.
  [[nodiscard]] std::shared_ptr<SourceSettings> source_settings(std::string_view decoder) const;
  /// settings: from source_settings(name). Error: no decoder of that name, or its plugin will not make it.
  [[nodiscard]] Result<std::unique_ptr<Decoder>> make_decoder(
      std::string_view name, const DecoderSettings& common,
      std::shared_ptr<const SourceSettings> settings) const;

 private:
  struct Root {  // of plugins_[i]; lives until the program ends
    EnginePlugin* engine = nullptr;
    DecoderPlugin* decoder = nullptr;
  };
  Result<void> add(const PluginCandidate& candidate, const std::vector<std::string>& taken_decoders);
  Result<void> check_free(const std::vector<Offer>& offers, const std::vector<PluginOffer>& given,
                          const std::string& file) const;
  Result<void> check_tables(const Root& root, const std::string& file) const;
  [[nodiscard]] std::size_t index_of(std::string_view plugin) const;

  std::vector<LoadedPlugin> plugins_;
  std::vector<Root> roots_;
  std::vector<PluginOffer> engines_, decoders_;
  std::vector<Error> refusals_;
};

}  // namespace leadline
