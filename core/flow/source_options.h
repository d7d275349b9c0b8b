#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/types/option_key.h"

namespace leadline {

/// One [[source]] of the configuration: the keys every decoder shares. Angles in degrees as in the file.
struct SourceOptions {
  std::string name;
  std::string link;
  std::string decoder;
  std::string body = "vehicle";
  std::string checksum = "required";
  std::string heading = "true";
  std::optional<double> declination_deg;
  std::string time_scale = "utc";
  double time_offset_s = 0.0;
  double latency_s = 0.0;
  double rate_hz = 0.0;
  std::string date;
  std::string address;
};
[[nodiscard]] std::span<const Key<SourceOptions>> source_keys();

/// `mount` of a [[source]]: v_b = Rz(yaw) Ry(pitch) Rx(roll) v_s, position in body axes from the reference
/// point.
struct MountOptions {
  double roll_deg = 0.0, pitch_deg = 0.0, yaw_deg = 0.0;
  double x_m = 0.0, y_m = 0.0, z_m = 0.0;
};
[[nodiscard]] std::span<const Key<MountOptions>> mount_keys();

/// One [[calibration]]: angles added to the mount, scale = reference distance over DVL distance.
struct CalibrationOptions {
  std::string source;
  double yaw_deg = 0.0, roll_deg = 0.0, pitch_deg = 0.0;
  double scale = 1.0;
};
[[nodiscard]] std::span<const Key<CalibrationOptions>> calibration_keys();

/// One [[output]]: sentences repeated to other instruments while the program runs live.
struct OutputOptions {
  std::string name;
  std::string link;
  std::string format = "nmea0183";
  std::string sfi = "IN0001";
  std::string destination;
  std::vector<std::string> sentences;
  double rate_hz = 1.0;
  std::string body = "vehicle";
};
[[nodiscard]] std::span<const Key<OutputOptions>> output_keys();

}  // namespace leadline
