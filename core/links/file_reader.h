#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "core/types/result.h"

namespace leadline::links {

/// A file read forward through one window: memory stays flat for any size. It is read, never mapped: a file
/// that another program cuts short while we read ends early instead of killing us. Views into it last until
/// the next call. A failing disk ends the file early and leaves its Error in failure().
class FileReader {
 public:
  static constexpr std::size_t kWindow = std::size_t{1} << 20;
  static constexpr std::size_t kLineCeiling = std::size_t{64} << 10;

  /// Error when it is missing, a folder, not a plain file or may not be read.
  [[nodiscard]] static Result<FileReader> open(const std::string& path);
  ~FileReader();
  FileReader(FileReader&& other) noexcept;
  FileReader& operator=(FileReader&& other) noexcept;

  /// The next line with its terminator (the last one may have none); false at the end. A line longer than
  /// kLineCeiling comes in pieces: line_goes_on() is true after every piece but its last.
  bool line(std::string_view& out);
  [[nodiscard]] bool line_goes_on() const { return line_goes_on_; }

  /// The next n bytes, fewer only at the end; n at most kWindow.
  std::span<const std::uint8_t> take(std::size_t n);
  /// The same without consuming them.
  std::span<const std::uint8_t> peek(std::size_t n);
  void rewind();

  [[nodiscard]] const std::string& path() const { return path_; }
  [[nodiscard]] std::uint64_t size() const { return size_; }      ///< when it was opened
  [[nodiscard]] std::uint64_t offset() const { return offset_; }  ///< bytes consumed so far
  [[nodiscard]] const std::optional<Error>& failure() const { return failure_; }

 private:
  FileReader(std::string path, int descriptor, std::uint64_t size);
  void fill(std::size_t wanted);
  void consume(std::size_t n) { begin_ += n, offset_ += n; }
  void close();

  std::string path_;
  int descriptor_ = -1;
  std::uint64_t size_ = 0, offset_ = 0;
  std::unique_ptr<char[]> window_;
  std::size_t begin_ = 0, end_ = 0;
  bool ended_ = false;
  bool line_goes_on_ = false;
  std::optional<Error> failure_;
};

}  // namespace leadline::links
