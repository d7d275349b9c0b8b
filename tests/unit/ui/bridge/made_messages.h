#pragma once

// A small dive to know by heart, as a Bus would number it.

#include <vector>

#include "ui/bridge/console_setup.h"

namespace leadline::test {

inline constexpr std::int64_t kDiveNs = 1'790'000'000'000'000'000;  // 2026-09-21

enum DiveSource : SourceId { kDvl, kCompass, kSpareCompass, kPress, kUsbl, kGps, kTargetUsbl };

inline ui::ConsoleSetup dive_setup() {
  ui::ConsoleSetup setup;
  setup.vehicle = "MDV-1", setup.ship = "HAEYANG 7";
  setup.engines = {"fusion", "dead-reckoning"};
  setup.sources = {{"dvl", "trdi-pd6", ui::Body::vehicle},   {"ahrs", "nmea0183", ui::Body::vehicle},
                   {"spare", "nmea0183", ui::Body::vehicle}, {"press", "paroscientific", ui::Body::vehicle},
                   {"usbl", "nmea0183", ui::Body::vehicle},  {"gnss", "nmea0183", ui::Body::ship},
                   {"beacon", "nmea0183", ui::Body::target}};
  setup.dive = "Dive 07", setup.file = "dive-07.leadline";
  return setup;
}

inline Geodetic near_busan(double north_m, double east_m) {
  return {Angle::deg(36.91 + north_m / 110'950.0), Angle::deg(129.905 + east_m / 89'140.0)};
}

/// Messages with ever growing numbers and arrivals.
class Dive {
 public:
  std::vector<Envelope> messages;

  [[nodiscard]] double now_s() const { return now_s_; }
  void go_to(double s) { now_s_ = s; }
  Envelope& say(SourceId source, const Message& message, double latency_s = 0.0) {
    Envelope e;
    e.seq = ++seq_;
    e.raw = source == kNoSource ? 0 : raw_;
    e.arrival = Arrival{kDiveNs} + duration(now_s_);
    e.valid = e.arrival.host() - duration(latency_s);
    e.wall_utc = e.arrival.host();
    e.source = source;
    e.message = message;
    messages.push_back(e);
    return messages.back();
  }
  void frame(SourceId source) { raw_ = say(source, RawFrame{}).seq; }
  /// A frame and its fact.
  void heard(SourceId source, const Message& message, double latency_s = 0.0) {
    frame(source);
    say(source, message, latency_s);
  }
  void solution(EngineId engine, double north_m, double east_m, Mode mode = Mode::B) {
    Solution s;
    s.engine = engine;
    s.position = near_busan(north_m, east_m);
    s.depth = Depth{1512.43};
    s.roll = Angle::deg(0.8), s.pitch = Angle::deg(-1.6), s.heading = Angle::deg(71.9);
    s.vel_north_mps = 0.37, s.vel_east_mps = 1.371;
    s.var_north_m2 = 0.2, s.var_east_m2 = 0.16;
    s.sd_down_m = 0.3, s.sd_heading = Angle::deg(0.3);
    if (engine != kShipTrack) s.mode = mode;
    say(kNoSource, s, 0.05);
  }

  /// From second `from` to before `until`: DVL 5 Hz, compass 10 Hz (the spare 1 Hz), pressure 4 Hz, USBL each
  /// 8 s, the ship's GNSS and track 1 Hz, the beacon each 15 s, both engines at each ping.
  void sail(double from, double until) {
    for (int tick = static_cast<int>(from * 20); tick < static_cast<int>(until * 20); ++tick) {
      now_s_ = tick / 20.0;
      if (tick % 2 == 0) heard(kCompass, Heading{Angle::deg(71.9), {}, {}, Angle::deg(0.2)}, 0.012);
      if (tick % 2 == 0) say(kCompass, Attitude{Angle::deg(0.8), Angle::deg(-1.6)}, 0.012);
      if (tick % 20 == 3 && spare) heard(kSpareCompass, Heading{Angle::deg(72.4)});
      if (tick % 5 == 1) heard(kPress, DepthMeasured{Depth{1512.4}, 0.3}, 0.018);
      if (tick % 20 == 7) {
        heard(kGps, GnssFix{near_busan(-340.0, 250.0), {}, GnssQuality::differential, 11, 0.9, 0.6, 0.6, 1.2},
              0.064);
        solution(kShipTrack, -340.0, 250.0);
      }
      if (tick % 160 == 33) {
        heard(kUsbl, UsblRelative{"B07", UsblAxes::head_up, 200.0, -300.0, 1512.0, 5.0}, 1.1);
        FixVerdict verdict;
        verdict.position = near_busan(now_s_, 2.0);
        verdict.residual_m = tick % 480 == 193 ? 36.0 : 3.0, verdict.gate_m = 15.2;
        verdict.accepted = tick % 480 != 193;
        say(kUsbl, verdict, 1.1);
        verdict.engine = 1, verdict.accepted.reset();
        say(kUsbl, verdict, 1.1);
      }
      if (tick % 300 == 45) {
        heard(kTargetUsbl, UsblRelative{"B09", UsblAxes::head_up, 10.0, 20.0, 1500.0, 23.0}, 1.0);
        FixVerdict verdict;
        verdict.position = near_busan(-80.0, 200.0), verdict.depth = Depth{1520.0};
        say(kTargetUsbl, verdict, 1.0);
      }
      if (tick % 4 == 2) {
        heard(kDvl,
              DvlVelocity{DvlReference::bottom, DvlFrame::instrument, false, 1.42, 0.0, 0.0, true, 0.01},
              0.041);
        say(kDvl, BeamRanges{{20.0, 20.1, 19.9, 20.0}, Angle::deg(30.0)}, 0.041);
        say(kDvl, AltitudeAboveBottom{18.6}, 0.041);
        solution(0, now_s_, 1.4 * now_s_);
        solution(1, now_s_ + 3.0, 1.4 * now_s_);
      }
    }
    now_s_ = until;
  }
  bool spare = true;  ///< the second compass speaks

 private:
  double now_s_ = 0.0;
  std::uint64_t seq_ = 0, raw_ = 0;
};

}  // namespace leadline::test
