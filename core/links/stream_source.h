#pragma once

#include <cstdint>
#include <vector>

#include "core/flow/source.h"
#include "core/links/file_reader.h"

namespace leadline::links {

/// From this byte of a stream on, what is heard arrives at `arrival`.
struct Stamp {
  std::uint64_t offset = 0;
  Arrival arrival;
  bool operator==(const Stamp&) const = default;
};

/// The plain byte stream of one instrument with its times from outside (stream_times): bytes from a stamp's
/// offset, the first from 0, to the next one's arrive with the stamp, in pieces of at most 64 KiB. Offsets
/// grow strictly. Without stamps everything arrives at zero.
class StreamSource final : public Source {
 public:
  StreamSource(FileReader file, SourceId source, std::vector<Stamp> stamps);
  bool next(Chunk& chunk) override;
  /// Why the file ended early; empty when it did not.
  [[nodiscard]] const std::optional<Error>& failure() const { return file_.failure(); }

 private:
  FileReader file_;
  SourceId source_;
  std::vector<Stamp> stamps_;
  std::size_t current_ = 0;
};

}  // namespace leadline::links
