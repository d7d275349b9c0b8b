// Hosts the navigation core (core/nav) for the program.

#include <QObject>

#include "core/nav/engines/registry.h"
#include "core/nav/engines/ship_track.h"
#include "core/nav/plausibility/plausibility_watch.h"
#include "plugins/sdk/engine_plugin.h"

namespace leadline {
namespace {

struct NavigationTables final : EngineSettings {
  nav::FusionOptions fusion;
  nav::ImuOptions imu;

  std::vector<OptionTable> tables() override {
    return {{"fusion", bind(nav::fusion_keys(), fusion)}, {"imu", bind(nav::imu_keys(), imu)}};
  }
};

nav::Options options(const EngineSettings& settings, const NavigationSettings& common) {
  const auto& tables = static_cast<const NavigationTables&>(settings);
  nav::Options options;
  static_cast<NavigationSettings&>(options) = common;
  options.fusion = tables.fusion;
  options.imu = tables.imu;
  return options;
}

}  // namespace

class NavigationPlugin final : public QObject, public EnginePlugin {
  Q_OBJECT
  Q_PLUGIN_METADATA(IID LEADLINE_ENGINE_PLUGIN FILE "leadline_plugin.json")
  Q_INTERFACES(leadline::EnginePlugin)

 public:
  std::vector<Offer> engines() const override {
    std::vector<Offer> offers;
    for (const auto& engine : nav::engines())
      offers.push_back({std::string(engine.name), std::string(engine.help)});
    return offers;
  }

  std::unique_ptr<EngineSettings> settings() const override { return std::make_unique<NavigationTables>(); }

  Result<std::unique_ptr<Engine>> make(std::string_view name, const EngineSettings& settings,
                                       const EngineSetup& setup) const override {
    return nav::make_engine(name, {.id = setup.id,
                                   .body = setup.body,
                                   .options = options(settings, setup.common),
                                   .sources = setup.sources,
                                   .magnetic = setup.magnetic});
  }

  std::unique_ptr<Engine> make_ship_track(const EngineSettings& settings,
                                          const EngineSetup& setup) const override {
    return std::make_unique<nav::ShipTrack>(setup.sources, options(settings, setup.common), setup.magnetic);
  }

  std::unique_ptr<Engine> make_plausibility_watch(const EngineSettings& settings,
                                                  const EngineSetup& setup) const override {
    return std::make_unique<nav::PlausibilityWatch>(setup.sources, options(settings, setup.common),
                                                    setup.magnetic);
  }
};

}  // namespace leadline

#include "navigation.moc"
