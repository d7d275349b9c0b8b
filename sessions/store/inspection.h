#pragma once

#include <string>

#include "core/types/result.h"

namespace leadline::sessions {

class Connection;

/// What this build's scripts make, as SQLite keeps it, must be what the file has, and nothing may act behind
/// our back: no trigger, no view or table of ours replaced. Tables that others added are left alone.
/// Reads only. Error: it is damaged, foreign or tampered with.
[[nodiscard]] Result<void> inspect(Connection& connection, const std::string& path);

/// The same, that a -wal beside the file is its own, and SQLite's quick_check as far as it comes in 2 s;
/// through a connection of its own that cannot write, so that what is damaged stays as it is.
[[nodiscard]] Result<void> inspect_before_writing(const std::string& path);

}  // namespace leadline::sessions
