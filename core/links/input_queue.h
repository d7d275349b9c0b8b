#pragma once

#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <mutex>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/types/result.h"
#include "core/types/time.h"

namespace leadline::links {

/// Bytes as one link heard them.
struct InputFrame {
  std::uint16_t link = 0;  ///< its place in the order of links
  Arrival arrival;
  Time wall;
  std::string_view sender;              ///< who sent it, where the link tells; empty: unknown
  std::span<const std::uint8_t> bytes;  ///< these views are good until the next take()
};

/// From the I/O thread to the core thread, in order: a bounded piece of memory, and behind it a file on the
/// disk for what does not fit while the core is slow. The I/O thread never waits for the core. What a
/// program left in the file when it died is taken first by the next one.
class InputQueue {
 public:
  struct Options {
    std::size_t memory_bytes = std::size_t{4} << 20;
    std::string spill_path;  ///< empty: what does not fit is lost, and counted
    std::uint64_t spill_bytes = std::uint64_t{4} << 30;
    std::string links;  ///< what the places of links mean; stands first in the file
  };
  struct Status {
    std::size_t waiting_bytes = 0;         ///< in memory
    std::uint64_t spilled_bytes = 0;       ///< that took the way over the disk, so far
    std::uint64_t lost_frames = 0;         ///< no room anywhere
    std::uint64_t left_behind_frames = 0;  ///< found in the file of a program that died
    std::string last_error;
  };

  /// Error: the file of a former program cannot be read, or is of other links.
  [[nodiscard]] static Result<InputQueue> open(const Options& options);
  InputQueue(InputQueue&& other) noexcept;
  InputQueue& operator=(InputQueue&&) = delete;
  ~InputQueue();

  /// I/O thread.
  void push(const InputFrame& frame);
  /// Core thread. false: nothing came within `at_most`.
  [[nodiscard]] bool take(InputFrame& frame, std::chrono::milliseconds at_most);
  [[nodiscard]] Status status() const;

 private:
  explicit InputQueue(const Options& options);
  void spill(const InputFrame& frame);
  [[nodiscard]] InputFrame title() const;
  void flush_spill();
  [[nodiscard]] bool refill();
  void end_spill();
  void spill_failed(const char* doing);

  Options options_;
  mutable std::mutex mutex_;
  std::condition_variable came_;
  std::vector<std::uint8_t> waiting_;  // guarded, as all to the blank line
  Status status_;
  int spill_ = -1;
  std::vector<std::uint8_t> to_spill_;  // not yet written
  std::uint64_t spill_read_ = 0, spill_written_ = 0;

  std::vector<std::uint8_t> taken_;  // the core thread's
  std::size_t at_ = 0;
};

}  // namespace leadline::links
