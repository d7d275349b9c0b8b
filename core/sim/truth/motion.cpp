#include "core/sim/truth/motion.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "core/geo/geodesy.h"
#include "core/sim/truth/earth.h"

namespace leadline::sim {
namespace {

struct Wave {
  double value, rate, acceleration;
};
Wave wave(double amplitude, double period_s, double t_s) {
  if (amplitude == 0.0) return {0.0, 0.0, 0.0};
  const double w = 2.0 * kPi / period_s, s = amplitude * std::sin(w * t_s), c = amplitude * std::cos(w * t_s);
  return {s, w * c, -w * w * s};
}

/// The share of a difference that a first-order response makes up in a step.
double made_up(double step_s, double time_constant_s) {
  return time_constant_s > 0.0 ? 1.0 - std::exp(-step_s / time_constant_s) : 1.0;
}

/// Acceleration of a critically damped response to `error` with limited rate: (s + 2/T)^2, in two stages.
double damped(double error, double rate, double time_constant_s, double most_rate, double step_s) {
  const double wanted = std::clamp(error / time_constant_s, -most_rate, most_rate);
  return (wanted - rate) * made_up(step_s, 0.25 * time_constant_s) / step_s;
}

}  // namespace

Motion::Motion(const Route& route, const Water& water, Geodetic origin, double step_s)
    : route_(route), water_(water), origin_(origin), step_s_(step_s) {
  const BodyOptions& body = route_.body;
  const Geodetic from = geo::displaced(origin, body.north_m, body.east_m);
  end_ = {
      0.0, from.lat.rad(), from.lon.rad(), body.depth_m, 0.0, body.speed_mps, body.heading_deg * kRadPerDeg,
      0.0};
  wanted_ = {body.speed_mps, end_.heading, body.depth_m, body.acceleration_mps2};
  done_ = route_.legs.empty();
  if (done_) wanted_.speed_mps = body.speed_mps;
  steps_ = -1;
  step();
}

bool Motion::leg_done(const LegOptions& leg) const {
  constexpr double kTime_s = 1e-9;
  if (leg.duration_s && start_.t_s - leg_from_s_ >= *leg.duration_s - kTime_s) return true;
  if (leg.distance_m && leg_run_m_ >= *leg.distance_m) return true;
  if (!leg.north_m || !leg.east_m) return false;
  const auto here = geo::difference(origin_, {Angle::rad(start_.lat), Angle::rad(start_.lon)});
  return std::hypot(*leg.north_m - here.north_m, *leg.east_m - here.east_m) <= leg.within_m;
}

void Motion::next_leg() {
  leg_from_s_ = start_.t_s;
  leg_run_m_ = 0.0;
  if (++leg_ < route_.legs.size()) return;
  leg_ = 0;
  if (++rounds_ != route_.body.repeat) return;
  done_ = true;
  wanted_.speed_mps = 0.0;
}

double Motion::heading_to(const LegOptions& leg, double speed_mps) const {
  const auto here = geo::difference(origin_, {Angle::rad(start_.lat), Angle::rad(start_.lon)});
  const double bearing = std::atan2(*leg.east_m - here.east_m, *leg.north_m - here.north_m);
  if (route_.body.over_ground || speed_mps <= 0.0) return bearing;
  const Eigen::Vector2d current = water_.current(start_.t_s, start_.depth_m);
  const double across = -current.x() * std::sin(bearing) + current.y() * std::cos(bearing);
  return bearing - std::asin(std::clamp(across / speed_mps, -0.99, 0.99));
}

void Motion::plan() {
  const BodyOptions& body = route_.body;
  for (std::size_t passed = 0; !done_ && passed <= route_.legs.size() && leg_done(route_.legs[leg_]);
       ++passed)
    next_leg();
  if (!done_) {
    const LegOptions& leg = route_.legs[leg_];
    wanted_.speed_mps = leg.speed_mps.value_or(wanted_.speed_mps);
    wanted_.depth_m = leg.depth_m.value_or(wanted_.depth_m);
    wanted_.acceleration_mps2 = leg.acceleration_mps2.value_or(body.acceleration_mps2);
    if (leg.north_m && leg.east_m)
      wanted_.heading = heading_to(leg, wanted_.speed_mps);
    else if (leg.heading_deg)
      wanted_.heading = *leg.heading_deg * kRadPerDeg;
  }
  const double faster =
      (wanted_.speed_mps - start_.speed_mps) * made_up(step_s_, body.speed_time_constant_s) / step_s_;
  speed_change_ = std::clamp(faster, -wanted_.acceleration_mps2, wanted_.acceleration_mps2);
  const double turn = Angle::rad(wanted_.heading - start_.heading).wrapped_pi().rad();
  turn_change_ =
      damped(turn, start_.turn_rps, body.yaw_time_constant_s, body.turn_rate_dps * kRadPerDeg, step_s_);
  down_change_ = damped(wanted_.depth_m - start_.depth_m, start_.down_mps, body.depth_time_constant_s,
                        body.max_vertical_mps, step_s_);
}

void Motion::step() {
  if (steps_ >= 0) {
    const Wave surge = wave(route_.body.speed_variation, route_.body.speed_period_s, start_.t_s);
    leg_run_m_ += 0.5 * (start_.speed_mps + end_.speed_mps) * (1.0 + surge.value) * step_s_;
  }
  start_ = end_;
  ++steps_;
  plan();
  end_ = state(step_s_);
  end_.t_s = static_cast<double>(steps_ + 1) * step_s_;
}

Motion::State Motion::state(double s) const {
  State e = start_;
  e.t_s += s;
  e.speed_mps += speed_change_ * s;
  e.heading += (start_.turn_rps + 0.5 * turn_change_ * s) * s;
  e.turn_rps += turn_change_ * s;
  e.depth_m += (start_.down_mps + 0.5 * down_change_ * s) * s;
  e.down_mps += down_change_ * s;
  const auto [lat, lon] = place(s);
  e.lat = lat, e.lon = lon;
  return e;
}

Motion::Kinematics Motion::kinematics(double s) const {
  const BodyOptions& body = route_.body;
  const double t = start_.t_s + s;
  const Wave surge = wave(body.speed_variation, body.speed_period_s, t);
  const Wave weave = wave(body.weave_deg * kRadPerDeg, body.weave_period_s, t);
  const Wave roll = wave(body.roll_deg * kRadPerDeg, body.roll_period_s, t);
  const Wave pitch = wave(body.pitch_deg * kRadPerDeg, body.pitch_period_s, t);
  const Wave heave = wave(body.heave_m, body.heave_period_s, t);
  const Wave sway = wave(body.sway_mps, body.sway_period_s, t);

  Kinematics k;
  k.euler = {body.roll_mean_deg * kRadPerDeg + roll.value, body.pitch_mean_deg * kRadPerDeg + pitch.value,
             start_.heading + (start_.turn_rps + 0.5 * turn_change_ * s) * s + weave.value};
  k.rate = {roll.rate, pitch.rate, start_.turn_rps + turn_change_ * s + weave.rate};
  k.acceleration = {roll.acceleration, pitch.acceleration, turn_change_ + weave.acceleration};

  const double base = start_.speed_mps + speed_change_ * s;
  const double u = base * (1.0 + surge.value),
               u_change = speed_change_ * (1.0 + surge.value) + base * surge.rate;
  const double cp = std::cos(k.euler.z()), sp = std::sin(k.euler.z()), turn = k.rate.z();
  const double down = start_.down_mps + down_change_ * s + heave.rate;
  k.depth_m = start_.depth_m + (start_.down_mps + 0.5 * down_change_ * s) * s + heave.value;
  k.v_n = {u * cp - sway.value * sp, u * sp + sway.value * cp, down};
  k.a_n = {u_change * cp - sway.rate * sp - turn * k.v_n.y(),
           u_change * sp + sway.rate * cp + turn * k.v_n.x(), down_change_ + heave.acceleration};
  k.current_ne = water_.current(t, k.depth_m);
  if (!body.over_ground) {
    k.v_n.head<2>() += k.current_ne;
    k.a_n.head<2>() += water_.current_change(t, down);
  }
  return k;
}

/// Latitude and longitude, rad, by Runge-Kutta's rule: far below a nanometre in a step of 50 ms.
std::pair<double, double> Motion::place(double s) const {
  if (s == 0.0) return {start_.lat, start_.lon};
  const auto rates = [](const Kinematics& k, double lat) {
    const geo::Radii r = geo::radii(Angle::rad(lat));
    return Eigen::Vector2d(k.v_n.x() / (r.meridian_m - k.depth_m),
                           k.v_n.y() / ((r.prime_vertical_m - k.depth_m) * std::cos(lat)));
  };
  const Kinematics middle = kinematics(0.5 * s);
  const Eigen::Vector2d k1 = rates(kinematics(0.0), start_.lat);
  const Eigen::Vector2d k2 = rates(middle, start_.lat + 0.5 * s * k1.x());
  const Eigen::Vector2d k3 = rates(middle, start_.lat + 0.5 * s * k2.x());
  const Eigen::Vector2d k4 = rates(kinematics(s), start_.lat + s * k3.x());
  const Eigen::Vector2d moved = s / 6.0 * (k1 + 2.0 * k2 + 2.0 * k3 + k4);
  return {start_.lat + moved.x(), start_.lon + moved.y()};
}

/// All of a truth that follows from the motion at a latitude; the place and the water are left to the caller.
Truth Motion::sensed(const Kinematics& k, double lat) {
  Truth truth;
  truth.depth_m = k.depth_m;
  truth.v_n = k.v_n, truth.a_n = k.a_n;
  truth.attitude = {Angle::rad(k.euler.x()), Angle::rad(k.euler.y()), Angle::rad(k.euler.z()).wrapped_2pi()};
  truth.C_nb = Rotation<Ned, BodyFrame>::zyx(truth.attitude).matrix();

  const double sf = std::sin(k.euler.x()), cf = std::cos(k.euler.x());
  const double st = std::sin(k.euler.y()), ct = std::cos(k.euler.y());
  const double df = k.rate.x(), dt = k.rate.y(), dp = k.rate.z();
  const double ddf = k.acceleration.x(), ddt = k.acceleration.y(), ddp = k.acceleration.z();
  truth.w_nb_b = {df - dp * st, dt * cf + dp * ct * sf, dp * ct * cf - dt * sf};
  truth.alpha_nb_b = {ddf - ddp * st - dp * ct * dt,
                      ddt * cf - dt * sf * df + ddp * ct * sf - dp * st * dt * sf + dp * ct * cf * df,
                      ddp * ct * cf - dp * st * dt * cf - dp * ct * sf * df - ddt * sf - dt * cf * df};

  const EarthAt earth = earth_at(lat, -k.depth_m);
  const Eigen::Vector3d w_en = transport_rate(earth, lat, k.v_n);
  truth.w_ib_b = truth.w_nb_b + truth.C_nb.transpose() * (earth.w_ie_n + w_en);
  truth.f_b = truth.C_nb.transpose() * (k.a_n + (2.0 * earth.w_ie_n + w_en).cross(k.v_n) - earth.g_n);
  return truth;
}

Truth Motion::at(double t_s) const {
  const double s = t_s - start_.t_s;
  LL_EXPECT(s > -1e-6 && s < step_s_ + 1e-6);
  const Kinematics k = kinematics(s);
  const auto [lat, lon] = s == step_s_ ? std::pair(end_.lat, end_.lon) : place(s);
  Truth truth = sensed(k, lat);
  truth.t_s = t_s;
  truth.position = {Angle::rad(lat), geo::normal_longitude(Angle::rad(lon))};
  truth.current_ne = k.current_ne;
  const auto from_origin = geo::difference(origin_, truth.position);
  truth.seabed_m = water_.seabed_m(from_origin.north_m, from_origin.east_m);
  return truth;
}

Truth Motion::inertial_at(double t_s) const {
  const double s = t_s - start_.t_s;
  LL_EXPECT(s > -1e-6 && s < step_s_ + 1e-6);
  const double lat = start_.lat + (end_.lat - start_.lat) * (s / step_s_);
  Truth truth = sensed(kinematics(s), lat);
  truth.t_s = t_s;
  truth.position = {Angle::rad(lat), Angle::rad(start_.lon)};
  return truth;
}

}  // namespace leadline::sim
