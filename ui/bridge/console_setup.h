#pragma once

#include <string>
#include <vector>

#include "ui/bridge/snapshot.h"

namespace leadline::ui {

/// What the screen is told of the configuration in force. A plain value; the wiring fills it.
struct ConsoleSetup {
  std::string vehicle = "vehicle", ship = "ship";  ///< their names
  Body navigated = Body::vehicle;                  ///< whose solution the engines make
  std::vector<std::string> engines;                ///< in the order of their EngineId
  EngineId shown = 0;                              ///< the one whose solution leads
  struct Source {
    std::string name, decoder;
    Body body = Body::vehicle;
  };
  std::vector<Source> sources;  ///< in the order of their SourceId
  std::string dive, file;       ///< what it is called, where it is kept
  bool replay = false;
  bool frames_kept =
      true;  ///< RawFrames are among the messages; else an instant that gave facts counts as one

  /// "fusion"; the ship's own track is called "ship".
  [[nodiscard]] std::string engine_name(EngineId engine) const {
    if (engine < engines.size()) return engines[engine];
    return engine == kShipTrack ? "ship" : "engine " + std::to_string(engine);
  }
  [[nodiscard]] std::string source_name(SourceId source) const {
    return source < sources.size() ? sources[source].name : std::string();
  }
  /// Of whom an engine speaks.
  [[nodiscard]] Body body_of(EngineId engine) const { return engine == kShipTrack ? Body::ship : navigated; }
};

}  // namespace leadline::ui
