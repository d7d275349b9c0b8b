#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/types/result.h"

namespace leadline::app {

/// Who is who, from the configuration that a session carries or that was given.
struct ConsoleNames {
  std::string vehicle = "vehicle";
  std::string engine;              ///< the one to lead
  bool ship_is_navigated = false;  ///< all sources are the ship's
};

/// What the console is asked for. The console is a library of its own, loaded when it is wanted: Qt's widgets
/// and GDAL would cost every other verb a tenth of a second.
struct ConsoleRequest {
  std::string session;            ///< empty: none
  std::string screenshot;         ///< empty: a window
  std::optional<double> after_s;  ///< of session time from its start; empty: its end
  int width = 1920, height = 1080;
  std::string palette;  ///< empty: what the operator had last
  std::vector<std::string> charts;
  std::string charts_folder;  ///< with the coast line
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
