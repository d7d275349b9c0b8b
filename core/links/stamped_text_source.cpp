#include "core/links/stamped_text_source.h"

namespace leadline::links {

std::optional<LineStamp> StampedTextSource::stamp_of(std::string_view line) const { return iso_stamp(line); }

void StampedTextSource::take_payload(std::string_view, std::string_view payload, Chunk& chunk) {
  chunk.bytes = bytes_of(payload);
}

}  // namespace leadline::links
