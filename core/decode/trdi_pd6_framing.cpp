#include "core/decode/trdi_pd6_framing.h"

#include <algorithm>
#include <cstring>

#include "core/decode/nmea0183_words.h"

namespace leadline::decode {
namespace {

constexpr std::size_t kLongestPiece = 64 * 1024;

constexpr bool is_stop(char c) { return c == '\r' || c == '\n' || c == ':'; }

const char* find_stop(const char* p, const char* end) {
  for (; end - p >= 8; p += 8) {
    const std::uint64_t w = load_word(p);
    if ((bytes_below(w, 0x20) | bytes_equal(w, ':')) == 0) continue;
    for (int i = 0; i < 8; ++i)
      if (is_stop(p[i])) return p + i;
  }
  while (p != end && !is_stop(*p)) ++p;
  return p;
}

}  // namespace

void Pd6Framer::feed(std::span<const std::uint8_t> bytes) {
  const char* p = reinterpret_cast<const char*>(bytes.data());
  const char* const end = p + bytes.size();
  while (p != end) p = take(p, end);
}

const char* Pd6Framer::take(const char* p, const char* end) {
  if (cr_) {
    const bool lf = *p == '\n';
    close(Pd6LineSink::End::terminator, p, p, lf ? 2 : 1);
    return p + lf;
  }
  const char* search = p;
  if (!open_) {
    open_ = true, blank_ = true;
    shape_ = *p == ':' ? Shape::line : overlong_ ? Shape::rubbish : *p == '#' ? Shape::comment : Shape::text;
    overlong_ = false;
    if (shape_ == Shape::line) ++search;  // its own ':' does not end it
  }
  const std::size_t room = (shape_ == Shape::line ? kLongestLine : kLongestPiece) - size_;
  const bool roomy = static_cast<std::size_t>(end - p) < room;
  const char* const limit = roomy ? end : p + room;
  const char* const stop = find_stop(search, limit);
  if (stop != limit) {
    if (*stop == ':') return close(Pd6LineSink::End::next_line, p, stop, 0), stop;
    if (*stop == '\n') return close(Pd6LineSink::End::terminator, p, stop, 1), stop + 1;
    if (stop + 1 != end) {
      const bool lf = stop[1] == '\n';
      return close(Pd6LineSink::End::terminator, p, stop, lf ? 2 : 1), stop + 1 + lf;
    }
    keep(p, stop);
    cr_ = true;
    return end;
  }
  if (roomy) return keep(p, limit), end;
  close(Pd6LineSink::End::too_long, p, limit, 0);
  overlong_ = true;
  return limit;
}

void Pd6Framer::keep(const char* p, const char* end) {
  const auto added = static_cast<std::size_t>(end - p);
  if (shape_ == Shape::line && added > 0) std::memcpy(carry_.data() + size_, p, added);
  if (shape_ == Shape::text) {
    for (const char* c = p; c != end; ++c) {
      if (*c != ' ') blank_ = false;
      if (*c < 0x20 || *c > 0x7E) shape_ = Shape::rubbish;
    }
  }
  size_ += added;
}

void Pd6Framer::close(Pd6LineSink::End how, const char* piece, const char* end, std::size_t terminator) {
  const auto added = static_cast<std::size_t>(end - piece);
  const auto length = static_cast<std::uint32_t>(size_ + added + terminator);
  const std::uint64_t offset = begun_;
  if (shape_ == Shape::line && size_ == 0) {
    sink_.line({piece, added}, how, offset, length);
  } else {
    keep(piece, end);
    if (shape_ == Shape::line)
      sink_.line({carry_.data(), size_}, how, offset, length);
    else if (shape_ == Shape::comment || (shape_ == Shape::text && blank_))
      sink_.between(ByteClass::comment, offset, length);
    else
      sink_.between(shape_ == Shape::text && how != Pd6LineSink::End::next_line ? ByteClass::unknown
                                                                                : ByteClass::skipped,
                    offset, length);
  }
  begun_ += length;
  size_ = 0;
  open_ = cr_ = false;
}

void Pd6Framer::finish() {
  if (open_)
    close(cr_ ? Pd6LineSink::End::terminator : Pd6LineSink::End::stream, nullptr, nullptr, cr_ ? 1 : 0);
  overlong_ = false;
}

}  // namespace leadline::decode
