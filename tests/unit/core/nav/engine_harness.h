#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <vector>

#include "core/geo/geodesy.h"
#include "core/nav/engines/registry.h"

namespace leadline::nav {

/// Feeds one engine by hand and keeps what it says.
class EngineHarness final : EngineOutput {
 public:
  EngineHarness(const std::string& name, const Options& options, std::vector<SourceInfo> sources,
                Body body = Body::vehicle)
      : sources_(std::move(sources)) {
    for (std::size_t i = 0; i < sources_.size(); ++i) sources_[i].id = static_cast<SourceId>(i);
    engine_ = make_engine(name, {.body = body, .options = options, .sources = sources_}).value();
  }

  void tell(double t_s, const Message& message, SourceId source = 0) { tell_late(t_s, t_s, message, source); }
  /// Heard at t_s, true at valid_s.
  void tell_late(double t_s, double valid_s, const Message& message, SourceId source = 0) {
    const Time t = at(t_s);
    for (; next_tick_s_ <= t_s; next_tick_s_ += 0.1) {
      const Arrival tick = arrival_at(at(next_tick_s_));
      engine_->take({.valid = tick.host(), .arrival = tick, .message = Tick{tick}}, *this);
    }
    engine_->take({.valid = at(valid_s), .arrival = arrival_at(t), .source = source, .message = message},
                  *this);
  }
  void wait_until(double t_s) { tell(t_s, Pressure{}, kNoSource); }

  static Time at(double s) { return from_unix(1'700'000'000.0 + s); }
  static Geodetic place(double north_m, double east_m) {
    return geo::displaced({Angle::deg(59.0), Angle::deg(5.0)}, north_m, east_m);
  }

  struct Row {
    double t_s, north_m, east_m;
    Solution solution;
  };
  std::vector<Row> rows;
  std::vector<FixVerdict> verdicts;
  std::vector<ModeChange> changes;
  std::vector<Health> health;
  [[nodiscard]] Mode mode() const { return changes.empty() ? Mode::E0 : changes.back().to; }

 private:
  void publish(Time valid, const Message& message, SourceId) override {
    if (const auto* s = std::get_if<Solution>(&message)) {
      const auto off = geo::difference(place(0, 0), s->position);
      rows.push_back({seconds(valid - at(0)), off.north_m, off.east_m, *s});
    } else if (const auto* v = std::get_if<FixVerdict>(&message)) {
      verdicts.push_back(*v);
    } else if (const auto* c = std::get_if<ModeChange>(&message)) {
      changes.push_back(*c);
    } else if (const auto* h = std::get_if<Health>(&message)) {
      health.push_back(*h);
    }
  }

  std::vector<SourceInfo> sources_;
  std::unique_ptr<Engine> engine_;
  double next_tick_s_ = 0.1;
};

inline GnssFix gnss_at(double north_m, double east_m) {
  return {.position = EngineHarness::place(north_m, east_m), .quality = GnssQuality::autonomous};
}
inline DvlVelocity ahead(double speed_mps, bool lock = true) {
  return {.frame = DvlFrame::ship, .x_mps = speed_mps, .valid = lock};
}
inline Heading heading_deg(double deg) { return {.heading = Angle::deg(deg)}; }

}  // namespace leadline::nav
