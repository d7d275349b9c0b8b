#include "core/sim/truth/route.h"

#include <fmt/format.h>

#include <array>
#include <cmath>

namespace leadline::sim {
namespace {

/// Walks the legs as the body would and notes what cannot be.
class Checker {
 public:
  Checker(const Route& route, const Water& water)
      : body_(route.body),
        water_(water),
        north_m_(body_.north_m),
        east_m_(body_.east_m),
        depth_m_(body_.depth_m),
        speed_mps_(body_.speed_mps) {}

  void body() {
    check_speed({}, body_.speed_mps);
    check_seabed({}, body_.depth_m);
  }

  void leg(std::size_t i, const LegOptions& leg) {
    const bool waypoint = leg.north_m || leg.east_m;
    if (leg.north_m.has_value() != leg.east_m.has_value())
      note(i, leg.north_m ? "north_m" : "east_m", "a waypoint needs both north_m and east_m");
    if (waypoint && leg.heading_deg) note(i, "heading_deg", "stands beside a waypoint; give one of them");
    if (!waypoint && !leg.distance_m && !leg.duration_s)
      note(i, "", "has no end: give distance_m, duration_s or a waypoint");
    speed_mps_ = leg.speed_mps.value_or(speed_mps_);
    check_speed(i, speed_mps_);
    const double length_m = waypoint ? std::hypot(leg.north_m.value_or(north_m_) - north_m_,
                                                  leg.east_m.value_or(east_m_) - east_m_)
                                     : leg.distance_m.value_or(0.0);
    if (waypoint && !body_.over_ground && water_.strongest_mps(depth_m_) >= speed_mps_)
      note(i, "speed_mps",
           fmt::format("{} m/s cannot reach a waypoint against a current of up to {:.3g} m/s", speed_mps_,
                       water_.strongest_mps(depth_m_)));
    if ((waypoint || leg.distance_m) && speed_mps_ <= 0.0)
      note(i, "speed_mps", "is 0: the leg would never end; give it a duration_s");
    else
      check_dive(i, leg, length_m);
    if (waypoint) north_m_ = leg.north_m.value_or(0.0), east_m_ = leg.east_m.value_or(0.0);
  }

  std::vector<RouteProblem> problems;

 private:
  void note(std::optional<std::size_t> leg, std::string key, std::string text) {
    problems.push_back({leg, std::move(key), std::move(text)});
  }

  void check_speed(std::optional<std::size_t> leg, double speed_mps) {
    const double fastest = speed_mps * (1.0 + body_.speed_variation);
    if (fastest > body_.max_speed_mps * (1.0 + 1e-9))
      note(leg, "speed_mps",
           fmt::format("impossible route: {:.4g} m/s is faster than the body's max_speed_mps of {} m/s",
                       fastest, body_.max_speed_mps));
  }

  void check_seabed(std::optional<std::size_t> leg, double depth_m) {
    const double bottom = water_.seabed_m(north_m_, east_m_);
    if (depth_m > bottom)
      note(leg, "depth_m",
           fmt::format("impossible route: {} m is below the seabed at {:.1f} m", depth_m, bottom));
  }

  void check_dive(std::size_t i, const LegOptions& leg, double length_m) {
    if (!leg.depth_m) return;
    check_seabed(i, *leg.depth_m);
    const double time_s = leg.duration_s.value_or(speed_mps_ > 0.0 ? length_m / speed_mps_ : 0.0);
    const double needed_mps = time_s > 0.0 ? std::abs(*leg.depth_m - depth_m_) / time_s : 0.0;
    if (needed_mps > body_.max_vertical_mps)
      note(i, "depth_m",
           fmt::format("impossible route: {:.3g} m/s down or up is faster than max_vertical_mps of {} m/s",
                       needed_mps, body_.max_vertical_mps));
    depth_m_ = *leg.depth_m;
  }

