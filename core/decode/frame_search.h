#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "core/flow/decoder.h"

namespace leadline::decode {

/// What the first bytes of the rest of a stream begin.
struct FrameStart {
  enum class Is : std::uint8_t {
    nothing,    ///< no frame begins with the first byte
    unsettled,  ///< more bytes are needed to tell
    frame,
    broken  ///< it looks like a frame and is none
  };
  Is is = Is::nothing;
  std::size_t length = 0;   ///< frame: of it; broken: as far as it announced to reach
  std::string_view kind;    ///< outlives the search; unsettled: empty while it may be anything
  std::string_view reason;  ///< broken: why
};

/// A format whose frames lie somewhere in a byte stream, and where its search puts what it found: every byte
/// once, in order.
class FrameFormat {
 public:
  virtual ~FrameFormat() = default;
  /// A pure function: once settled, more bytes do not change the answer. rest is not empty; ended: no more
  /// bytes will follow it.
  [[nodiscard]] virtual FrameStart start(std::span<const std::uint8_t> rest, bool ended) const = 0;
  /// bytes are valid during the call.
  virtual void frame(std::uint64_t offset, std::span<const std::uint8_t> bytes, const FrameStart& start) = 0;
  /// A refused frame or a run of skipped bytes, ready to be reported.
  virtual void lost(const FrameReport& report) = 0;
};

/// Finds frames in a byte stream. A start that turns out broken costs only itself: the search goes on behind
/// its first byte, and what looks like another start as far as it announced is taken for its data, unless it
/// is a whole frame. The result does not depend on how the stream is cut into chunks.
class FrameSearch {
 public:
  /// window_bytes: at least the longest frame; what starts a longer one is refused as "too long".
  FrameSearch(FrameFormat& format, std::size_t window_bytes);
  void feed(std::span<const std::uint8_t> bytes);
  /// Judges what is pending as if the stream had ended: what is not whole is refused as "truncated". The
  /// stream may go on (after a silence) with bytes that belong to none of it.
  void finish();

 private:
  void scan(bool ended);
  void give_up_byte(std::size_t announced, const FrameStart& start);
  void close_run();

  FrameFormat& format_;
  std::vector<std::uint8_t> window_;
  std::size_t size_ = 0, at_ = 0;  ///< bytes in the window; those before at_ are judged
  std::uint64_t offset_ = 0;       ///< of window_[at_] in the stream
  std::uint64_t run_start_ = 0;    ///< bytes from here to offset_ belong to no frame
  std::uint64_t refused_end_ = 0;  ///< the run is of a broken frame that announced to end here; 0: of none
  std::string_view refused_kind_, reason_;
};

}  // namespace leadline::decode
