#pragma once

// One moment made by hand whose every sign shows in pixels: heading 071.9, course 3 degrees to starboard of
// it, a sigma ellipse of 3:1 along 030, twelve fixes used and three refused, a USBL line and a target.

#include "core/geo/geodesy.h"
#include "ui/bridge/snapshot.h"

namespace leadline::test {

struct HandMade {
  ui::Snapshot snapshot;
  ui::History history;
};

inline constexpr double kHeading_deg = 71.9;
inline constexpr double kCrab_deg = 3.0;
inline constexpr double kEllipse_deg = 30.0;

/// `vehicle`: where the vehicle is; everything else lies around it. now: its solution's time.
inline HandMade hand_made(Geodetic vehicle, Time now = *parse_iso8601("2026-09-14T14:02:37Z")) {
  using std::chrono::milliseconds;
  using std::chrono::seconds;
  HandMade made;
  ui::Snapshot& s = made.snapshot;
  s.now = now;
  s.dive = "Dive 07 · survey box 3";
  s.file = "dive-07.leadline";

  const auto covariance = [](Solution& solution, double major_m, double minor_m, double azimuth_deg) {
    const double c = cos(Angle::deg(azimuth_deg)), sn = sin(Angle::deg(azimuth_deg));
    const double a = major_m * major_m, b = minor_m * minor_m;
    solution.var_north_m2 = a * c * c + b * sn * sn;
    solution.var_east_m2 = a * sn * sn + b * c * c;
    solution.cov_north_east_m2 = (a - b) * sn * c;
  };
  const auto velocity = [](Solution& solution, double speed_mps, double course_deg) {
    solution.vel_north_mps = speed_mps * cos(Angle::deg(course_deg));
    solution.vel_east_mps = speed_mps * sin(Angle::deg(course_deg));
  };
  const auto feed = [&](const char* source, int age_ms, double period_s) {
    return ui::Feed{source, now - milliseconds(age_ms), period_s};
  };

  ui::BodyState v;
  v.name = "MDV-1";
  v.engine = "fusion";
  v.rate_hz = 10.0;
  v.valid = now - milliseconds(100);
  v.solution.position = vehicle;
  v.solution.depth = Depth{1512.4};
  v.solution.heading = Angle::deg(kHeading_deg);
  v.solution.roll = Angle::deg(0.8);
  v.solution.pitch = Angle::deg(-1.6);
  v.solution.sd_heading = Angle::deg(0.3);
  v.solution.sd_down_m = 0.3;
  velocity(v.solution, 1.42, kHeading_deg + kCrab_deg);
  covariance(v.solution, 30.0, 10.0, kEllipse_deg);
  v.solution.mode = Mode::B;
  v.solution.position_source = PositionSource::usbl;
  v.position = feed("usbl + dvl", 100, 0.1);
  v.heading = feed("ahrs", 100, 0.02);
  v.velocity = feed("dvl", 200, 0.2);
  v.depth = feed("pressure", 200, 0.25);
  v.attitude = feed("ahrs", 100, 0.02);
  v.altitude = ui::BodyState::Altitude{18.6, feed("dvl", 200, 0.2)};
  s.vehicle = v;

  ui::BodyState ship;
  ship.name = "HAEYANG 7";
  ship.engine = "ship";
  ship.rate_hz = 1.0;
  ship.valid = now - milliseconds(200);
  ship.solution.engine = kShipTrack;
  ship.solution.position = geo::displaced(vehicle, -259.0, 331.0);
  ship.solution.heading = Angle::deg(305.0);
  velocity(ship.solution, 0.4, 318.0);
  covariance(ship.solution, 0.7, 0.6, 0.0);
  ship.position = feed("gnss", 200, 1.0);
  ship.heading = feed("gyro", 100, 0.1);
  ship.velocity = feed("gnss", 200, 1.0);
  s.ship = ship;

  ui::TargetState target;
  target.name = "T1";
  target.position = geo::displaced(vehicle, -80.0, 198.0);
  target.var_north_m2 = target.var_east_m2 = 23.0 * 23.0 / 2.0;
  target.feed = feed("sonar", 41'000, 30.0);
  s.targets.push_back(target);

  s.availability = {Mode::B, "USBL and DVL", now - seconds(3597)};
  s.beam = ui::UsblBeam{geo::displaced(vehicle, -2.0, -3.0), feed("usbl", 3'000, 8.0)};
  const auto source = [&](const char* name, const char* decoder, ui::Body body, double rate_hz, int age_ms,
                          double latency_s, double sigma, const char* unit) {
    ui::SourceState state;
    state.name = name;
    state.decoder = decoder;
    state.body = body;
    state.rate_hz = rate_hz;
    state.period_s = 1.0 / rate_hz;
    state.last = now - milliseconds(age_ms);
    state.latency_s = latency_s;
    state.frames = 4'000;
    state.sigma = sigma;
    state.sigma_unit = unit;
    s.sources.push_back(state);
  };
  source("dvl", "trdi-pd0", ui::Body::vehicle, 5.0, 200, 0.041, 0.01, "m/s");
  source("usbl", "nmea0183", ui::Body::vehicle, 0.125, 3'000, 1.1, 5.0, "m");
  s.sources.back().fixes_judged = 8;
  s.sources.back().fixes_refused = 3;
  source("ahrs", "nmea0183", ui::Body::vehicle, 50.0, 100, 0.012, 0.3, "°");
  source("pressure", "nmea0183", ui::Body::vehicle, 4.0, 200, 0.018, 0.3, "m");
  source("gnss", "nmea0183", ui::Body::ship, 1.0, 200, 0.064, 0.9, "m");
  source("gyro", "nmea0183", ui::Body::ship, 10.0, 100, 0.009, 0.2, "°");
  s.alerts.push_back(
      {Alarm::Priority::warning, now - seconds(11), "USBL: 3 of the last 8 fixes refused", "usbl"});

  // The way here: a leg, a turn and the leg that is being run, one point a second; dead reckoning drifts off.
  ui::Track fused{0, "fusion", ui::Body::vehicle, {}}, dr{1, "dead-reckoning", ui::Body::vehicle, {}};
  const double course = (kHeading_deg + kCrab_deg) * kRadPerDeg;
  for (int i = 0; i <= 240; ++i) {
    const double back_m = 1.42 * (240 - i), weave_m = 2.0 * std::sin(i / 15.0);
    const double north = -back_m * std::cos(course) - weave_m * std::sin(course);
    const double east = -back_m * std::sin(course) + weave_m * std::cos(course);
    const Time at = v.valid - seconds(240 - i);
    fused.points.push_back({at, geo::displaced(vehicle, north, east), 0.6F});
    const double drift_m = 6.0 + 0.03 * i;
    dr.points.push_back({at, geo::displaced(vehicle, north - drift_m, east), 8.0F});
  }
  for (int i = 0; i < 15; ++i) {
    const auto& at = fused.points[static_cast<std::size_t>(16 * i + 8)];
    const bool accepted = i != 6 && i != 10 && i != 12;
    const double off_m = accepted ? 3.0 : 36.0;
    ui::FixMark fix;
    fix.valid = at.valid;
    fix.solution = at.position;
    fix.position = geo::displaced(at.position, off_m * std::cos(i * 1.3), off_m * std::sin(i * 1.3));
    fix.accepted = accepted;
    fix.residual_m = off_m;
    fix.gate_m = 15.2;
    fix.source = 1;
    made.history.fixes.push_back(fix);
  }
  made.history.tracks = {fused, dr};
  made.history.modes = {{now - seconds(7200), Mode::D, "USBL without bottom lock"},
                        {now - seconds(3597), Mode::B, "USBL and DVL"}};
  made.history.events = {{now - seconds(11), now - seconds(11), ui::EventMark::Kind::warning,
                          "USBL: 3 of the last 8 fixes refused"}};
  made.history.first = now - seconds(7200);
  made.history.last = now;
  made.history.complete = true;
  return made;
}

}  // namespace leadline::test
