#pragma once

#include <cstdint>
#include <cstring>
#include <deque>
#include <memory>
#include <vector>

#include "core/messages/message.h"

namespace leadline::sessions {

/// Messages on their way to the writer: values and raw bytes behind each other in blocks that are used again,
/// so that a message costs a copy and no allocation. Not locked: the recorder does that.
class MessageQueue {
 public:
  explicit MessageQueue(std::size_t most_bytes) : most_bytes_(most_bytes) {}

  /// A copy, its raw bytes included. false: it does not fit into what is left of the bound.
  [[nodiscard]] bool push(const Envelope& envelope);
  [[nodiscard]] bool empty() const { return blocks_.empty(); }
  /// Memory of the messages that wait, in whole blocks.
  [[nodiscard]] std::size_t bytes() const { return bytes_; }
  [[nodiscard]] std::size_t most_bytes() const { return most_bytes_; }

  struct Block {
    std::unique_ptr<std::uint8_t[]> memory;
    std::size_t capacity = 0, used = 0, read = 0;
  };
  /// Hands all that waits to `taken`, behind what is there; it still counts as waiting until given back.
  void take_all(std::deque<Block>& taken);
  void give_back(Block block);

  /// The next message of a block, from its read mark on; its bytes lie in the block. nullptr: no more.
  [[nodiscard]] static const Envelope* next(Block& block, Envelope& space);

 private:
  static constexpr std::size_t kBlock = std::size_t{256} << 10, kMostSpare = 16;
  [[nodiscard]] Block* room_for(std::size_t size);

  std::size_t most_bytes_, bytes_ = 0;
  std::deque<Block> blocks_;
  std::vector<Block> spare_;
};

}  // namespace leadline::sessions
