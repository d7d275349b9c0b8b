#include "core/decode/iec61162_450_framing.h"

#include <algorithm>
#include <cstring>
#include <utility>

#include "core/decode/nmea0183_words.h"
#include "core/types/expect.h"

namespace leadline::decode::udpbc {
namespace {

/// An endless line is told in pieces of this size.
constexpr std::size_t kLongestPiece = std::size_t{1} << 20;

constexpr std::array<Token, 5> kTokens{
    {{"UdPbC", false}, {"RaUdP", true}, {"RrUdP", true}, {"RpUdP", true}, {"NkPgN", true}}};

/// The first byte that may end something: NUL, LF or CR.
const char* find_stop(const char* p, const char* end) {
  const auto stops = [](char c) { return c == '\0' || c == '\n' || c == '\r'; };
  for (; end - p >= 8; p += 8) {
    if (bytes_below(load_word(p), '\r' + 1) == 0) continue;
    for (int i = 0; i < 8; ++i)
      if (stops(p[i])) return p + i;
  }
  return std::find_if(p, end, stops);
}

}  // namespace

std::size_t Framing::limit() const {
  return state_ == State::line     ? kLongestDatagram
         : state_ == State::binary ? kLongestDatagram - kHeaderBytes
                                   : kLongestPiece;
}

void Framing::feed(std::span<const std::uint8_t> bytes) {
  const char* p = reinterpret_cast<const char*>(bytes.data());
  const char* const end = p + bytes.size();
  while (p != end) {
    if (held_ > 0) {
      if (*p == '\n') ++p, ++held_, ++begun_;
      reader_.line_length(std::exchange(held_, 0));
      continue;
    }
    const char* start = p;  // of what this chunk has of the open piece
    for (;;) {
      const char* const stop = find_stop(p, end);
      while (before_ + static_cast<std::uint64_t>(stop - start) > limit()) start = cut(start, stop);
      if (stop == end) {
        append(start, end);
        return;
      }
      if (*stop == '\0') {
        const bool whole = before_ + static_cast<std::uint64_t>(stop - start) >= kTail;
        const auto name = last(start, stop);
        const auto token = std::find_if(kTokens.begin(), kTokens.end(), [&](const Token& t) {
          return whole && t.name == std::string_view(name.data(), name.size());
        });
        p = stop + 1;
        if (token == kTokens.end()) continue;  // a byte as any other
        header(*token, start, stop);
        break;
      }
      p = stop + 1;
      if (state_ == State::binary) continue;
      close(LineEnd::terminator, start, stop, 0, 1);
      if (*stop == '\n' && held_ > 0) reader_.line_length(std::exchange(held_, 0));
      break;
    }
  }
}

void Framing::finish() {
  if (held_ > 0) reader_.line_length(std::exchange(held_, 0));
  close(LineEnd::stream, nullptr, nullptr, 0, 0);
  if (held_ > 0) reader_.line_length(std::exchange(held_, 0));
}

/// The last five bytes of the open piece, which ends at stop.
std::array<char, Framing::kTail> Framing::last(const char* start, const char* stop) const {
  std::array<char, kTail> name = tail_;
  const auto here = std::min<std::size_t>(kTail, static_cast<std::size_t>(stop - start));
  if (here == 0) return name;
  std::memmove(name.data(), name.data() + here, kTail - here);
  std::memcpy(name.data() + kTail - here, stop - here, here);
  return name;
}

void Framing::append(const char* start, const char* stop) {
  if (start == stop) return;
  const auto added = static_cast<std::size_t>(stop - start);
  if (state_ == State::line) std::memcpy(carry_.data() + before_, start, added);
  tail_ = last(start, stop);
  before_ += added;
}

/// Tells the open piece, which is longer than its limit, but for its last bytes: a header may begin there.
const char* Framing::cut(const char* start, const char* stop) {
  const std::size_t whole = limit(), told = whole - kTail;
  const char* const at = start + (whole - before_);  // before_ never passes the limit
  append(start, at);
  LL_EXPECT(before_ == whole && at <= stop);
  if (state_ == State::line) {
    reader_.line({carry_.data(), told}, LineEnd::too_long, begun_);
    reader_.line_length(static_cast<std::uint32_t>(told));
    state_ = State::rubbish;
  } else {
    reader_.content(state_ == State::binary, begun_, static_cast<std::uint32_t>(told));
    if (state_ == State::binary) state_ = State::line, std::copy(tail_.begin(), tail_.end(), carry_.begin());
  }
  begun_ += told;
  before_ = kTail;
  return at;
}

/// Tells the open piece, whose last bytes are [start, stop), without the last few of them.
void Framing::close(LineEnd how, const char* start, const char* stop, std::uint64_t without,
                    std::size_t terminator) {
  const bool carried = before_ > 0;
  if (carried) append(start, stop);
  const std::uint64_t size = (carried ? before_ : static_cast<std::uint64_t>(stop - start)) - without;
  const auto length = static_cast<std::uint32_t>(size + terminator);
  const auto begun = begun_;
  begun_ += length;
  before_ = 0;
  if (length > 0 && state_ == State::line) {
    reader_.line({carried ? carry_.data() : start, static_cast<std::size_t>(size)}, how, begun);
    held_ = length;
  } else if (length > 0) {
    reader_.content(state_ == State::binary, begun, length);
  }
  state_ = State::line;
}

void Framing::header(const Token& token, const char* start, const char* stop) {
  close(LineEnd::header, start, stop, kTail, 0);
  if (held_ > 0) reader_.line_length(std::exchange(held_, 0));
  reader_.header(token, begun_);
  begun_ += kHeaderBytes;
  state_ = token.binary ? State::binary : State::line;
}

}  // namespace leadline::decode::udpbc
