#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

#include "core/types/time.h"

namespace leadline::links {

/// The arrival time a log wrote before a line, and how many characters of the line it took, the blank behind
/// it included.
struct LineStamp {
  Time time;
  std::size_t length = 0;
};

/// "(1795350919.500000) ": whole seconds and 1 to 9 decimals. Empty when the line begins with anything else.
[[nodiscard]] std::optional<LineStamp> unix_stamp(std::string_view line);

/// "2014-08-01T00:00:00.186000Z ": ISO 8601 UTC with the T, up to 9 decimals, Z or none; a blank, a tab or
/// the end of the line behind it. Empty when the line begins with anything else.
[[nodiscard]] std::optional<LineStamp> iso_stamp(std::string_view line);

/// Only blanks, or '#' first.
[[nodiscard]] bool is_comment(std::string_view line);

/// How many bytes of a UTF-8 byte order mark stand at the front: 3 or 0.
[[nodiscard]] std::size_t byte_order_mark(std::string_view text);

}  // namespace leadline::links
