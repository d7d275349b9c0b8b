#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "core/decode/trdi_pd0_ensemble.h"

namespace leadline::decode {

/// Longest ensemble or waves packet believed, bytes (wire-formats 3): longer announcements are damage.
inline constexpr std::size_t kPd0Ceiling = 16 * 1024;

/// Sum of all bytes modulo 65536, as PD0 closes its ensembles.
[[nodiscard]] std::uint16_t pd0_checksum(std::span<const std::uint8_t> bytes);

/// Receives what the framer cuts a stream into, in the order of the bytes and without a gap.
class Pd0FrameSink {
 public:
  virtual ~Pd0FrameSink() = default;
  /// A `7F 7F` ensemble whose checksum holds and whose layout reads; length: with its two checksum bytes.
  virtual void ensemble(std::uint64_t offset, std::uint32_t length, const Pd0Ensemble& ensemble) = 0;
  /// A `7F 79` waves packet whose checksum holds.
  virtual void waves(std::uint64_t offset, std::uint32_t length) = 0;
  /// Damage: reason "checksum", "truncated", "size" or "layout"; waves: it began with `7F 79`.
  virtual void refused(std::uint64_t offset, std::uint32_t length, std::string_view reason, bool waves) = 0;
  /// Bytes that belong to no frame.
  virtual void skipped(std::uint64_t offset, std::uint32_t length) = 0;
};

/// Cuts a byte stream into PD0 frames; the pieces do not depend on how the stream was cut into chunks.
///
/// Every position is tried as a header, and a sound ensemble is taken at the byte that completes it even when
/// an earlier header still announces more: a size field damaged upwards would else blind a vehicle for 16
/// KiB. A frame that fails runs to the next sound frame, or to the next header beyond its announced end, as
/// one refused piece. Runs longer than 64 KiB are cut there and go on as skipped.
class Pd0Framer {
 public:
  explicit Pd0Framer(Pd0FrameSink& sink, std::size_t ceiling = kPd0Ceiling);

  void feed(std::span<const std::uint8_t> bytes);
  /// The stream has ended: what was waited for is truncated.
  void finish();

 private:
  struct Candidate {
    std::uint64_t start, end;
    bool waves;
  };
  enum class Run : std::uint8_t { none, skipped, refused };

  std::size_t scan(std::span<const std::uint8_t> window);
  void discover(std::span<const std::uint8_t> window);
  void judge(const Candidate& candidate, std::span<const std::uint8_t> window);
  void settle(std::span<const std::uint8_t> window, std::uint64_t upto, bool ended);
  void fail(std::uint64_t at, std::uint64_t announced_end, std::string_view reason, bool waves);
  void extend_run(std::uint64_t upto);
  void close_run();

  Pd0FrameSink& sink_;
  std::size_t ceiling_;
  std::vector<std::uint8_t> carry_;    ///< what an unfinished frame needs kept
  std::vector<Candidate> candidates_;  ///< announced and not yet complete: a heap, earliest end first
  std::uint64_t base_ = 0;             ///< offset of the window's first byte in the stream
  std::uint64_t discovered_ = 0;       ///< headers before this offset are known
  std::uint64_t settled_ = 0;          ///< bytes before this offset are told or in the open run
  Run run_ = Run::none;
  std::string_view run_reason_;
  bool run_waves_ = false;
  std::uint64_t run_start_ = 0, run_announced_end_ = 0;
};

}  // namespace leadline::decode
