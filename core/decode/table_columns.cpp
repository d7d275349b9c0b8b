#include "core/decode/table_columns.h"

#include <algorithm>
#include <array>
#include <numeric>

#include "core/types/angle.h"

namespace leadline::decode {
namespace {

using Q = Quantity;

constexpr double kGravity = 9.80665;  // what research data mean by g: the standard one, ISO 80000-3
constexpr double kMostGyro = 100.0, kMostAccel = 1000.0, kMostSpeed = 1000.0, kMostSd = 1e6;

constexpr TableColumn kKnown[] = {
    {"-", Q::skip},
    {"unix_s", Q::unix_s},
    {"date", Q::date},
    {"time", Q::time},
    {"valid", Q::valid},
    {"gyro_x_rps", Q::gyro_x, -kMostGyro, kMostGyro},
    {"gyro_y_rps", Q::gyro_y, -kMostGyro, kMostGyro},
    {"gyro_z_rps", Q::gyro_z, -kMostGyro, kMostGyro},
    {"gyro_x_dps", Q::gyro_x, -kMostGyro* kDegPerRad, kMostGyro* kDegPerRad, kRadPerDeg},
    {"gyro_y_dps", Q::gyro_y, -kMostGyro* kDegPerRad, kMostGyro* kDegPerRad, kRadPerDeg},
    {"gyro_z_dps", Q::gyro_z, -kMostGyro* kDegPerRad, kMostGyro* kDegPerRad, kRadPerDeg},
    {"accel_x_mps2", Q::accel_x, -kMostAccel, kMostAccel},
    {"accel_y_mps2", Q::accel_y, -kMostAccel, kMostAccel},
    {"accel_z_mps2", Q::accel_z, -kMostAccel, kMostAccel},
    {"accel_x_g", Q::accel_x, -kMostAccel / kGravity, kMostAccel / kGravity, kGravity},
    {"accel_y_g", Q::accel_y, -kMostAccel / kGravity, kMostAccel / kGravity, kGravity},
    {"accel_z_g", Q::accel_z, -kMostAccel / kGravity, kMostAccel / kGravity, kGravity},
    {"dtheta_x_rad", Q::gyro_x, -kMostGyro, kMostGyro, 1.0, true},
    {"dtheta_y_rad", Q::gyro_y, -kMostGyro, kMostGyro, 1.0, true},
    {"dtheta_z_rad", Q::gyro_z, -kMostGyro, kMostGyro, 1.0, true},
    {"dvel_x_mps", Q::accel_x, -kMostAccel, kMostAccel, 1.0, true},
    {"dvel_y_mps", Q::accel_y, -kMostAccel, kMostAccel, 1.0, true},
    {"dvel_z_mps", Q::accel_z, -kMostAccel, kMostAccel, 1.0, true},
    {"lat_deg", Q::lat, -90, 90},
    {"lon_deg", Q::lon, -180, 360},
    {"ellipsoid_height_m", Q::ellipsoid_height, -12000, 100000},
    {"sd_north_m", Q::sd_north, 0, kMostSd},
    {"sd_east_m", Q::sd_east, 0, kMostSd},
    {"sd_down_m", Q::sd_down, 0, kMostSd},
    {"sd_ellipsoid_height_m", Q::sd_down, 0, kMostSd},
    {"depth_m", Q::depth, -100, 12000},
    {"sd_depth_m", Q::sd_depth, 0, kMostSd},
    {"altitude_above_bottom_m", Q::altitude, 0, 12000},
    {"vel_x_mps", Q::vel_x, -kMostSpeed, kMostSpeed},
    {"vel_y_mps", Q::vel_y, -kMostSpeed, kMostSpeed},
    {"vel_z_mps", Q::vel_z, -kMostSpeed, kMostSpeed},
    {"sd_vel_x_mps", Q::sd_vel_x, 0, kMostSd},
    {"sd_vel_y_mps", Q::sd_vel_y, 0, kMostSd},
    {"sd_vel_z_mps", Q::sd_vel_z, 0, kMostSd},
    {"vel_north_mps", Q::vel_north, -kMostSpeed, kMostSpeed},
    {"vel_east_mps", Q::vel_east, -kMostSpeed, kMostSpeed},
    {"vel_down_mps", Q::vel_down, -kMostSpeed, kMostSpeed},
    {"sd_vel_north_mps", Q::sd_vel_north, 0, kMostSd},
    {"sd_vel_east_mps", Q::sd_vel_east, 0, kMostSd},
    {"sd_vel_down_mps", Q::sd_vel_down, 0, kMostSd},
    {"sd_vel_mps", Q::sd_vel, 0, kMostSd},
    {"heading_deg", Q::heading, -180, 360},
    {"magnetic_heading_deg", Q::magnetic_heading, -180, 360},
    {"sd_heading_deg", Q::sd_heading, 0, kMostSd},
    {"roll_deg", Q::roll, -180, 180},
    {"pitch_deg", Q::pitch, -90, 90},
    {"sd_roll_deg", Q::sd_roll, 0, kMostSd},
    {"sd_pitch_deg", Q::sd_pitch, 0, kMostSd},
    {"rate_z_rps", Q::rate_z, -kMostGyro, kMostGyro},
};

/// A column of the first kind says nothing without one of the others.
struct Need {
  Q column;
  Q one_of[2];
};
constexpr Need kNeeds[] = {
    {Q::gyro_x, {Q::gyro_y, Q::gyro_y}},
    {Q::gyro_y, {Q::gyro_z, Q::gyro_z}},
    {Q::gyro_z, {Q::accel_x, Q::accel_x}},
    {Q::accel_x, {Q::accel_y, Q::accel_y}},
    {Q::accel_y, {Q::accel_z, Q::accel_z}},
    {Q::accel_z, {Q::gyro_x, Q::gyro_x}},
    {Q::lat, {Q::lon, Q::lon}},
    {Q::lon, {Q::lat, Q::lat}},
    {Q::ellipsoid_height, {Q::lat, Q::lat}},
    {Q::sd_north, {Q::lat, Q::lat}},
    {Q::sd_east, {Q::lat, Q::lat}},
    {Q::sd_down, {Q::lat, Q::lat}},
    {Q::sd_depth, {Q::depth, Q::depth}},
    {Q::vel_x, {Q::vel_y, Q::vel_y}},
    {Q::vel_y, {Q::vel_x, Q::vel_x}},
    {Q::vel_z, {Q::vel_x, Q::vel_x}},
    {Q::sd_vel_x, {Q::vel_x, Q::vel_x}},
    {Q::sd_vel_y, {Q::vel_x, Q::vel_x}},
    {Q::sd_vel_z, {Q::vel_x, Q::vel_x}},
    {Q::vel_north, {Q::vel_east, Q::vel_east}},
    {Q::vel_east, {Q::vel_north, Q::vel_north}},
    {Q::vel_down, {Q::vel_north, Q::vel_north}},
    {Q::sd_vel_north, {Q::vel_north, Q::vel_north}},
    {Q::sd_vel_east, {Q::vel_north, Q::vel_north}},
    {Q::sd_vel_down, {Q::vel_north, Q::vel_north}},
    {Q::sd_vel, {Q::vel_x, Q::vel_north}},
    {Q::sd_heading, {Q::heading, Q::magnetic_heading}},
    {Q::roll, {Q::pitch, Q::pitch}},
    {Q::pitch, {Q::roll, Q::roll}},
    {Q::sd_roll, {Q::roll, Q::roll}},
    {Q::sd_pitch, {Q::roll, Q::roll}},
    {Q::date, {Q::time, Q::time}},
    {Q::time, {Q::date, Q::date}},
};

constexpr Q kFacts[] = {Q::gyro_x, Q::lat,       Q::depth,   Q::altitude,
                        Q::vel_x,  Q::vel_north, Q::heading, Q::magnetic_heading,
                        Q::roll,   Q::rate_z};

const TableColumn* find_known(std::string_view name) {
  const auto* const found = std::find_if(std::begin(kKnown), std::end(kKnown),
                                         [&](const TableColumn& c) { return c.name == name; });
  return found == std::end(kKnown) ? nullptr : found;
}

std::optional<TableColumn> find_column(std::string_view name) {
  if (const TableColumn* const known = find_known(name)) return *known;
  if (name.substr(0, 3) != "sd_") return std::nullopt;
  const TableColumn* const field = find_known(name.substr(3));
  if (field == nullptr || field->min == field->max) return std::nullopt;
  return TableColumn{"-", Q::skip};
}

/// Levenshtein's.
std::size_t edits(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = row[0]++;
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t changed = diagonal + (a[i] == b[j] ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({changed, row[j] + 1, row[j + 1] + 1});
    }
  }
  return row.back();
}

std::string_view nearest_known(std::string_view name) {
  const auto* const nearest = std::min_element(
      std::begin(kKnown) + 1, std::end(kKnown),
      [&](const TableColumn& a, const TableColumn& b) { return edits(name, a.name) < edits(name, b.name); });
  return nearest->name;
}

Error columns_error(std::string what, std::string remedy) {
  return {std::move(what), "columns", std::move(remedy)};
}

std::string quoted(std::string_view name) { return "\"" + std::string(name) + "\""; }

std::string name_of(Q quantity, bool increment) {
  const auto* const found = std::find_if(std::begin(kKnown), std::end(kKnown), [&](const TableColumn& c) {
    return c.quantity == quantity && c.increment == increment;
  });
  return quoted(found == std::end(kKnown) ? "" : found->name);
}

Result<void> check(const std::vector<TableColumn>& columns) {
  std::array<const TableColumn*, kQuantities> given{};
  const auto has = [&](Q q) { return given[static_cast<std::size_t>(q)] != nullptr; };
  for (const TableColumn& column : columns) {
    if (column.quantity == Q::skip) continue;
    const TableColumn*& place = given[static_cast<std::size_t>(column.quantity)];
    if (place != nullptr && place->increment != column.increment)
      return columns_error("mix increments and rates: " + quoted(place->name) + " and " + quoted(column.name),
                           "keep one kind and call the others \"-\"");
    if (place != nullptr)
      return columns_error("give the same twice: " + quoted(place->name) + " and " + quoted(column.name),
                           "call one of them \"-\"");
    place = &column;
  }
  if (has(Q::unix_s) && has(Q::date))
    return columns_error("give the time twice: \"unix_s\" and \"date\"", "call one of them \"-\"");
  bool rates = false, increments = false;
  for (Q q = Q::gyro_x; q <= Q::accel_z; q = static_cast<Q>(static_cast<int>(q) + 1))
    if (has(q)) (given[static_cast<std::size_t>(q)]->increment ? increments : rates) = true;
  if (rates && increments)
    return columns_error("mix increments and rates", "keep dtheta and dvel, or gyro and accel");
  for (const Need& need : kNeeds)
    if (has(need.column) && !has(need.one_of[0]) && !has(need.one_of[1]))
      return columns_error(quoted(given[static_cast<std::size_t>(need.column)]->name) + " needs " +
                               name_of(need.one_of[0], increments && need.one_of[0] <= Q::accel_z),
                           "name that column too, or call this one \"-\"");
  if (std::none_of(std::begin(kFacts), std::end(kFacts), has))
    return columns_error("hold nothing measured", "name at least one, for example \"depth_m\"");
  return {};
}

}  // namespace

Result<std::vector<TableColumn>> table_columns(const std::vector<std::string>& names) {
  if (names.empty())
    return columns_error("are missing", "name each column by what it holds, \"-\" to skip it");
  std::vector<TableColumn> columns;
  columns.reserve(names.size());
  for (const std::string& name : names) {
    const auto column = find_column(name);
    if (!column)
      return columns_error("unknown column " + quoted(name),
                           "did you mean " + quoted(nearest_known(name)) + "? \"-\" skips a column");
    columns.push_back(*column);
  }
  if (const auto good = check(columns); !good) return good.error();
  return columns;
}

}  // namespace leadline::decode
