#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

#include "core/decode/trdi_pd4_frame.h"

namespace leadline::decode {

/// Where the PD4 framing puts what it found: every byte once, in order.
class Pd4FrameSink {
 public:
  virtual ~Pd4FrameSink() = default;
  virtual void frame(std::uint64_t offset, std::span<const std::uint8_t> bytes) = 0;
  /// reason: "checksum" or "truncated".
  virtual void refused(std::uint64_t offset, std::uint32_t length, bool pd5, std::string_view reason) = 0;
  virtual void skipped(std::uint64_t offset, std::uint32_t length) = 0;
};

/// Finds PD4 and PD5 frames in a byte stream. A start whose checksum fails costs only itself: the search goes
/// on behind its first byte.
class Pd4Framer {
 public:
  explicit Pd4Framer(Pd4FrameSink& sink) : sink_(sink) {}
  void feed(std::span<const std::uint8_t> bytes);
  void finish();

 private:
  void scan(bool ended);
  void give_up_byte(std::size_t announced, bool pd5, std::string_view reason);
  void close_run();

  Pd4FrameSink& sink_;
  std::array<std::uint8_t, 4096> window_{};
  std::size_t size_ = 0, at_ = 0;  ///< bytes in the window; those before at_ are judged
  std::uint64_t offset_ = 0;       ///< of window_[at_] in the stream
  std::uint64_t run_start_ = 0;    ///< bytes from here to offset_ belong to no frame
  std::uint64_t refused_end_ = 0;  ///< the run is of a broken frame that announced to end here; 0: of none
  bool refused_pd5_ = false;
  std::string_view reason_;
};

}  // namespace leadline::decode
