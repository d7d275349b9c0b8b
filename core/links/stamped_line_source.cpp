#include "core/links/stamped_line_source.h"

namespace leadline::links {

void StampedLineSource::settle(Chunk& chunk, std::string_view line, ByteClass byte_class,
                               std::string_view reason) {
  chunk.bytes = bytes_of(line);
  chunk.stamp_bytes = 0;
  chunk.settled = byte_class;
  chunk.reason = reason;
}

/// A refused line before the first stamp needs an arrival too: that of the first stamp, or a log with a
/// damaged first line would begin in 1970.
void StampedLineSource::find_first_stamp() {
  started_ = true;
  std::string_view line;
  for (bool continued = false; file_.line(line); continued = file_.line_goes_on()) {
    if (continued) continue;
    if (file_.offset() == line.size()) line.remove_prefix(byte_order_mark(line));
    if (const auto stamp = stamp_of(line)) {
      latest_ = arrival_at(stamp->time);
      break;
    }
  }
  file_.rewind();
}

bool StampedLineSource::next(Chunk& chunk) {
  if (!started_) find_first_stamp();
  const bool continued = file_.line_goes_on();
  std::string_view line;
  if (!file_.line(line)) return false;
  chunk = Chunk{};
  chunk.source = whose_;
  chunk.arrival = latest_;
  if (continued) return settle(chunk, line, rest_of_long_line_), true;

  ++lines_;
  const std::size_t mark = file_.offset() == line.size() ? byte_order_mark(line) : 0;
  const std::string_view text = line.substr(mark);
  rest_of_long_line_ = is_comment(text) ? ByteClass::comment : ByteClass::skipped;
  if (rest_of_long_line_ == ByteClass::comment) return settle(chunk, line, ByteClass::comment), true;

  const auto stamp = stamp_of(text);
  if (!stamp) {
    const bool torn = line.back() != '\n' && !file_.line_goes_on();
    return settle(chunk, line, ByteClass::refused, torn ? "truncated" : "stamp"), true;
  }
  chunk.arrival = arrival_at(stamp->time);
  if (chunk.arrival < latest_) ++backward_stamps_;
  latest_ = chunk.arrival;
  if (file_.line_goes_on()) return settle(chunk, line, ByteClass::refused, "too long"), true;
  chunk.stamp_bytes = static_cast<std::uint32_t>(mark + stamp->length);
  take_payload(line, text.substr(stamp->length), chunk);
  return true;
}

}  // namespace leadline::links
