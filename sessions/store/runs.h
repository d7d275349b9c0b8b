#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/flow/source_info.h"

namespace leadline::sessions {

/// A start of the program on a session: its place in the file, from 1.
using RunId = std::int64_t;

enum class RunKind : std::uint8_t { record, replay };

/// A source as a session keeps it.
struct RecordedSource {
  SourceInfo info;
  std::string decoder, link;
};

/// A plugin file that was loaded.
struct LoadedPlugin {
  std::string name, path, sha256;
};

/// What a run is started with.
struct RunInfo {
  RunKind kind = RunKind::record;
  Time started;                      ///< by the host's wall clock
  std::vector<std::string> engines;  ///< in the order of their EngineId
  std::string configuration_file, configuration_text;
  std::string build;                    ///< of the program
  std::vector<RecordedSource> sources;  ///< in the order of their SourceId
  std::vector<LoadedPlugin> plugins;
  /// false: the frames are this file's own, being replayed into it; they are not kept twice.
  bool store_frames = true;
};

enum class RunEnd : std::uint8_t {
  open,   ///< it is still going on, or the program died and nobody has opened the file to append since
  clean,  ///< finished
  died,   ///< the program ended without closing it
};

/// A run as it is found in a session.
struct Run {
  RunId id = 0;
  RunKind kind = RunKind::record;
  Time started;
  std::optional<Time> ended;
  RunEnd end = RunEnd::open;
  std::optional<Arrival> first, last;
  bool stores_frames = true;
  std::int64_t configuration = 0;
  std::string build;
  std::vector<std::string> engines;
};

enum class Severity : std::uint8_t { note, warning, alarm };

/// Something that happened besides the messages: a gap in the recording, an operator's note.
struct Event {
  Time at;  ///< by the host's wall clock
  std::optional<Arrival> arrival;
  Severity severity = Severity::note;
  std::string kind;  ///< "gap", "note"
  std::string text;
};

}  // namespace leadline::sessions
