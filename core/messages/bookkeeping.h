#pragma once

// What was heard, refused and suffered: the raw bytes and the messages about messages.

#include <algorithm>
#include <cstdint>
#include <span>

#include "core/types/text.h"
#include "core/types/time.h"

namespace leadline {

/// Who sent a datagram, "ADDRESS:PORT" (IPv6 in brackets); empty where a link does not tell.
using SenderName = Text<47>;

/// Bytes exactly as they came. They live only until the Bus has handed the message to everybody; every other
/// message points to it by Envelope::raw.
struct RawFrame {
  std::span<const std::uint8_t> bytes;
  SenderName sender = {};  ///< who sent them, where the link tells
  bool operator==(const RawFrame& o) const {
    return std::ranges::equal(bytes, o.bytes) && sender == o.sender;
  }
};

/// Bytes that were not used because they were damaged, torn or out of range.
struct Rejected {
  Text<24> reason;           ///< one of decode's fixed words: "checksum", "truncated", "range", ...
  std::uint64_t offset = 0;  ///< of its first byte in the source's byte stream
  std::uint32_t length = 0;
  bool operator==(const Rejected&) const = default;
};

/// A degraded state, in words for the operator.
struct Health {
  enum class Level : std::uint8_t { note, warning };
  Level level = Level::note;
  Text<200> text;
  bool operator==(const Health&) const = default;
};

/// Something the operator must know of and act upon. Priorities as in IEC 62923-1.
struct Alarm {
  enum class Priority : std::uint8_t { caution, warning, alarm, emergency };
  Priority priority = Priority::warning;
  Text<24> reason;  ///< one of a few fixed words: "exception", "blocked", "not finite", ...
  Text<200> text;   ///< what happened to whom, and what was done
  bool operator==(const Alarm&) const = default;
};

/// Every 100 ms of arrival time; time-outs happen on these only.
struct Tick {
  Arrival at;
  bool operator==(const Tick&) const = default;
};

}  // namespace leadline
