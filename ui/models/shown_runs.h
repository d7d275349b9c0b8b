#pragma once

#include <optional>
#include <string>
#include <vector>

#include "sessions/store/session.h"
#include "ui/bridge/console_setup.h"

namespace leadline::ui {

/// A run as a part of what is shown.
struct ShownRun {
  sessions::Run run;
  std::uint64_t end_seq = 1;  ///< behind its newest message
  Arrival first, last;        ///< when it has messages
  [[nodiscard]] bool empty() const { return end_seq <= 1; }
};

/// The runs of a session that are shown as one timeline, oldest first; never empty.
/// named: that run alone. Otherwise the newest run that has solutions, else the newest with any message, else
/// the newest; before a recording those that it continues (same engines and sources, time going on).
/// Error: nothing was ever recorded in it, no such run, the file is damaged.
[[nodiscard]] Result<std::vector<ShownRun>> choose_runs(sessions::Session& session,
                                                        std::optional<sessions::RunId> named = {});

/// What the configuration says besides the run itself.
struct SetupNames {
  std::string vehicle = "vehicle", ship = "ship";
  Body navigated = Body::vehicle;
  std::string engine;  ///< the one to lead; where the run has none of that name its first one leads
};
/// How the console is told of a run: its engines, its sources as they were recorded, the file's name.
[[nodiscard]] ConsoleSetup setup_of(const sessions::Run& run,
                                    const std::vector<sessions::RecordedSource>& sources,
                                    const std::string& path, const SetupNames& names);

}  // namespace leadline::ui
