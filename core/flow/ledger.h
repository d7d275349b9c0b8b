#pragma once

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

#include "core/flow/decoder.h"
#include "core/flow/source.h"

namespace leadline {

/// The account of one source: every byte in one class, every telegram by kind, every refusal by reason.
class Ledger {
 public:
  struct Kind {
    std::string_view name;
    std::uint64_t count = 0;  ///< decoded or known and unused
    ByteClass byte_class = ByteClass::decoded;
    Arrival first{}, last{};
  };
  struct Reason {
    std::string_view name;
    std::uint64_t count = 0;
  };

  void count(const FrameReport& report, Arrival arrival);
  /// Bytes the Source settled itself, and the stamps around any.
  void count(const Chunk& chunk);

  [[nodiscard]] std::uint64_t bytes(ByteClass c) const { return bytes_[static_cast<std::size_t>(c)]; }
  [[nodiscard]] std::uint64_t bytes_total() const;
  /// Telegrams: decoded, unused, unknown and refused together.
  [[nodiscard]] std::uint64_t frames() const { return frames_; }
  [[nodiscard]] std::uint64_t frames(ByteClass c) const {
    return frames_by_class_[static_cast<std::size_t>(c)];
  }
  [[nodiscard]] std::uint64_t checksums(ChecksumState s) const {
    return checksums_[static_cast<std::size_t>(s)];
  }
  /// Telegrams that never came, by their senders' own count.
  [[nodiscard]] std::uint64_t lost() const { return lost_; }
  [[nodiscard]] const std::vector<Kind>& kinds() const { return kinds_; }
  [[nodiscard]] const std::vector<Reason>& refusals() const { return refusals_; }
  /// Something was lost: a telegram refused or bytes skipped (exit status 3).
  [[nodiscard]] bool damaged() const { return !refusals_.empty() || bytes(ByteClass::skipped) > 0; }

 private:
  void refuse(std::string_view reason);

  std::array<std::uint64_t, kByteClasses> bytes_{};
  std::array<std::uint64_t, kByteClasses> frames_by_class_{};
  std::array<std::uint64_t, 4> checksums_{};
  std::uint64_t frames_ = 0, lost_ = 0;
  std::vector<Kind> kinds_;
  std::vector<Reason> refusals_;
};

}  // namespace leadline
