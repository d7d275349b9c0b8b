#pragma once

#include <string>

#include "sessions/store/session.h"

namespace leadline::sessions {

/// What `replay --csv` wrote, or would have written, in a run of a session, byte for byte: `<engine>.csv`,
/// the fixes and ship.csv, without the summary. Error: the session is damaged, or the folder cannot be
/// written.
[[nodiscard]] Result<void> export_csv(Session& session, RunId run, const std::string& folder);

}  // namespace leadline::sessions
