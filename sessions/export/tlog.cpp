#include "sessions/export/tlog.h"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <iterator>
#include <string>
#include <string_view>

#include "sessions/store/frames.h"

namespace leadline::sessions {
namespace {

constexpr std::size_t kMostBytes = std::size_t{24} << 10;  // a line's, below the reader's 64 KiB in hex

/// One line that a log can hold as it is: printable, with one end of line and that at its end, not taken for
/// hex digits or a blank.
bool is_line(std::string_view text) {
  if (text.size() < 2 || text.size() > kMostBytes || text.back() != '\n') return false;
  text.remove_suffix(1);
  if (!text.empty() && text.back() == '\r') text.remove_suffix(1);
  if (text.empty() || text.front() == '#' || text.front() == ' ') return false;
  return std::all_of(text.begin(), text.end(), [](char c) { return c >= ' ' && c <= '~'; });
}

void append_hex(fmt::memory_buffer& line, std::span<const std::uint8_t> bytes) {
  constexpr const char* kDigits = "0123456789abcdef";
  line.push_back('#');
  for (const std::uint8_t b : bytes) {
    line.push_back(kDigits[b >> 4]);
    line.push_back(kDigits[b & 15]);
  }
  line.push_back('\n');
}

void append_stamp(fmt::memory_buffer& line, Arrival arrival, std::string_view source) {
  std::int64_t us = arrival.ns / 1000;
  std::int64_t whole = us / 1'000'000;
  us -= whole * 1'000'000;
  if (us < 0) us += 1'000'000, --whole;
  fmt::format_to(std::back_inserter(line), "({}.{:06}) {} ", whole, us, source);
}

void append_frame(fmt::memory_buffer& out, const StoredFrame& frame, std::string_view source,
                  std::uint64_t& lines) {
  const std::string_view text(reinterpret_cast<const char*>(frame.bytes.data()), frame.bytes.size());
  if (!frame.settled.empty() && !text.empty() && text.find('\n') == text.size() - 1) {
    out.append(text);  // a line that its log refused: it will be refused again
    ++lines;
    return;
  }
  if (is_line(text)) {
    append_stamp(out, frame.arrival, source);
    out.append(text);
    ++lines;
    return;
  }
  auto rest = frame.bytes;
  do {
    const auto piece = rest.first(std::min(rest.size(), kMostBytes));
    append_stamp(out, frame.arrival, source);
    append_hex(out, piece);
    rest = rest.subspan(piece.size());
    ++lines;
  } while (!rest.empty());
}

}  // namespace

Result<TlogFigures> export_tlog(Session& session, std::FILE* out, std::optional<RunId> wanted) {
  TlogFigures figures;
  const auto runs = session.runs();
  if (!runs) return runs.error();
  fmt::memory_buffer lines;
  const auto flush = [&] {
    const bool written = std::fwrite(lines.data(), 1, lines.size(), out) == lines.size();
    lines.clear();
    return written;
  };
  const auto refused = [] {
    return Error{std::string("not all of it could be written: ") + std::strerror(errno), "",
                 "is the disk full?"};
  };
  for (const Run& run : runs.value()) {
    if (!run.stores_frames || (wanted && run.id != *wanted)) continue;
    const auto sources = session.sources(run.id);
    if (!sources) return sources.error();
    FrameReader reader(session, run.id);
    StoredFrame frame;
    for (;;) {
      const auto more = reader.next(frame);
      if (!more) return more.error();
      if (!more.value()) break;
      const bool known = frame.source < sources.value().size();
      append_frame(lines, frame, known ? sources.value()[frame.source].info.name : "unknown", figures.lines);
      ++figures.frames;
      constexpr std::size_t kFlush = std::size_t{256} << 10;
      if (lines.size() > kFlush && !flush()) return refused();
    }
  }
  if (!flush() || std::fflush(out) != 0) return refused();
  return figures;
}

}  // namespace leadline::sessions
