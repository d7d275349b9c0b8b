#pragma once

#include <QtPlugin>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/flow/engine.h"
#include "core/flow/navigation_options.h"
#include "core/flow/source_info.h"
#include "core/geo/magnetic.h"
#include "core/types/option_key.h"
#include "core/types/result.h"
#include "plugins/sdk/offer.h"

namespace leadline {

/// One table of the configuration below [navigation]; the keys are bound to the settings that gave them.
struct OptionTable {
  std::string path;  ///< "fusion" is [navigation.fusion]
  std::vector<BoundKey> keys;
};

/// Owns a plugin's option structs. Made at their defaults; the program fills them in from the configuration.
class EngineSettings {
 public:
  virtual ~EngineSettings() = default;
  virtual std::vector<OptionTable> tables() { return {}; }
};

/// What every engine is made from, beside its plugin's settings.
struct EngineSetup {
  EngineId id = 0;  ///< goes into everything the engine says
  Body body = Body::vehicle;
  NavigationSettings common;
  std::span<const SourceInfo> sources;           ///< SourceId is the index; outlives the engine
  const geo::MagneticModel* magnetic = nullptr;  ///< may be missing; outlives the engine
};

/// A plugin of kind "engine": the interface its root QObject implements. Every function is called from one
/// thread at a time; an exception refuses the plugin or the engine. See plugins/example_engine.
class EnginePlugin {
 public:
  virtual ~EnginePlugin() = default;
  [[nodiscard]] virtual std::vector<Offer> engines() const = 0;
  [[nodiscard]] virtual std::unique_ptr<EngineSettings> settings() const {
    return std::make_unique<EngineSettings>();
  }
  /// name: one of engines(); settings: made by settings() of this plugin. The engine is fed on a thread of
  /// its own; it must answer each message within 2 s, in finite numbers, in its own id.
  [[nodiscard]] virtual Result<std::unique_ptr<Engine>> make(std::string_view name,
                                                             const EngineSettings& settings,
                                                             const EngineSetup& setup) const = 0;
  /// The ship's own track beside the engines (EngineId kShipTrack); asked of the house plugin only.
  [[nodiscard]] virtual std::unique_ptr<Engine> make_ship_track(const EngineSettings&,
                                                                const EngineSetup&) const {
    return nullptr;
  }
  /// What names instruments that contradict each other, of every body; asked of the house plugin only.
  [[nodiscard]] virtual std::unique_ptr<Engine> make_plausibility_watch(const EngineSettings&,
                                                                        const EngineSetup&) const {
    return nullptr;
  }
};

}  // namespace leadline

#define LEADLINE_ENGINE_PLUGIN "leadline.EnginePlugin"
Q_DECLARE_INTERFACE(leadline::EnginePlugin, LEADLINE_ENGINE_PLUGIN)
