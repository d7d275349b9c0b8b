#pragma once

// What a PD0 ensemble holds, as it holds it: raw integers, units in the names, nothing judged
// (wire-formats 3; Pathfinder DVL Guide, April 2018, output data format).

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

namespace leadline::decode {

inline constexpr std::int16_t kPd0Missing = -32768;

/// Bits of Pd0FixedLeader::sensor_source and sensors_available.
inline constexpr std::uint8_t kPd0DepthSensor = 0x20;

enum class Pd0Coordinates : std::uint8_t { beam, instrument, ship, earth };

struct Pd0FixedLeader {
  std::uint8_t firmware_version, firmware_revision;
  std::uint16_t system_configuration;
  std::uint8_t simulated, lag_length, beams, cells;
  std::uint16_t pings, cell_cm, blank_cm;
  std::uint8_t processing_mode, correlation_min, code_repetitions, percent_good_min;
  std::uint16_t error_velocity_max_mmps;
  std::uint8_t ping_minutes, ping_seconds, ping_hundredths;
  std::uint8_t coordinate_transform;
  std::int16_t heading_alignment_cdeg, heading_bias_cdeg;
  std::uint8_t sensor_source, sensors_available;
  std::uint16_t bin1_cm, pulse_cm;
  std::uint8_t reference_layer_start, reference_layer_stop, false_target_max, low_latency_trigger;
  std::uint16_t lag_cm;
  std::optional<std::uint32_t> serial_number;
  std::optional<std::uint8_t> beam_angle_deg;

  [[nodiscard]] bool convex() const { return (system_configuration & 0x0008) != 0; }
  [[nodiscard]] bool up_facing() const { return (system_configuration & 0x0080) != 0; }
  [[nodiscard]] Pd0Coordinates coordinates() const {
    return static_cast<Pd0Coordinates>(coordinate_transform >> 3 & 3);
  }
  [[nodiscard]] bool tilts_used() const { return (coordinate_transform & 0x04) != 0; }
  [[nodiscard]] bool three_beams_allowed() const { return (coordinate_transform & 0x02) != 0; }
  /// Of the beams from the vertical: its own byte, else the system configuration's; 0 when neither says.
  [[nodiscard]] int beam_angle() const;
};

struct Pd0VariableLeader {
  struct Clock {
    std::uint8_t year, month, day, hour, minute, second, hundredths;
  };
  std::uint32_t ensemble_number;
  Clock clock;
  std::uint16_t built_in_test, sound_speed_mps, depth_dm, heading_cdeg;
  std::int16_t pitch_cdeg, roll_cdeg;
  std::uint16_t salinity_ppt;
  std::int16_t temperature_cdegc;
  std::uint8_t min_ping_minutes, min_ping_seconds, min_ping_hundredths;
  std::uint8_t sd_heading_deg, sd_pitch_ddeg, sd_roll_ddeg;
  std::array<std::uint8_t, 8> adc;
  std::optional<std::uint32_t> error_status;
  std::optional<std::int32_t> pressure_dapa;
  std::optional<std::uint8_t> century;  ///< of clock_y2k
  std::optional<Clock> clock_y2k;
};

struct Pd0BottomTrack {
  std::uint16_t pings, delay;
  std::uint8_t correlation_min, evaluation_min, percent_good_min, mode;
  std::uint16_t error_velocity_max_mmps;
  std::array<std::uint32_t, 4> range_cm;  ///< with its high byte
  std::array<std::int16_t, 4> velocity_mmps;
  std::array<std::uint8_t, 4> correlation, evaluation, percent_good;
  std::uint16_t layer_min_dm, layer_near_dm, layer_far_dm;
  std::array<std::int16_t, 4> layer_velocity_mmps;
  std::array<std::uint8_t, 4> layer_correlation, layer_echo, layer_percent_good;
  std::uint16_t max_depth_dm;
  std::array<std::uint8_t, 4> rssi;
  std::uint8_t gain;
};

/// One of the types 0x0100..0x0400, four values a cell; empty when the ensemble lacks it or it is too short.
struct Pd0Profile {
  std::span<const std::uint8_t> values;
  [[nodiscard]] std::int16_t velocity_mmps(std::size_t cell, std::size_t beam) const;
  [[nodiscard]] std::uint8_t count(std::size_t cell, std::size_t beam) const {
    return values[4 * cell + beam];
  }
};

/// Views into the ensemble's bytes: valid as long as they are.
struct Pd0Ensemble {
  std::span<const std::uint8_t> bytes;  ///< without the checksum
  Pd0FixedLeader fixed;
  Pd0VariableLeader variable;
  std::optional<Pd0BottomTrack> bottom;
  std::optional<std::array<std::int32_t, 4>> high_resolution;  ///< 0x5803, 0.01 mm/s
  Pd0Profile velocity, correlation, echo, percent_good;

  [[nodiscard]] std::size_t types() const { return bytes[5]; }
  [[nodiscard]] std::size_t type_offset(std::size_t i) const;
  /// From its id to the next type's, or to the ensemble's end.
  [[nodiscard]] std::span<const std::uint8_t> type(std::size_t i) const;
};

/// Empty when offsets do not increase or lie outside, a known type is shorter than it must be, or a leader is
/// missing. `bytes`: from `7F 7F` up to the checksum, at least its announced length.
[[nodiscard]] std::optional<Pd0Ensemble> read_pd0_ensemble(std::span<const std::uint8_t> bytes);

}  // namespace leadline::decode
