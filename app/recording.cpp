#include "app/recording.h"

#include <chrono>

namespace leadline::app {
namespace {

/// The wall clock labels a run; nothing is computed from it.
Time wall_clock() {
  return {std::chrono::duration_cast<Duration>(std::chrono::system_clock::now().time_since_epoch()).count()};
}

const std::string kBuild = std::string("leadline ") + LEADLINE_VERSION;

}  // namespace

sessions::RunInfo run_info(sessions::RunKind kind, const std::vector<std::string>& engines,
                           const Configuration& configuration, const PluginHost& plugins) {
  sessions::RunInfo run;
  run.kind = kind;
  run.started = wall_clock();
  run.engines = engines;
  run.configuration_file = configuration.file;
  run.configuration_text = configuration.text;
  run.build = kBuild;
  const auto infos = source_infos(configuration);
  for (std::size_t i = 0; i < infos.size(); ++i)
    run.sources.push_back(
        {infos[i], configuration.sources[i].options.decoder, configuration.sources[i].options.link});
  for (const auto& plugin : plugins.plugins())
    run.plugins.push_back({plugin.name, plugin.file, plugin.sha256});
  return run;
}

Result<std::unique_ptr<sessions::Recorder>> start_recording(const RecordingOptions& options,
                                                            const Configuration& configuration,
                                                            const PluginHost& plugins) {
  auto session = options.into_itself
                     ? sessions::Session::open(options.path, sessions::Access::append)
                     : sessions::Session::create(options.path, {.force = options.force, .build = kBuild});
  if (!session) return session.error();
  auto run = run_info(options.kind, options.engines, configuration, plugins);
  run.store_frames = !options.into_itself;
  return sessions::Recorder::start(std::move(session).value(), run, {.lossless = true});
}

}  // namespace leadline::app
