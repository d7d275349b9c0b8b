#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string_view>

#include "core/flow/decoder.h"

namespace leadline::decode {

/// One line, or the first `longest` bytes of one that has as many.
struct FoundLine {
  enum class End : std::uint8_t { terminator, too_long, stream };
  std::string_view text;  ///< without its terminator; valid during the call; never blank
  End end = End::terminator;
  std::uint64_t offset = 0;  ///< of its first byte in the stream
};

/// Who reads the lines of a LineSearch.
class LineReader {
 public:
  virtual ~LineReader() = default;
  /// Gives the line's facts and says what became of it; the search adds offset and length and reports it.
  /// Bytes before the telegram that are none of it may be reported first, `skipped` says how many.
  struct Verdict {
    FrameReport report;
    std::size_t skipped = 0;
  };
  virtual Verdict read(const FoundLine& line, DecoderOutput& out) = 0;
};

/// Cuts a byte stream into lines: CR LF, LF or CR end one. A line is read as soon as its first terminator is
/// there, so that no fact waits; its report waits for the LF that may follow a CR. One that lies inside one
/// chunk is read where it lies. Blank lines and those that begin with # are comments. What follows the first
/// `longest` bytes of a line is skipped to its end.
class LineSearch {
 public:
  LineSearch(LineReader& reader, std::size_t longest)
      : reader_(reader), longest_(longest), carry_(std::make_unique<char[]>(longest)) {}
  void feed(std::span<const std::uint8_t> bytes, DecoderOutput& out);
  void finish(DecoderOutput& out);

 private:
  const char* take(const char* p, const char* end, DecoderOutput& out);
  void close(std::string_view text, FoundLine::End how, DecoderOutput& out);
  void report(std::size_t length, DecoderOutput& out);

  LineReader& reader_;
  std::size_t longest_;
  std::unique_ptr<char[]> carry_;
  std::size_t size_ = 0;     ///< bytes of the open line, all of them in carry_ between chunks
  std::uint64_t begun_ = 0;  ///< offset of the open line
  FrameReport held_;         ///< of the line read last
  std::size_t held_size_ = 0;
  bool holding_ = false;  ///< it ended in a CR at the end of a chunk
  bool rest_ = false;     ///< what comes is the rest of an overlong line
};

[[nodiscard]] bool is_printable(std::string_view text);

}  // namespace leadline::decode
