#pragma once

#include <bit>
#include <cstdint>
#include <span>
#include <string>

#include "core/sim/telegrams/telegrams.h"

namespace leadline::sim {

/// Writes the numbers of one binary telegram, most or least significant byte first.
class BinaryWriter {
 public:
  enum class Order : std::uint8_t { big, little };
  BinaryWriter(Telegrams& out, Order order) : out_(out), order_(order), begin_(out.bytes.size()) {}

  void number(std::uint64_t value, int bytes) {
    for (int i = 0; i < bytes; ++i)
      out_.bytes.push_back(static_cast<char>(value >> 8 * (order_ == Order::big ? bytes - 1 - i : i)));
  }
  void u8(std::uint64_t value) { number(value, 1); }
  void u16(std::uint64_t value) { number(value, 2); }
  void u32(std::uint64_t value) { number(value, 4); }
  void f32(double value) { u32(std::bit_cast<std::uint32_t>(static_cast<float>(value))); }
  void f64(double value) { number(std::bit_cast<std::uint64_t>(value), 8); }
  /// What has been written of it, from its byte `from`.
  [[nodiscard]] std::span<const std::uint8_t> written(std::size_t from = 0) const {
    return {reinterpret_cast<const std::uint8_t*>(out_.bytes.data()) + begin_ + from,
            out_.bytes.size() - begin_ - from};
  }
  /// Puts right what stands at byte `at`.
  void patch_u16(std::size_t at, std::uint16_t value) {
    const auto high = static_cast<char>(value >> 8), low = static_cast<char>(value);
    out_.bytes[begin_ + at] = order_ == Order::big ? high : low;
    out_.bytes[begin_ + at + 1] = order_ == Order::big ? low : high;
  }

 private:
  Telegrams& out_;
  Order order_;
  std::size_t begin_;
};

}  // namespace leadline::sim
