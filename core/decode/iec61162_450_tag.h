#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

#include "core/types/time.h"

namespace leadline::decode::udpbc {

/// What the TAG blocks of one line say (IEC 61162-450, 7.2.3). Views lie in the line.
struct Tag {
  std::string_view source, destination;  ///< s, d: SFI, two letters and four digits
  std::optional<std::uint16_t> count;    ///< n: 0..999 of this source's lines
  struct Group {
    std::uint32_t line = 0, total = 0, id = 0;
  };
  std::optional<Group> group;       ///< g: line-total-id
  std::optional<Time> time;         ///< c: UNIX time; below 1e11 it is seconds, else milliseconds
  std::string_view text;            ///< t or i
  std::string_view relative;        ///< r
  std::string_view authentication;  ///< a: its form is not public
  struct Other {
    std::string_view key, value;
  };
  std::array<Other, 4> others;  ///< keys that are not known: the first four
  std::size_t other_count = 0;
};

/// Takes the TAG blocks, \key:value,...*hh\ each, off the front of a line. Empty: all is well. Else why not:
/// "TAG checksum", or "TAG" where one is not closed or a value is not legal.
[[nodiscard]] std::string_view take_tags(std::string_view& line, Tag& tag);

}  // namespace leadline::decode::udpbc
