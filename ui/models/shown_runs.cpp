#include "ui/models/shown_runs.h"

#include <algorithm>
#include <filesystem>
#include <utility>

namespace leadline::ui {
namespace {

using sessions::Run;
using sessions::RunKind;
using sessions::Session;

Result<ShownRun> measure(Session& session, const Run& run) {
  ShownRun shown{run, 1, {}, {}};
  sessions::Reading heads;
  heads.whole.reset();
  heads.heads.set();
  bool any = false;
  auto read = session.read_between(run.id, heads, [&](const Envelope& e) {
    shown.first = shown.last = e.arrival;
    any = true;
    return false;
  });
  if (!read) return read.error();
  for (std::size_t kind = 0; any && kind < heads.heads.size(); ++kind) {
    const auto last = session.read_last(run.id, kind, UINT64_MAX, 1);
    if (!last) return last.error();
    if (last.value().empty() || last.value().front().seq < shown.end_seq) continue;
    shown.end_seq = last.value().front().seq + 1;
    shown.last = std::max(shown.last, last.value().front().arrival);
  }
  if (!any) shown.first = shown.last = run.first.value_or(Arrival{run.started.ns});
  return shown;
}

Result<std::vector<std::string>> source_names(Session& session, const Run& run) {
  const auto sources = session.sources(run.id);
  if (!sources) return sources.error();
  std::vector<std::string> names;
  for (const auto& source : sources.value()) names.push_back(source.info.name);
  return names;
}

/// What the last of `chosen` continues.
Result<void> add_continued(Session& session, const std::vector<Run>& runs, std::vector<ShownRun>& chosen) {
  const auto names = source_names(session, chosen.front().run);
  if (!names) return names.error();
  for (auto earlier = runs.rbegin(); earlier != runs.rend(); ++earlier) {
    if (earlier->id >= chosen.front().run.id || earlier->kind != RunKind::record) continue;
    if (earlier->engines != chosen.front().run.engines || !earlier->stores_frames) return {};
    const auto its_names = source_names(session, *earlier);
    if (!its_names) return its_names.error();
    if (its_names.value() != names.value()) return {};
    auto measured = measure(session, *earlier);
    if (!measured) return measured.error();
    if (measured.value().empty()) continue;
    if (measured.value().last > chosen.front().first) return {};
    chosen.insert(chosen.begin(), std::move(measured).value());
  }
  return {};
}

}  // namespace

Result<std::vector<ShownRun>> choose_runs(Session& session, std::optional<sessions::RunId> named) {
  const auto found = session.runs();
  if (!found) return found.error();
  const auto& runs = found.value();
  if (runs.empty())
    return Error{"nothing was ever recorded in it", session.path(), "name a session that something is in"};
  std::optional<Run> chosen;
  std::optional<Run> filled;
  for (auto run = runs.rbegin(); run != runs.rend() && !chosen; ++run) {
    if (named) {
      if (run->id == *named) chosen = *run;
      continue;
    }
    const auto solution = session.last_before<Solution>(run->id, UINT64_MAX);
    if (!solution) return solution.error();
    if (solution.value()) chosen = *run;
    if (chosen || filled) continue;
    const auto measured = measure(session, *run);
    if (!measured) return measured.error();
    if (!measured.value().empty()) filled = *run;
  }
  if (named && !chosen)
    return Error{"has no run " + std::to_string(*named), session.path(),
                 "its runs are 1 to " + std::to_string(runs.back().id)};
  if (!chosen) chosen = filled ? filled : std::optional(runs.back());
  auto measured = measure(session, *chosen);
  if (!measured) return measured.error();
  std::vector<ShownRun> shown{std::move(measured).value()};
  if (!named && chosen->kind == RunKind::record)
    if (auto added = add_continued(session, runs, shown); !added) return added.error();
  return shown;
}

ConsoleSetup setup_of(const Run& run, const std::vector<sessions::RecordedSource>& sources,
                      const std::string& path, const SetupNames& names) {
  ConsoleSetup setup;
  setup.vehicle = names.vehicle, setup.ship = names.ship, setup.navigated = names.navigated;
  setup.engines = run.engines;
  const auto shown = std::find(run.engines.begin(), run.engines.end(), names.engine);
  if (shown != run.engines.end()) setup.shown = static_cast<EngineId>(shown - run.engines.begin());
  for (const auto& source : sources) {
    const Body body = source.info.body == leadline::Body::ship     ? Body::ship
                      : source.info.body == leadline::Body::target ? Body::target
                                                                   : Body::vehicle;
    setup.sources.push_back({source.info.name, source.decoder, body});
  }
  const std::filesystem::path file(path);
  setup.dive = file.stem().string(), setup.file = file.filename().string();
  setup.replay = true;
  setup.frames_kept = run.stores_frames;
  return setup;
}

}  // namespace leadline::ui