  const BodyOptions& body_;
  const Water& water_;
  double north_m_, east_m_, depth_m_, speed_mps_;
};

}  // namespace

std::vector<RouteProblem> check_route(const Route& route, const Water& water) {
  Checker checker(route, water);
  checker.body();
  for (std::size_t i = 0; i < route.legs.size(); ++i) checker.leg(i, route.legs[i]);
  return std::move(checker.problems);
}

std::span<const Key<BodyOptions>> body_keys() {
  using O = BodyOptions;
  static const std::array<Key<O>, 28> keys{{
      {"north_m", &O::north_m, "start, from the origin", -1e6, 1e6},
      {"east_m", &O::east_m, "start, from the origin", -1e6, 1e6},
      {"depth_m", &O::depth_m, "start, down from the surface", -100, 12000},
      {"heading_deg", &O::heading_deg, "at the start, clockwise from true north", -360, 360},
      {"speed_mps", &O::speed_mps, "at the start, ahead", 0, 100},
      {"over_ground", &O::over_ground, "speeds are over the ground: the current does not move it"},
      {"repeat", &O::repeat, "how often the legs are run; 0: until the end", 0, 1e6},
      {"max_speed_mps", &O::max_speed_mps, "as fast as it is", 0, 100},
      {"acceleration_mps2", &O::acceleration_mps2, "at most, ahead or astern", 1e-4, 100},
      {"speed_time_constant_s", &O::speed_time_constant_s, "first-order response of the speed; 0: at once", 0,
       1000},
      {"turn_rate_dps", &O::turn_rate_dps, "at most", 1e-3, 360},
      {"yaw_time_constant_s", &O::yaw_time_constant_s, "response of the heading, critically damped", 0.05,
       1000},
      {"max_vertical_mps", &O::max_vertical_mps, "diving or climbing at most", 0, 100},
      {"depth_time_constant_s", &O::depth_time_constant_s, "response of the depth, critically damped", 0.05,
       1000},
      {"speed_variation", &O::speed_variation, "share of the speed that comes and goes", 0, 1},
      {"speed_period_s", &O::speed_period_s, "of that", 0.1, 1e6},
      {"weave_deg", &O::weave_deg, "amplitude of the heading about its course", 0, 90},
      {"weave_period_s", &O::weave_period_s, "of that", 0.1, 1e6},
      {"roll_mean_deg", &O::roll_mean_deg, "starboard down positive", -80, 80},
      {"roll_deg", &O::roll_deg, "amplitude", 0, 80},
      {"roll_period_s", &O::roll_period_s, "of that", 0.1, 1e6},
      {"pitch_mean_deg", &O::pitch_mean_deg, "bow up positive", -80, 80},
      {"pitch_deg", &O::pitch_deg, "amplitude", 0, 80},
      {"pitch_period_s", &O::pitch_period_s, "of that", 0.1, 1e6},
      {"heave_m", &O::heave_m, "amplitude", 0, 30},
      {"heave_period_s", &O::heave_period_s, "of that", 0.1, 1e6},
      {"sway_mps", &O::sway_mps, "amplitude of the velocity to starboard", 0, 10},
      {"sway_period_s", &O::sway_period_s, "of that", 0.1, 1e6},
  }};
  return keys;
}

std::span<const Key<LegOptions>> leg_keys() {
  using O = LegOptions;
  static const std::array<Key<O>, 10> keys{{
      {"name", &O::name, "for the reader"},
      {"heading_deg", &O::heading_deg, "the course to steer; left out: as before", -360, 360},
      {"north_m", &O::north_m, "a waypoint, from the origin", -1e6, 1e6},
      {"east_m", &O::east_m, "a waypoint, from the origin", -1e6, 1e6},
      {"within_m", &O::within_m, "how near to the waypoint is there", 0.01, 1e4},
      {"distance_m", &O::distance_m, "run ahead until the leg ends", 0, 1e7},
      {"duration_s", &O::duration_s, "until the leg ends", 0, 1e7},
      {"speed_mps", &O::speed_mps, "ahead; left out: as before", 0, 100},
      {"depth_m", &O::depth_m, "to dive to; left out: as before", -100, 12000},
      {"acceleration_mps2", &O::acceleration_mps2, "on this leg instead of the body's", 1e-4, 100},
  }};
  return keys;
}

}  // namespace leadline::sim
