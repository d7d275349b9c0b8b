#pragma once

#include <cstdint>
#include <span>

namespace leadline::links {

/// Does the head of a file hold telegrams of this format? Told by checksums that hold (EvoLogics: by
/// lengths), behind garbage too, except for PNI, which has no sync byte and must begin with two whole frames
/// or be one.
[[nodiscard]] bool holds_nortek(std::span<const std::uint8_t> head);
[[nodiscard]] bool holds_xsens(std::span<const std::uint8_t> head);
[[nodiscard]] bool holds_evologics(std::span<const std::uint8_t> head);
[[nodiscard]] bool is_pni(std::span<const std::uint8_t> head);

}  // namespace leadline::links
