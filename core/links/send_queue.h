#pragma once

#include <cstddef>
#include <cstdint>
#include <mutex>
#include <span>
#include <utility>
#include <vector>

namespace leadline::links {

/// Frames one behind the other, each with the tag its sender gave it.
struct FrameBatch {
  struct Frame {
    std::size_t end;  ///< of its bytes
    std::int64_t tag;
  };
  std::vector<std::uint8_t> bytes;
  std::vector<Frame> frames;

  void add(std::span<const std::uint8_t> frame, std::int64_t tag) {
    bytes.insert(bytes.end(), frame.begin(), frame.end());
    frames.push_back({bytes.size(), tag});
  }
  [[nodiscard]] std::span<const std::uint8_t> operator[](std::size_t i) const {
    const std::size_t begin = i == 0 ? 0 : frames[i - 1].end;
    return std::span(bytes).subspan(begin, frames[i].end - begin);
  }
  void clear() { bytes.clear(), frames.clear(); }
};

/// Frames on their way from the caller's thread to the I/O thread: bounded, and in the long run without
/// allocation, for the two sides exchange their buffers.
class SendQueue {
 public:
  enum class Pushed : std::uint8_t { refused, first, further };

  explicit SendQueue(std::size_t most_bytes) : most_bytes_(most_bytes) {}

  /// first: the queue was empty, so its reader may be asleep; refused: it is full.
  [[nodiscard]] Pushed push(std::span<const std::uint8_t> frame, std::int64_t tag) {
    // What a frame costs beside its bytes counts too: a flood of empty ones is bounded as well.
    constexpr std::size_t kCost = sizeof(FrameBatch::Frame);
    const std::lock_guard lock(mutex_);
    if (waiting_.bytes.size() + frame.size() + kCost * (waiting_.frames.size() + 1) > most_bytes_)
      return Pushed::refused;
    waiting_.add(frame, tag);
    return waiting_.frames.size() == 1 ? Pushed::first : Pushed::further;
  }

  /// All that waits, into an emptied batch; false when nothing does.
  [[nodiscard]] bool take(FrameBatch& batch) {
    batch.clear();
    const std::lock_guard lock(mutex_);
    std::swap(batch, waiting_);
    return !batch.frames.empty();
  }

 private:
  std::size_t most_bytes_;
  std::mutex mutex_;
  FrameBatch waiting_;
};

}  // namespace leadline::links
