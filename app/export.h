#pragma once

#include <string>

#include "app/exit_status.h"

namespace leadline::app {

struct ExportOptions {
  std::string session, format, output;
  bool force = false;
};

/// `leadline export`: hands a session to other tools. tlog: its raw frames, to --output or stdout; csv: what
/// a replay's --csv holds, of its newest run with engines, into the folder --output.
[[nodiscard]] Exit export_session(const ExportOptions& options);

}  // namespace leadline::app
