#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>

#include "core/decode/frame_search.h"
#include "core/decode/trdi_pd0_ensemble.h"

namespace leadline::decode {

inline constexpr std::size_t kPd4Bytes = 47, kPd5Bytes = 88;

/// The fields of one PD4 or PD5 frame as sent.
struct Pd4Frame {
  std::uint8_t configuration = 0;
  std::array<std::int16_t, 4> bottom_mmps{}, water_mmps{};
  std::array<std::uint16_t, 4> range_cm{};
  std::uint8_t bottom_status = 0;  ///< two bits a beam: low correlation, low echo
  std::uint16_t layer_start_dm = 0, layer_end_dm = 0;
  std::uint8_t water_status = 0;
  std::uint8_t hour = 0, minute = 0, second = 0, hundredths = 0;
  std::uint16_t built_in_test = 0, sound_speed_mps = 0;
  std::int16_t temperature_cdegc = 0;
  struct Attitude {  ///< PD5
    std::uint16_t depth_dm = 0, heading_cdeg = 0;
    std::int16_t pitch_cdeg = 0, roll_cdeg = 0;
  };
  std::optional<Attitude> attitude;

  [[nodiscard]] Pd0Coordinates coordinates() const { return static_cast<Pd0Coordinates>(configuration >> 6); }
  [[nodiscard]] bool tilts_used() const { return (configuration & 0x20) != 0; }
  [[nodiscard]] int beams_low() const;
};

/// bytes: one whole frame, its checksum verified.
[[nodiscard]] Pd4Frame read_pd4_frame(std::span<const std::uint8_t> bytes);

/// What the first bytes begin. The size field counts the checksum in some units: 45 to 47, 86 to 88.
[[nodiscard]] FrameStart pd4_start(std::span<const std::uint8_t> bytes);

}  // namespace leadline::decode
