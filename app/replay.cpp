#include "app/replay.h"

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <fstream>

#include "app/configuration.h"
#include "app/graph.h"
#include "app/inputs.h"
#include "app/interrupt.h"
#include "app/pace.h"
#include "app/plugins.h"
#include "app/progress.h"
#include "app/recording.h"
#include "app/replay_report.h"
#include "app/talk.h"
#include "core/links/merged_source.h"
#include "sessions/export/solution_csv.h"
#include "sessions/export/summary.h"

namespace leadline::app {
namespace {

using Steady = std::chrono::steady_clock;

Exit failed(const Error& error, Exit exit = Exit::failed) {
  failure(error.line());
  return exit;
}

/// The inputs, or the exit status of what is wrong with them.
std::optional<Exit> refuse(const Inputs& inputs) {
  Exit worst = Exit::done;
  for (const auto& [exit, error] : inputs.errors) worst = std::max(worst, failed(error, exit));
  if (worst != Exit::done) return worst;
  if (inputs.open.empty()) return failed({"is empty, and there is no other input", inputs.empty.front(), ""});
  return std::nullopt;
}

/// The --config, or what a session among the inputs was recorded with.
Result<LoadedConfiguration> configuration_for(const ReplayOptions& options, const PluginHost& plugins) {
  if (!options.config.empty()) return load_configuration(options.config, plugins);
  const auto path = session_among(options.inputs);
  if (!path)
    return Error{"there is no configuration", "--config", "give one, or a session that carries its own"};
  auto session = sessions::Session::open(*path, sessions::Access::read);
  if (!session) return session.error();
  const auto text = session.value().configuration();
  if (!text) return text.error();
  return parse_configuration(text.value(), *path + " (its configuration)", plugins);
}

bool is_input(const std::string& session, const std::vector<std::string>& inputs) {
  std::error_code failed_to_ask;
  return std::any_of(inputs.begin(), inputs.end(), [&](const std::string& input) {
    return std::filesystem::equivalent(session, input, failed_to_ask);
  });
}

Result<void> write_text(const std::string& path, const std::string& text) {
  std::ofstream out(path, std::ios::binary);
  out << text;
  if (out.flush()) return {};
  return Error{"cannot be written", path, "is the disk full?"};
}

std::uint64_t size_of(const std::string& path) {
  std::error_code failed_to_ask;
  const auto size = std::filesystem::file_size(path, failed_to_ask);
  return failed_to_ask ? 0 : size;
}

}  // namespace

Exit replay(const ReplayOptions& options) {
  const auto begun = Steady::now();
  const auto speed = Pace::parse(options.speed);
  if (!speed)
    return failed({"\"" + options.speed + "\" is neither max nor a factor above 0", "--speed", ""},
                  Exit::misused);
  const PluginHost plugins = load_plugins(options.plugin_paths);
  const auto found = configuration_for(options, plugins);
  if (!found) return failed(found.error(), Exit::misused);
  const LoadedConfiguration& loaded = found.value();
  for (const auto& problem : loaded.problems) failure(problem);
  if (!loaded.problems.empty()) return Exit::misused;
  const Configuration& configuration = loaded.configuration;

  Inputs inputs = open_inputs(options.inputs, configuration, plugins);
  if (const auto exit = refuse(inputs)) return *exit;
  auto made = make_graph(configuration, plugins, options.engines);
  if (!made) return failed(made.error(), Exit::misused);
  Graph graph = std::move(made).value();
  if (graph.magnetic_error) warning(graph.magnetic_error->line());
  Bus& bus = *graph.bus;

  std::vector<bool> stamped(configuration.sources.size(), false);
  std::uint64_t total_bytes = 0;
  std::vector<std::unique_ptr<Source>> sources;
  for (auto& input : inputs.open) {
    for (const SourceId id : input.stamped_ids) stamped[id] = true;
    total_bytes += size_of(input.path);
    sources.push_back(std::move(input.source));
  }
  links::MergedSource merged(std::move(sources));

  std::unique_ptr<sessions::Recorder> recorder;
  if (!options.session.empty()) {
    auto started = start_recording({.path = options.session,
                                    .force = options.force,
                                    .into_itself = is_input(options.session, options.inputs),
                                    .engines = graph.engine_names},
                                   configuration, plugins);
    if (!started) return failed(started.error());
    recorder = std::move(started).value();
    bus.attach(*recorder);  // the first of the sinks: what was heard is its own before anybody reads it
  }
  sessions::Summary summary(graph.engine_names, options.inputs, configuration.navigation.navigation.body,
                            stamped);
  Speaker speaker(bus.sources());
  bus.attach(summary);
  bus.attach(speaker);
  std::optional<sessions::SolutionCsv> csv;
  if (!options.csv.empty()) {
    auto created = sessions::SolutionCsv::create(options.csv, graph.engine_names, bus.sources());
    if (!created) return failed(created.error());
    bus.attach(csv.emplace(std::move(created).value()));
  }

  catch_interrupts();
  {
    Progress progress(options.progress, total_bytes);
    Pace pace(*speed);
    for (Chunk chunk; !interrupted() && merged.next(chunk);) {
      pace.wait_for(chunk.arrival);
      bus.take(chunk);
      progress.add(chunk.bytes.size() + chunk.stamp_bytes);
    }
  }
  bus.finish();

  if (recorder) {
    if (const auto kept = recorder->finish(); !kept) return failed(kept.error());
  }
  const bool damaged = report_damage(bus, inputs);
  report_clocks(bus, summary);
  if (csv) {
    if (const auto closed = csv->close(); !closed) return failed(closed.error());
    const double wall_s = std::chrono::duration<double>(Steady::now() - begun).count();
    const auto written = write_text(options.csv + "/summary.json", summary.json(bus, wall_s));
    if (!written) return failed(written.error());
  }
  report_engines(graph.engine_names, summary);
  if (interrupted()) return Exit::interrupted;
  return damaged ? Exit::damaged : Exit::done;
}

}  // namespace leadline::app
