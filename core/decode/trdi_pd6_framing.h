#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

#include "core/flow/decoder.h"

namespace leadline::decode {

/// Where the PD6 framing puts what it cut: every byte once, in order.
class Pd6LineSink {
 public:
  enum class End : std::uint8_t { terminator, next_line, too_long, stream };
  virtual ~Pd6LineSink() = default;
  /// text: from its ':' and without its terminator, which length counts; valid during the call.
  virtual void line(std::string_view text, End end, std::uint64_t offset, std::uint32_t length) = 0;
  /// Bytes between lines: comment (blank or after '#'), unknown (other text) or skipped.
  virtual void between(ByteClass byte_class, std::uint64_t offset, std::uint32_t length) = 0;
};

/// Cuts a byte stream into lines: CR LF, LF or CR end one, ':' begins one anywhere. A line inside one chunk
/// is told where it lies; only what crosses a chunk is copied.
class Pd6Framer {
 public:
  /// A line has fewer bytes than this; the longest of a real device has 60.
  static constexpr std::size_t kLongestLine = 256;

  explicit Pd6Framer(Pd6LineSink& sink) : sink_(sink) {}
  void feed(std::span<const std::uint8_t> bytes);
  void finish();

 private:
  enum class Shape : std::uint8_t { line, comment, text, rubbish };
  const char* take(const char* p, const char* end);
  void keep(const char* p, const char* end);
  void close(Pd6LineSink::End how, const char* piece, const char* end, std::size_t terminator);

  Pd6LineSink& sink_;
  std::array<char, kLongestLine> carry_{};
  std::uint64_t begun_ = 0;  ///< offset of the open piece
  std::size_t size_ = 0;     ///< of the open piece in earlier chunks; a line has as many bytes in carry_
  bool open_ = false;
  bool cr_ = false;        ///< the open piece has ended in CR: LF may follow
  bool overlong_ = false;  ///< what comes is the rest of something told in pieces
  bool blank_ = true;
  Shape shape_ = Shape::text;
};

}  // namespace leadline::decode
