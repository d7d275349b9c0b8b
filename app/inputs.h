#pragma once

#include <memory>
#include <string>
#include <vector>

#include "app/configuration.h"
#include "app/exit_status.h"
#include "core/flow/source.h"
#include "core/links/capture_source.h"
#include "core/links/tlog_source.h"
#include "sessions/replay/session_source.h"

namespace leadline::app {

/// Why the inputs cannot be used, and what the program's exit status is then.
struct InputError {
  Exit exit = Exit::failed;
  Error error;
};

/// One INPUT of the command line, opened.
struct OpenInput {
  std::string path;
  std::unique_ptr<Source> source;
  const links::TlogSource* tlog = nullptr;            ///< to ask for unknown names at the end
  const links::StampedLineSource* stamped = nullptr;  ///< to ask for backward stamps
  const links::CaptureSource* capture = nullptr;      ///< to ask for packets of nobody
  const sessions::SessionSource* session = nullptr;   ///< to ask how it ended
  std::vector<SourceId> stamped_ids;                  ///< sources whose arrivals come from the log
};

/// Opens every INPUT: a log, or `source=path` for one instrument's bytes. What a file is, its content tells.
/// An empty file among others is said and left out.
struct Inputs {
  std::vector<OpenInput> open;
  std::vector<std::string> empty;
  std::vector<InputError> errors;
};
[[nodiscard]] Inputs open_inputs(const std::vector<std::string>& arguments,
                                 const Configuration& configuration, const PluginHost& plugins);
/// The first of the arguments that is a session file; empty when none is.
[[nodiscard]] std::optional<std::string> session_among(const std::vector<std::string>& arguments);

}  // namespace leadline::app
