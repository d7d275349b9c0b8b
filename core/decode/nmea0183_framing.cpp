#include "core/decode/nmea0183_framing.h"

#include <algorithm>
#include <cstring>

#include "core/decode/nmea0183_words.h"

namespace leadline::decode::nmea0183 {
namespace {

/// Comments and rubbish are told in pieces of this size at most, so that an endless line is told too.
constexpr std::uint64_t kLongestPiece = std::uint64_t{1} << 20;

constexpr bool is_terminator(char c) { return c == '\n' || c == '\r'; }
constexpr bool is_start(char c) { return c == '$' || c == '!'; }

/// The first byte that ends a line or begins a sentence, else end.
const char* find_stop(const char* p, const char* end) {
  for (; end - p >= 8; p += 8) {
    const std::uint64_t w = load_word(p);
    if ((bytes_below(w, 0x20) | bytes_equal(w, '$') | bytes_equal(w, '!')) == 0) continue;
    const std::uint64_t stops =
        each_equal(w, '\n') | each_equal(w, '\r') | each_equal(w, '$') | each_equal(w, '!');
    if (stops != 0) return p + first_byte(stops);
  }
  while (p != end && !is_terminator(*p) && !is_start(*p)) ++p;
  return p;
}

Line::Shape shape_of(char first) {
  return is_start(first) ? Line::Shape::sentence : first == '#' ? Line::Shape::comment : Line::Shape::text;
}

}  // namespace

void Framing::feed(std::span<const std::uint8_t> bytes, DecoderOutput& out) {
  const char* p = reinterpret_cast<const char*>(bytes.data());
  const char* const end = p + bytes.size();
  if (holding_ && p != end) {
    if (*p == '\n') ++p, ++held_.length, ++begun_;
    holding_ = false;
    out.frame(held_);
  }
  while (p != end) p = take_piece(p, end, out);
}

// Reads as much of one line as lies in [p, end).
const char* Framing::take_piece(const char* p, const char* end, DecoderOutput& out) {
  const char* search = p;
  if (!open_) {
    open_ = true;
    size_ = 0;
    shape_ = shape_of(*p);
    if (shape_ == Line::Shape::sentence) ++search;  // its own $ does not end it
  }
  const bool carried = shape_ == Line::Shape::sentence || shape_ == Line::Shape::text;
  const std::uint64_t room = (carried ? kLongestSentence : kLongestPiece) - size_;
  const bool roomy = static_cast<std::uint64_t>(end - p) <= room;
  const char* const limit = roomy ? end : p + room + 1;  // the byte after a full line may be its terminator

  const char* const stop =
      shape_ == Line::Shape::comment ? std::find_if(search, limit, is_terminator) : find_stop(search, limit);
  if (stop != limit)
    return close(is_terminator(*stop) ? Line::End::terminator : Line::End::next_sentence, p, stop, end, out);
  if (roomy) {
    if (carried) std::memcpy(carry_.data() + size_, p, static_cast<std::size_t>(end - p));
    size_ += static_cast<std::uint64_t>(end - p);
    return end;
  }
  if (shape_ != Line::Shape::text) {
    p = close(Line::End::too_long, p, p + room, end, out);
    open_ = true;
    size_ = 0;
    if (shape_ == Line::Shape::sentence) shape_ = Line::Shape::rubbish;
    return p;
  }
  shape_ = Line::Shape::rubbish;  // too long for anything known: no text to keep
  size_ += room;
  return p + room;
}

// Reads the open line, whose last piece is [piece, stop), and reports it.
const char* Framing::close(Line::End how, const char* piece, const char* stop, const char* end,
                           DecoderOutput& out) {
  Line line{shape_, how, {}};
  const auto added = static_cast<std::size_t>(stop - piece);
  if (shape_ == Line::Shape::sentence || shape_ == Line::Shape::text) {
    if (size_ == 0) {
      line.text = {piece, added};
    } else {
      if (added > 0) std::memcpy(carry_.data() + size_, piece, added);
      line.text = {carry_.data(), static_cast<std::size_t>(size_) + added};
    }
  }
  FrameReport report = reader_.read(line, out);
  report.offset = begun_;
  std::uint64_t length = size_ + added;
  bool lf_may_follow = false;
  if (how == Line::End::terminator) {
    const bool cr = *stop == '\r';
    ++stop, ++length;
    if (cr && stop != end && *stop == '\n')
      ++stop, ++length;
    else
      lf_may_follow = cr && stop == end;
  }
  report.length = static_cast<std::uint32_t>(length);
  begun_ += length;
  open_ = false;
  if (lf_may_follow) {
    held_ = report;
    holding_ = true;
  } else {
    out.frame(report);
  }
  return stop;
}

void Framing::finish(DecoderOutput& out) {
  if (holding_) {
    holding_ = false;
    out.frame(held_);
  }
  if (open_ && size_ > 0) close(Line::End::stream, nullptr, nullptr, nullptr, out);
  open_ = false;
}

}  // namespace leadline::decode::nmea0183
