#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

#include "core/flow/decoder.h"

namespace leadline::decode::nmea0183 {

/// Longest sentence taken, without its terminator. The standard says 80; real devices send 125 and more.
inline constexpr std::size_t kLongestSentence = 512;

/// One line, or a piece of one, as the framing cut it.
struct Line {
  enum class Shape : std::uint8_t {
    sentence,  ///< begins with $ or !
    text,      ///< begins with anything else; may be empty
    comment,   ///< begins with # at the start of a line; `text` is not given
    rubbish    ///< the rest of something overlong; `text` is not given
  };
  enum class End : std::uint8_t { terminator, next_sentence, too_long, stream };
  Shape shape = Shape::text;
  End end = End::terminator;
  std::string_view text;  ///< without its terminator; valid during the call
};

class LineReader {
 public:
  virtual ~LineReader() = default;
  /// What the line is; the framing adds offset and length and reports it.
  virtual FrameReport read(const Line& line, DecoderOutput& out) = 0;
};

/// Cuts a byte stream into lines: CR LF, LF or CR end one, $ and ! begin one anywhere but in a comment. A
/// line inside one chunk is read where it lies; only what crosses a chunk is copied. A line that ends in CR
/// is read at once, so that no fact waits; its report waits for the LF that may follow.
class Framing {
 public:
  explicit Framing(LineReader& reader) : reader_(reader) {}
  void feed(std::span<const std::uint8_t> bytes, DecoderOutput& out);
  void finish(DecoderOutput& out);

 private:
  const char* take_piece(const char* begin, const char* end, DecoderOutput& out);
  const char* close(Line::End how, const char* piece, const char* stop, const char* end, DecoderOutput& out);

  LineReader& reader_;
  std::array<char, kLongestSentence> carry_{};
  std::uint64_t begun_ = 0;  // offset of the open line's first byte
  std::uint64_t size_ = 0;  // of the open line in earlier chunks; sentences and text: as many bytes in carry_
  bool open_ = false;
  Line::Shape shape_ = Line::Shape::text;
  FrameReport held_;  // ended in CR at the end of a chunk
  bool holding_ = false;
};

}  // namespace leadline::decode::nmea0183
