#pragma once

// Eight bytes at a time, without vector instructions.

#include <bit>
#include <cstdint>
#include <cstring>

namespace leadline::decode {

inline constexpr std::uint64_t kEachByte = 0x0101'0101'0101'0101;
inline constexpr std::uint64_t kHighBits = kEachByte * 0x80;

[[nodiscard]] inline std::uint64_t load_word(const char* p) {
  static_assert(std::endian::native == std::endian::little, "the first byte is the lowest");
  std::uint64_t w = 0;
  std::memcpy(&w, p, sizeof w);
  return w;
}

/// Not 0 when a byte of w is below n; n at most 128.
[[nodiscard]] constexpr std::uint64_t bytes_below(std::uint64_t w, std::uint8_t n) {
  return (w - kEachByte * n) & ~w & kHighBits;
}
/// Not 0 when a byte of w equals c.
[[nodiscard]] constexpr std::uint64_t bytes_equal(std::uint64_t w, char c) {
  return bytes_below(w ^ (kEachByte * static_cast<std::uint8_t>(c)), 1);
}

/// The high bit of every byte of w that equals c, and of no other.
[[nodiscard]] constexpr std::uint64_t each_equal(std::uint64_t w, char c) {
  const std::uint64_t x = w ^ (kEachByte * static_cast<std::uint8_t>(c));
  return ~(((x & ~kHighBits) + ~kHighBits) | x) & kHighBits;
}
/// Index of the lowest byte whose high bit is set; bits is not 0.
[[nodiscard]] constexpr int first_byte(std::uint64_t bits) { return std::countr_zero(bits) / 8; }

}  // namespace leadline::decode
