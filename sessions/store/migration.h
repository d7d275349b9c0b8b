#pragma once

#include <span>
#include <string>

#include "core/types/result.h"
#include "sessions/schema/scripts.h"

namespace leadline::sessions {

/// Brings a session of an older schema up to the newest script: a copy is migrated, then takes the session's
/// name, and the original is kept, byte for byte, as `NAME.v<its number>`. Returns that name.
/// Error: it could not be done, and the session is as it was.
[[nodiscard]] Result<std::string> migrate(const std::string& path, int from,
                                          std::span<const schema::Script> scripts);

}  // namespace leadline::sessions
