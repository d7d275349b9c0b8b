#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/sim/truth/water.h"
#include "core/types/option_key.h"

namespace leadline::sim {

/// [vehicle], [ship] or [target]: where a body starts, what it can do, and how it moves about its course.
struct BodyOptions {
  double north_m = 0.0, east_m = 0.0, depth_m = 0.0;
  double heading_deg = 0.0, speed_mps = 0.0;
  bool over_ground = false;
  std::int64_t repeat = 1;

  double max_speed_mps = 3.0, acceleration_mps2 = 0.2, speed_time_constant_s = 2.0;
  double turn_rate_dps = 6.0, yaw_time_constant_s = 1.0;
  double max_vertical_mps = 0.5, depth_time_constant_s = 4.0;

  double speed_variation = 0.0, speed_period_s = 200.0;
  double weave_deg = 0.0, weave_period_s = 40.0;
  double roll_mean_deg = 0.0, roll_deg = 0.0, roll_period_s = 11.0;
  double pitch_mean_deg = 0.0, pitch_deg = 0.0, pitch_period_s = 13.0;
  double heave_m = 0.0, heave_period_s = 8.0;
  double sway_mps = 0.0, sway_period_s = 70.0;
};
[[nodiscard]] std::span<const Key<BodyOptions>> body_keys();

/// One [[vehicle.leg]]: a course (heading_deg) for a distance or a time, or a waypoint (north_m, east_m).
struct LegOptions {
  std::string name;
  std::optional<double> heading_deg, north_m, east_m, distance_m, duration_s;
  std::optional<double> speed_mps, depth_m, acceleration_mps2;
  double within_m = 2.0;
};
[[nodiscard]] std::span<const Key<LegOptions>> leg_keys();

struct Route {
  BodyOptions body;
  std::vector<LegOptions> legs;
};

/// What cannot be: in a leg, counted from 0, or in the body's own table.
struct RouteProblem {
  std::optional<std::size_t> leg;
  std::string key, text;
};
/// Faster than the body, steeper than it dives, against a current it cannot stem, below the seabed, or a leg
/// without an end.
[[nodiscard]] std::vector<RouteProblem> check_route(const Route& route, const Water& water);

}  // namespace leadline::sim
