#include "sessions/recorder/message_queue.h"

#include <algorithm>
#include <array>
#include <span>
#include <type_traits>
#include <utility>
#include <variant>

namespace leadline::sessions {
namespace {

/// An Envelope without its message: of that only the kind it is of is kept, which mostly is far smaller than
/// the largest.
struct Head {
  std::uint64_t seq, raw;
  Time valid;
  Arrival arrival;
  Time wall_utc;
  SourceId source;
  std::uint16_t kind;
};

Head head_of(const Envelope& e) {
  return {
      e.seq, e.raw, e.valid, e.arrival, e.wall_utc, e.source, static_cast<std::uint16_t>(e.message.index())};
}

/// Makes a message of its bytes; how many they were.
using Reader = std::size_t (*)(const std::uint8_t*, Message&);
template <std::size_t... kKinds>
constexpr auto readers(std::index_sequence<kKinds...> /*kinds*/) {
  return std::array<Reader, sizeof...(kKinds)>{[](const std::uint8_t* from, Message& to) {
    auto& message = to.emplace<kKinds>();
    std::memcpy(static_cast<void*>(&message), from, sizeof message);
    return sizeof message;
  }...};
}
constexpr auto kReaders = readers(std::make_index_sequence<std::variant_size_v<Message>>());

}  // namespace

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
  return std::visit(
      [&](const auto& message) {
        using M = std::decay_t<decltype(message)>;
        static_assert(std::is_trivially_copyable_v<M>);
        std::span<const std::uint8_t> raw;
        if constexpr (std::is_same_v<M, RawFrame>) raw = message.bytes;
        const Head head = head_of(envelope);
        Block* block = room_for(sizeof head + sizeof message + raw.size());
        if (block == nullptr) return false;
        std::uint8_t* to = block->memory.get() + block->used;
        std::memcpy(to, &head, sizeof head);
        std::memcpy(to + sizeof head, &message, sizeof message);
        if (!raw.empty()) std::memcpy(to + sizeof head + sizeof message, raw.data(), raw.size());
        block->used += sizeof head + sizeof message + raw.size();
        return true;
      },
      envelope.message);
}

void MessageQueue::take_all(std::deque<Block>& taken) {
  for (Block& block : blocks_) taken.push_back(std::move(block));
  blocks_.clear();
}

void MessageQueue::give_back(Block block) {
  bytes_ -= block.capacity;
  if (block.capacity != kBlock || spare_.size() == kMostSpare) return;
  block.used = block.read = 0;
  spare_.push_back(std::move(block));
}

const Envelope* MessageQueue::next(Block& block, Envelope& space) {
  if (block.read == block.used) return nullptr;
  const std::uint8_t* from = block.memory.get() + block.read;
  Head head;
  std::memcpy(&head, from, sizeof head);
  space.seq = head.seq, space.raw = head.raw;
  space.valid = head.valid, space.arrival = head.arrival, space.wall_utc = head.wall_utc;
  space.source = head.source;
  block.read += sizeof head + kReaders[head.kind](from + sizeof head, space.message);
  if (auto* raw = std::get_if<RawFrame>(&space.message)) {
    raw->bytes = {block.memory.get() + block.read, raw->bytes.size()};
    block.read += raw->bytes.size();
  }
  return &space;
}

}  // namespace leadline::sessions
