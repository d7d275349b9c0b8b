#pragma once

// Inside this folder only: runs, their sources and events as rows. All throw SQLite::Exception.

#include <SQLiteCpp/SQLiteCpp.h>

#include <map>
#include <utility>
#include <vector>

#include "sessions/store/runs.h"

namespace leadline::sessions {

/// Adds a run with its configuration, engines, sources and plugins; marks those that were left open as died,
/// with an event for each gap. Returns it and the row of each source.
[[nodiscard]] std::pair<RunId, std::vector<std::int64_t>> add_run(SQLite::Database& database,
                                                                  const RunInfo& info);
void add_event(SQLite::Database& database, RunId run, const Event& event);
[[nodiscard]] std::vector<Run> runs_in(SQLite::Database& database);
[[nodiscard]] std::vector<RecordedSource> sources_in(SQLite::Database& database, RunId run);
/// Source rows of a run to their places.
[[nodiscard]] std::map<std::int64_t, SourceId> places_in(SQLite::Database& database, RunId run);
[[nodiscard]] std::vector<Event> events_in(SQLite::Database& database);

}  // namespace leadline::sessions
