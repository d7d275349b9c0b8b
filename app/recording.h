#pragma once

#include <memory>
#include <string>

#include "app/configuration.h"
#include "sessions/recorder/recorder.h"

namespace leadline::app {

/// What a session keeps of a run that begins now.
[[nodiscard]] sessions::RunInfo run_info(sessions::RunKind kind, const std::vector<std::string>& engines,
                                         const Configuration& configuration, const PluginHost& plugins);

/// Begins a run in a session: a new file, or one more run in the session that is being replayed into itself.
struct RecordingOptions {
  std::string path;
  bool force = false;
  sessions::RunKind kind = sessions::RunKind::replay;
  bool into_itself = false;  ///< the input is this very session: its frames are not kept twice
  std::vector<std::string> engines;
};
[[nodiscard]] Result<std::unique_ptr<sessions::Recorder>> start_recording(const RecordingOptions& options,
                                                                          const Configuration& configuration,
                                                                          const PluginHost& plugins);

}  // namespace leadline::app
