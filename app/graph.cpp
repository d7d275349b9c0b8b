#include "app/graph.h"

#include <algorithm>

#include "app/magnetic_models.h"

namespace leadline::app {

Result<Graph> make_graph(const Configuration& configuration, const PluginHost& plugins,
                         std::vector<std::string> engine_names) {
  Graph graph;
  graph.engine_names = std::move(engine_names);
  if (graph.engine_names.empty()) graph.engine_names.push_back(configuration.navigation.navigation.engine);

  auto models = load_magnetic_models();
  const bool needed = std::any_of(
      configuration.sources.begin(), configuration.sources.end(),
      [](const auto& s) { return s.options.heading == "magnetic" && !s.options.declination_deg; });
  if (models)
    graph.magnetic = std::make_shared<const geo::MagneticModel>(std::move(models).value());
  else if (needed)
    graph.magnetic_error = models.error();

  graph.bus = std::make_unique<Bus>(source_infos(configuration));
  for (std::size_t i = 0; i < configuration.sources.size(); ++i) {
    const auto id = static_cast<SourceId>(i);
    const auto& source = configuration.sources[i];
    auto decoder = decoder_of(source, plugins, decoder_settings(source.options));
    if (!decoder) return decoder.error();
    graph.bus->attach(id, std::move(decoder).value());
  }

  EngineSetup setup;
  setup.body = configuration.navigation.navigation.body == "ship" ? Body::ship : Body::vehicle;
  setup.common = configuration.navigation;
  setup.sources = graph.bus->sources();
  for (const auto& name : graph.engine_names) {
    setup.id = static_cast<EngineId>(graph.engines.size());
    auto engine = plugins.make_engine(name, configuration.engine_tables, setup, graph.magnetic);
    if (!engine) return engine.error();
    graph.engines.push_back(std::move(engine).value());
  }
  setup.id = kShipTrack;
  auto ship = plugins.make_ship_track(configuration.engine_tables, setup, graph.magnetic);
  if (!ship) return ship.error();
  graph.engines.push_back(std::move(ship).value());
  auto plausibility = plugins.make_plausibility_watch(configuration.engine_tables, setup, graph.magnetic);
  if (!plausibility) return plausibility.error();
  graph.engines.push_back(std::move(plausibility).value());
  for (auto& engine : graph.engines) graph.bus->attach(*engine);
  return graph;
}

}  // namespace leadline::app
