#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>

// Numbers at an offset, little-endian (le_) and big-endian (be_); the caller has checked that they are there.

namespace leadline::decode {

[[nodiscard]] inline std::uint16_t le_u16(std::span<const std::uint8_t> b, std::size_t i) {
  return static_cast<std::uint16_t>(b[i] | b[i + 1] << 8);
}
[[nodiscard]] inline std::int16_t le_i16(std::span<const std::uint8_t> b, std::size_t i) {
  return static_cast<std::int16_t>(le_u16(b, i));
}
[[nodiscard]] inline std::uint32_t le_u32(std::span<const std::uint8_t> b, std::size_t i) {
  return le_u16(b, i) | static_cast<std::uint32_t>(le_u16(b, i + 2)) << 16;
}
[[nodiscard]] inline std::int32_t le_i32(std::span<const std::uint8_t> b, std::size_t i) {
  return static_cast<std::int32_t>(le_u32(b, i));
}
[[nodiscard]] inline std::uint64_t le_u64(std::span<const std::uint8_t> b, std::size_t i) {
  return le_u32(b, i) | static_cast<std::uint64_t>(le_u32(b, i + 4)) << 32;
}
[[nodiscard]] inline float le_f32(std::span<const std::uint8_t> b, std::size_t i) {
  return std::bit_cast<float>(le_u32(b, i));
}
[[nodiscard]] inline double le_f64(std::span<const std::uint8_t> b, std::size_t i) {
  return std::bit_cast<double>(le_u64(b, i));
}

[[nodiscard]] inline std::uint16_t be_u16(std::span<const std::uint8_t> b, std::size_t i) {
  return static_cast<std::uint16_t>(b[i] << 8 | b[i + 1]);
}
[[nodiscard]] inline std::uint32_t be_u32(std::span<const std::uint8_t> b, std::size_t i) {
  return static_cast<std::uint32_t>(be_u16(b, i)) << 16 | be_u16(b, i + 2);
}
[[nodiscard]] inline std::uint64_t be_u64(std::span<const std::uint8_t> b, std::size_t i) {
  return static_cast<std::uint64_t>(be_u32(b, i)) << 32 | be_u32(b, i + 4);
}
[[nodiscard]] inline float be_f32(std::span<const std::uint8_t> b, std::size_t i) {
  return std::bit_cast<float>(be_u32(b, i));
}
[[nodiscard]] inline double be_f64(std::span<const std::uint8_t> b, std::size_t i) {
  return std::bit_cast<double>(be_u64(b, i));
}

}  // namespace leadline::decode
