#include "sessions/recorder/message_queue.h"

#include <algorithm>

namespace leadline::sessions {

MessageQueue::Block* MessageQueue::room_for(std::size_t size) {
  if (!blocks_.empty() && blocks_.back().capacity - blocks_.back().used >= size) return &blocks_.back();
  const std::size_t capacity = std::max(kBlock, size);
  if (bytes_ + capacity > most_bytes_) return nullptr;
  Block block;
  if (capacity == kBlock && !spare_.empty()) {
    block = std::move(spare_.back());
    spare_.pop_back();
  } else {
    block.memory.reset(new std::uint8_t[capacity]);
    block.capacity = capacity;
  }
  bytes_ += capacity;
  return &blocks_.emplace_back(std::move(block));
}

bool MessageQueue::push(const Envelope& envelope) {
  const auto* raw = std::get_if<RawFrame>(&envelope.message);
  const std::size_t extra = raw != nullptr ? raw->bytes.size() : 0;
  Block* block = room_for(sizeof(Envelope) + extra);
  if (block == nullptr) return false;
  std::memcpy(block->memory.get() + block->used, &envelope, sizeof(Envelope));
  if (extra > 0) std::memcpy(block->memory.get() + block->used + sizeof(Envelope), raw->bytes.data(), extra);
  block->used += sizeof(Envelope) + extra;
  return true;
}

void MessageQueue::take_all(std::deque<Block>& taken) {
  for (Block& block : blocks_) taken.push_back(std::move(block));
  blocks_.clear();
}

void MessageQueue::give_back(Block block) {
  bytes_ -= block.capacity;
  if (block.capacity != kBlock) return;
  block.used = block.read = 0;
  spare_.push_back(std::move(block));
}

const Envelope* MessageQueue::next(Block& block, Envelope& space) {
  if (block.read == block.used) return nullptr;
  std::memcpy(static_cast<void*>(&space), block.memory.get() + block.read, sizeof(Envelope));
  block.read += sizeof(Envelope);
  if (auto* raw = std::get_if<RawFrame>(&space.message)) {
    raw->bytes = {block.memory.get() + block.read, raw->bytes.size()};
    block.read += raw->bytes.size();
  }
  return &space;
}

}  // namespace leadline::sessions
