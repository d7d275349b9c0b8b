#include "core/decode/line_search.h"

#include <algorithm>
#include <cstring>

namespace leadline::decode {
namespace {

bool is_terminator(char c) { return c == '\n' || c == '\r'; }

const char* find_terminator(const char* p, const char* end) { return std::find_if(p, end, is_terminator); }

}  // namespace

bool is_printable(std::string_view text) {
  return std::all_of(text.begin(), text.end(), [](char c) { return c >= 0x20 && c <= 0x7E; });
}

void LineSearch::feed(std::span<const std::uint8_t> bytes, DecoderOutput& out) {
  const char* p = reinterpret_cast<const char*>(bytes.data());
  const char* const end = p + bytes.size();
  while (p != end) p = take(p, end, out);
}

void LineSearch::finish(DecoderOutput& out) {
  if (holding_) {
    holding_ = false;
    report(0, out);
  } else if (size_ > 0) {
    close({carry_.get(), size_}, FoundLine::End::stream, out);
    report(0, out);
  }
}

/// One line, or what the chunk holds of it.
const char* LineSearch::take(const char* p, const char* end, DecoderOutput& out) {
  if (holding_) {
    holding_ = false;
    const std::size_t feed = *p == '\n' ? 1 : 0;
    report(feed, out);
    return p + feed;
  }
  const auto room = static_cast<std::ptrdiff_t>(longest_ - size_);
  const char* const last = end - p > room ? p + room : end;
  const char* stop = find_terminator(p, last);
  if (stop == last) {
    const bool overlong = last - p == room;
    if (!overlong || size_ > 0) std::memcpy(carry_.get() + size_, p, static_cast<std::size_t>(last - p));
    if (overlong) {
      const char* const text = size_ > 0 ? carry_.get() : p;
      size_ = longest_;
      close({text, longest_}, FoundLine::End::too_long, out);
      report(0, out);
      rest_ = true;
    } else {
      size_ += static_cast<std::size_t>(last - p);
    }
    return last;
  }
  const auto piece = static_cast<std::size_t>(stop - p);
  if (size_ > 0) std::memcpy(carry_.get() + size_, p, piece);
  const std::string_view text(size_ > 0 ? carry_.get() : p, size_ + piece);
  size_ = text.size();
  close(text, FoundLine::End::terminator, out);
  rest_ = false;
  if (*stop == '\n') {
    report(1, out);
  } else if (stop + 1 == end) {
    held_size_ += 1;
    holding_ = true;
  } else {
    const bool line_feed = stop[1] == '\n';
    report(line_feed ? 2 : 1, out);
    return stop + (line_feed ? 2 : 1);
  }
  return stop + 1;
}

/// Reads the open line; its report is held until its terminator is known.
void LineSearch::close(std::string_view text, FoundLine::End how, DecoderOutput& out) {
  held_ = {};
  held_size_ = text.size();
  if (rest_) {
    held_.byte_class = ByteClass::skipped;
  } else if (text.find_first_not_of(" \t") == std::string_view::npos || text.front() == '#') {
    held_.byte_class = ByteClass::comment;
  } else {
    const LineReader::Verdict verdict = reader_.read({text, how, begun_}, out);
    held_ = verdict.report;
    held_size_ -= verdict.skipped;
    begun_ += verdict.skipped;
  }
  held_.offset = begun_;
}

void LineSearch::report(std::size_t length, DecoderOutput& out) {
  held_.length = static_cast<std::uint32_t>(held_size_ + length);
  begun_ += held_.length;
  size_ = 0;
  out.frame(held_);
}

}  // namespace leadline::decode
