#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "core/flow/decoder.h"

namespace leadline {

/// Bytes with an arrival time, as a Source hands them on.
struct Chunk {
  SourceId source = kNoSource;
  Arrival arrival;
  std::optional<Time> wall;             ///< the host's clock then, where it is not the arrival: a label
  std::span<const std::uint8_t> bytes;  ///< valid until the next call
  std::uint32_t stamp_bytes = 0;        ///< what the log wrote around them
  std::string_view sender = {};         ///< of a datagram, "ADDRESS:PORT"; valid as long as the bytes
  /// Set when the source itself settled these bytes (a comment, a line without a stamp, an unknown name):
  /// they are counted and never decoded.
  std::optional<ByteClass> settled;
  std::string_view reason;  ///< why they were refused, fixed words
};

/// Where bytes come from: a file, a port, a capture, the simulator.
class Source {
 public:
  virtual ~Source() = default;
  /// The next chunk in order of arrival; false at the end. One without bytes says that time went on until
  /// then and nothing was heard.
  virtual bool next(Chunk& chunk) = 0;
};

}  // namespace leadline
