#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

namespace leadline::decode::udpbc {

/// Of a datagram, and so of a line: UDP over Ethernet carries 1472 bytes.
inline constexpr std::size_t kLongestDatagram = 1500;
inline constexpr std::size_t kHeaderBytes = 6;  ///< five letters and a NUL

/// What a datagram's header says: sentences, or one of the binary kinds.
struct Token {
  std::string_view name;
  bool binary = false;
};

/// How a line ended.
enum class LineEnd : std::uint8_t { terminator, header, too_long, stream };

class PieceReader {
 public:
  virtual ~PieceReader() = default;
  virtual void header(const Token& token, std::uint64_t offset) = 0;
  /// text: without its terminator, valid during the call. Its length is told by line_length() next.
  virtual void line(std::string_view text, LineEnd end, std::uint64_t offset) = 0;
  virtual void line_length(std::uint32_t length) = 0;
  /// What a binary datagram holds, or the rest of an overlong line.
  virtual void content(bool binary, std::uint64_t offset, std::uint32_t length) = 0;
};

/// Cuts a byte stream into headers, lines and the content of binary datagrams. A header begins a datagram
/// wherever it stands; CR LF, LF or CR end a line. A line inside one chunk is read where it lies. A line that
/// ends in CR is read at once; its length waits for the LF that may follow.
class Framing {
 public:
  explicit Framing(PieceReader& reader) : reader_(reader) {}
  void feed(std::span<const std::uint8_t> bytes);
  void finish();

 private:
  enum class State : std::uint8_t { line, rubbish, binary };
  static constexpr std::size_t kTail = kHeaderBytes - 1;

  [[nodiscard]] std::size_t limit() const;
  [[nodiscard]] std::array<char, kTail> last(const char* start, const char* stop) const;
  void append(const char* start, const char* stop);
  const char* cut(const char* start, const char* stop);
  void close(LineEnd how, const char* start, const char* stop, std::uint64_t without, std::size_t terminator);
  void header(const Token& token, const char* start, const char* stop);

  PieceReader& reader_;
  std::array<char, kLongestDatagram> carry_{};  // of the open line, what came in earlier chunks
  std::array<char, kTail> tail_{};              // its last bytes before this chunk, whatever it is
  std::uint64_t before_ = 0;                    // bytes of the open piece in earlier chunks
  std::uint64_t begun_ = 0;                     // offset of its first byte
  State state_ = State::line;
  std::uint32_t held_ = 0;  // length of a line that ended in CR
};

}  // namespace leadline::decode::udpbc
