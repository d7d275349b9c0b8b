#pragma once

#include <cstdint>
#include <cstdio>
#include <optional>

#include "sessions/store/session.h"

namespace leadline::sessions {

struct TlogFigures {
  std::uint64_t frames = 0, lines = 0;
};

/// The raw frames of a session as a timestamped log (product page, Inputs): `(<unix seconds>) <source>
/// <payload>`. One printable line with its own end is the payload as it is; anything else is # and hex
/// digits, cut to 24 KiB a line. Reading the log gives the same bytes at the same arrivals. A frame of no
/// configured source is written as of source `unknown`. run: one alone; else all that store frames.
[[nodiscard]] Result<TlogFigures> export_tlog(Session& session, std::FILE* out,
                                              std::optional<RunId> run = {});

}  // namespace leadline::sessions
