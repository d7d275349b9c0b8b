#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/types/result.h"

namespace leadline::decode {

/// The quantity a table's column holds, whatever its unit.
enum class Quantity : std::uint8_t {
  skip,
  unix_s,
  date,
  time,
  valid,
  gyro_x,
  gyro_y,
  gyro_z,
  accel_x,
  accel_y,
  accel_z,
  lat,
  lon,
  ellipsoid_height,
  sd_north,
  sd_east,
  sd_down,
  depth,
  sd_depth,
  altitude,
  vel_x,
  vel_y,
  vel_z,
  sd_vel_x,
  sd_vel_y,
  sd_vel_z,
  vel_north,
  vel_east,
  vel_down,
  sd_vel_north,
  sd_vel_east,
  sd_vel_down,
  sd_vel,
  heading,
  magnetic_heading,
  sd_heading,
  roll,
  pitch,
  sd_roll,
  sd_pitch,
  rate_z,
  count
};
inline constexpr std::size_t kQuantities = static_cast<std::size_t>(Quantity::count);

/// A column by name. Values outside [min, max], in the column's unit, are refused; `scale` takes the unit to
/// SI, save that angles of attitude and position stay in degrees.
struct TableColumn {
  std::string_view name;
  Quantity quantity = Quantity::skip;
  double min = 0.0, max = 0.0;
  double scale = 1.0;
  bool increment = false;
};

/// The columns of a configuration, checked. sd_<field> of a field whose fact has no place for it is skipped.
/// Error: see make_table.
[[nodiscard]] Result<std::vector<TableColumn>> table_columns(const std::vector<std::string>& names);

}  // namespace leadline::decode
