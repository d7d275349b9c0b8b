#pragma once

namespace leadline::app {

/// The program's exit status (product page).
enum class Exit : int {
  done = 0,
  failed = 1,         ///< it could not be done
  misused = 2,        ///< the command line or the configuration is wrong
  damaged = 3,        ///< done, but a frame was refused for damage or bytes were skipped
  interrupted = 130,  ///< what was done is kept
};

}  // namespace leadline::app
