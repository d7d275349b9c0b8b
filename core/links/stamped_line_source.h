#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "core/flow/source.h"
#include "core/links/file_reader.h"
#include "core/links/line_stamp.h"

namespace leadline::links {

/// What the two stamped text logs share: a line is a stamp and a payload. Over all chunks stamp_bytes plus
/// the bytes (settled or not) sum to the file's size. Lines without a stamp are refused as "stamp", or as
/// "truncated" where the file ends inside them; lines above 64 KiB as "too long", what follows their first
/// 64 KiB counts as skipped. Blank lines and lines beginning with '#' are comment.
class StampedLineSource : public Source {
 public:
  bool next(Chunk& chunk) final;

  /// Lines stamped earlier than the line before; they are passed on as they are.
  [[nodiscard]] std::uint64_t backward_stamps() const { return backward_stamps_; }
  [[nodiscard]] std::uint64_t lines() const { return lines_; }
  /// Why the file ended early; empty when it did not.
  [[nodiscard]] const std::optional<Error>& failure() const { return file_.failure(); }

 protected:
  /// `whose`: the source that lines without a stamp belong to.
  StampedLineSource(FileReader file, SourceId whose) : file_(std::move(file)), whose_(whose) {}

  [[nodiscard]] virtual std::optional<LineStamp> stamp_of(std::string_view line) const = 0;
  /// Sets source and bytes (or settled) from what follows the stamp; `line` is the whole line.
  virtual void take_payload(std::string_view line, std::string_view payload, Chunk& chunk) = 0;

  static std::span<const std::uint8_t> bytes_of(std::string_view text) {
    return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
  }
  /// All of the line in one class.
  static void settle(Chunk& chunk, std::string_view line, ByteClass byte_class, std::string_view reason = {});

 private:
  void find_first_stamp();

  FileReader file_;
  SourceId whose_;
  Arrival latest_;
  bool started_ = false;
  ByteClass rest_of_long_line_ = ByteClass::skipped;
  std::uint64_t lines_ = 0, backward_stamps_ = 0;
};

}  // namespace leadline::links
