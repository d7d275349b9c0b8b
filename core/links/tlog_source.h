#pragma once

#include <map>
#include <string>
#include <vector>

#include "core/links/stamped_line_source.h"

namespace leadline::links {

/// A name a log may use for a source.
struct SourceName {
  std::string name;
  SourceId id = kNoSource;
};

/// A timestamped log, one frame a line: "(<unix seconds>) <source> <payload>". The payload is the sentence as
/// text, handed on with its line terminator, or '#' and hex digits: then the chunk's bytes are the decoded
/// ones and the surplus of file bytes is in stamp_bytes. Lines of unknown sources are settled as unknown. Hex
/// that is none is refused as "hex".
class TlogSource final : public StampedLineSource {
 public:
  using Counts = std::map<std::string, std::uint64_t, std::less<>>;

  TlogSource(FileReader file, std::vector<SourceName> names);

  /// Lines by the names that are not in the list: at most 256 entries, the last for "(others)"; names are cut
  /// at 64 characters.
  [[nodiscard]] const Counts& unknown_sources() const { return unknown_sources_; }

 private:
  [[nodiscard]] std::optional<LineStamp> stamp_of(std::string_view line) const override;
  void take_payload(std::string_view line, std::string_view payload, Chunk& chunk) override;
  void take_hex(std::string_view line, std::string_view payload, Chunk& chunk);
  void count_unknown(std::string_view name);

  std::vector<SourceName> names_;
  std::vector<std::uint8_t> decoded_;
  Counts unknown_sources_;
};

}  // namespace leadline::links
