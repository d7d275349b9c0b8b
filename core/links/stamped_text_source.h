#pragma once

#include "core/links/stamped_line_source.h"

namespace leadline::links {

/// One instrument's stamped text: every line an ISO 8601 UTC arrival time, a blank, the sentence. The chunk's
/// bytes are the sentence with its line terminator.
class StampedTextSource final : public StampedLineSource {
 public:
  StampedTextSource(FileReader file, SourceId source) : StampedLineSource(std::move(file), source) {}

 private:
  [[nodiscard]] std::optional<LineStamp> stamp_of(std::string_view line) const override;
  void take_payload(std::string_view line, std::string_view payload, Chunk& chunk) override;
};

}  // namespace leadline::links
