#pragma once

#include <span>
#include <string_view>

namespace leadline::sessions::schema {

/// One numbered script: takes a session of version - 1 (an empty file for the first) to version.
struct Script {
  int version;
  std::string_view sql;
};

/// All of them, from 1 to this build's.
[[nodiscard]] std::span<const Script> scripts();

}  // namespace leadline::sessions::schema
