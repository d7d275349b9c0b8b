#pragma once

#include <gtest/gtest.h>

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "app/scenario_file.h"
#include "core/decode/registry.h"
#include "core/flow/bus.h"
#include "core/nav/plausibility/plausibility_watch.h"
#include "core/sim/simulation.h"
#include "core/sim/telegrams/table_writer.h"
#include "tests/support/files.h"

namespace leadline::test {

/// What one run's instruments said, decoded: facts and Ticks in the Bus's order.
struct Heard {
  std::vector<SourceInfo> sources;
  std::vector<Envelope> envelopes;
  [[nodiscard]] SourceId source(const std::string& name) const {
    for (const auto& s : sources)
      if (s.name == name) return s.id;
    ADD_FAILURE() << "no source " << name;
    return 0;
  }
  [[nodiscard]] Arrival begin() const { return envelopes.front().arrival; }
};

struct Finding {
  double t_s;  ///< since the first thing heard
  std::string source;
  Health::Level level;
  std::string text;
};

using Tamper = std::function<void(Envelope&, double t_s)>;

/// One watch over a run, with what a fault makes of each fact.
class Watched final : EngineOutput {
 public:
  explicit Watched(const Heard& heard, const Tamper& tamper = {}, const nav::Options& options = {})
      : heard_(heard) {
    nav::PlausibilityWatch watch(heard.sources, options, nullptr);
    for (const auto& original : heard.envelopes) {
      Envelope envelope = original;
      if (tamper) tamper(envelope, seconds(envelope.arrival - heard.begin()));
      watch.take(envelope, *this);
    }
  }
  std::vector<Finding> findings;

  /// The first warning of a source whose words hold `word`; empty: never.
  [[nodiscard]] std::optional<double> named_s(const std::string& source, const std::string& word) const {
    for (const auto& f : findings)
      if (f.level == Health::Level::warning && f.source == source && f.text.find(word) != std::string::npos)
        return f.t_s;
    return std::nullopt;
  }

 private:
  void publish(Time valid, const Message& message, SourceId source) override {
    const auto& health = std::get<Health>(message);
    EXPECT_LT(health.text.view().size(), 199U) << health.text.view();
    findings.push_back({seconds(valid - heard_.begin().host()), heard_.sources[source].name, health.level,
                        std::string(health.text.view())});
  }
  const Heard& heard_;
};

class Ears final : public Sink {
 public:
  explicit Ears(Heard& heard) : heard_(heard) {}
  void take(const Envelope& envelope) override {
    if (!std::holds_alternative<RawFrame>(envelope.message)) heard_.envelopes.push_back(envelope);
  }

 private:
  Heard& heard_;
};

inline sim::Scenario scenario(const std::string& name) {
  auto loaded = app::load_scenario(data_path("scenarios/" + name + ".toml"));
  for (const auto& problem : loaded.problems) ADD_FAILURE() << problem;
  return std::move(loaded.scenario);
}

/// A scenario's telegrams through the shipped decoders, wired as its generated configuration says.
inline Heard simulated(const sim::Scenario& scenario, std::uint64_t seed) {
  Heard heard;
  for (const auto& sensor : scenario.sensors) {
    SourceInfo info;
    info.id = static_cast<SourceId>(heard.sources.size());
    info.name = sensor.options.name;
    const auto* usbl = std::get_if<sim::UsblOptions>(&sensor.errors);
    const std::string of = usbl ? usbl->of : sensor.options.body;
    info.body = of == "ship" ? Body::ship : of == "target" ? Body::target : Body::vehicle;
    const auto& m = sensor.mount;
    info.mount = {Angle::deg(m.roll_deg), Angle::deg(m.pitch_deg), Angle::deg(m.yaw_deg)};
    info.lever = {m.x_m, m.y_m, m.z_m};
    info.latency_ns = duration(sensor.options.latency_s).count();
    info.time_offset_ns = duration(-sensor.options.clock_offset_s).count();
    if (const auto* compass = std::get_if<sim::CompassOptions>(&sensor.errors))
      if (compass->declination_deg) info.declination = Angle::deg(*compass->declination_deg);
    heard.sources.push_back(info);
  }
  Bus bus(heard.sources);
  for (std::size_t i = 0; i < scenario.sensors.size(); ++i) {
    DecoderSettings settings;
    if (const auto* usbl = std::get_if<sim::UsblOptions>(&scenario.sensors[i].errors))
      settings.address = usbl->transponder;
    decode::TableOptions table;
    table.columns = sim::table_columns_of(scenario.sensors[i]);
    bus.attach(static_cast<SourceId>(i),
               decode::make_decoder(sim::format_of(scenario.sensors[i]), settings, table).value());
  }
  Ears ears(heard);
  bus.attach(ears);
  struct Air final : sim::SimulationOutput {
    explicit Air(Bus& b) : bus(b) {}
    void truth(Body, Time, const sim::Truth&) override {}
    void telegram(std::size_t sensor, Arrival arrival, std::string_view bytes, bool) override {
      Chunk chunk;
      chunk.source = static_cast<SourceId>(sensor);
      chunk.arrival = arrival;
      chunk.bytes = {reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()};
      bus.take(chunk);
    }
    Bus& bus;
  } air(bus);
  sim::Simulation(scenario, seed, nullptr).run(air);
  bus.finish();
  return heard;
}

/// The noise the generated configuration states, as far as the watch uses it.
inline nav::Options options_of(const sim::Scenario& scenario) {
  nav::Options options;
  for (const auto& sensor : scenario.sensors) {
    if (const auto* gnss = std::get_if<sim::GnssOptions>(&sensor.errors);
        gnss && sensor.options.body == scenario.options.body)
      options.aiding.gnss_drms_m = gnss->drms_m;
    if (const auto* usbl = std::get_if<sim::UsblOptions>(&sensor.errors))
      options.aiding.usbl_drms_m = usbl->drms_m;
  }
  return options;
}

}  // namespace leadline::test
