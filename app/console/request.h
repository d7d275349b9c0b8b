#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/flow/engine.h"
#include "core/flow/source_info.h"
#include "core/types/result.h"

namespace leadline::app {

/// Who is who, from the configuration that a session carries or that was given.
struct ConsoleNames {
  std::string vehicle = "vehicle";
  std::string engine;              ///< the one to lead
  bool ship_is_navigated = false;  ///< all sources are the ship's
};

/// One link of a live run.
struct ConsoleLink {
  std::string address, last_error;
  std::vector<SourceId> sources;
  bool open = false;
  std::uint64_t heard_bytes = 0, heard_frames = 0, kernel_drops = 0;
};

/// A live run to be shown. Its core thread begins with start() and has ended when stop() returns.
struct ConsoleLive {
  std::vector<SourceInfo> sources;
  std::vector<std::string> decoders, engines;
  ConsoleNames names;
  std::string session;  ///< where it is recorded; empty: nowhere
  std::function<void(const std::vector<Sink*>&)> start;
  std::function<Result<void>()> stop;
  std::function<std::vector<ConsoleLink>()> links;  ///< any thread
  std::function<bool()> over;                       ///< interrupted by a signal
};

/// What the console is asked for. The console is a library of its own, loaded when it is wanted: Qt's widgets
/// and GDAL would cost every other verb a tenth of a second.
struct ConsoleRequest {
  std::string session;            ///< empty: none
  std::string screenshot;         ///< empty: a window
  std::optional<double> after_s;  ///< of session time from its start; empty: its end, live a moment
  int width = 1920, height = 1080;
  std::string palette;  ///< empty: what the operator had last
  std::vector<std::string> charts;
  std::string charts_folder;          ///< with the coast line
  const ConsoleLive* live = nullptr;  ///< instead of a session
  /// The names for a run of a session.
  std::function<Result<ConsoleNames>(const std::string& session, std::int64_t run)> names;
  std::function<void(const std::string&)> say;     ///< a line for the operator
  std::function<void(const std::string&)> detail;  ///< a line for who asked to be told everything
};

/// The entry of the library: returns the exit status.
using ConsoleEntry = int (*)(const ConsoleRequest&);
inline constexpr const char* kConsoleEntry = "leadline_console";
inline constexpr const char* kConsoleLibrary = "libleadline-console.so";

}  // namespace leadline::app
