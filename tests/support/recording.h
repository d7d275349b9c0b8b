#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

#include "core/decode/registry.h"
#include "core/flow/bus.h"
#include "core/geo/geodesy.h"
#include "core/links/file_reader.h"
#include "core/links/merged_source.h"
#include "core/links/stamped_text_source.h"
#include "core/links/stream_source.h"
#include "core/links/stream_times.h"
#include "core/nav/engines/registry.h"
#include "core/nav/engines/ship_track.h"

namespace leadline::test {

/// One instrument of a recording: its file is a stamped text or a plain stream.
struct Instrument {
  std::string name, decoder, path;
  bool stamped = true;
  DecoderSettings settings = {};
  SourceInfo info = {};
};

/// Everything said during one replay, raw bytes left out.
struct Replayed final : Sink {
  std::vector<Envelope> envelopes;
  void take(const Envelope& envelope) override {
    if (!std::holds_alternative<RawFrame>(envelope.message) &&
        !std::holds_alternative<Tick>(envelope.message))
      envelopes.push_back(envelope);
  }

  template <class T>
  struct At {
    Time t;
    SourceId source;
    T value;
  };
  template <class T>
  [[nodiscard]] std::vector<At<T>> all() const {
    std::vector<At<T>> found;
    for (const auto& e : envelopes)
      if (const T* value = std::get_if<T>(&e.message)) found.push_back({e.valid, e.source, *value});
    return found;
  }
  [[nodiscard]] std::vector<At<Solution>> solutions(EngineId engine) const {
    std::vector<At<Solution>> found;
    for (auto& s : all<Solution>())
      if (s.value.engine == engine) found.push_back(s);
    return found;
  }
  [[nodiscard]] std::vector<At<FixVerdict>> verdicts(EngineId engine) const {
    std::vector<At<FixVerdict>> found;
    for (auto& v : all<FixVerdict>())
      if (v.value.engine == engine) found.push_back(v);
    return found;
  }
};

/// Runs a recording through the shipped decoders and engines, wired as the program wires them.
inline Replayed replay(const std::vector<Instrument>& instruments, const nav::Options& options, Body body,
                       const std::vector<std::string>& engine_names,
                       const geo::MagneticModel* magnetic = nullptr) {
  std::vector<SourceInfo> infos;
  std::vector<std::unique_ptr<Source>> sources;
  for (const auto& instrument : instruments) {
    SourceInfo info = instrument.info;
    info.id = static_cast<SourceId>(infos.size());
    info.name = instrument.name;
    info.body = body;
    auto file = links::FileReader::open(instrument.path);
    EXPECT_TRUE(file.ok()) << instrument.path;
    if (instrument.stamped) {
      sources.push_back(std::make_unique<links::StampedTextSource>(std::move(file).value(), info.id));
    } else {
      const auto maker = [&](std::optional<Time> date) {
        DecoderSettings settings = instrument.settings;
        settings.date = date;
        return decode::make_decoder(instrument.decoder, settings).value();
      };
      auto stamps =
          links::stream_times(file.value(), maker, {.source = instrument.name, .file = instrument.path});
      EXPECT_TRUE(stamps.ok()) << stamps.error().line();
      file.value().rewind();
      sources.push_back(
          std::make_unique<links::StreamSource>(std::move(file).value(), info.id, std::move(stamps).value()));
    }
    infos.push_back(info);
  }
  Bus bus(infos);
  for (std::size_t i = 0; i < instruments.size(); ++i)
    bus.attach(static_cast<SourceId>(i),
               decode::make_decoder(instruments[i].decoder, instruments[i].settings).value());
  std::vector<std::unique_ptr<Engine>> engines;
  for (const auto& name : engine_names)
    engines.push_back(nav::make_engine(name, {.id = static_cast<EngineId>(engines.size()),
                                              .body = body,
                                              .options = options,
                                              .sources = bus.sources(),
                                              .magnetic = magnetic})
                          .value());
  engines.push_back(std::make_unique<nav::ShipTrack>(bus.sources(), options, magnetic));
  for (auto& engine : engines) bus.attach(*engine);
  Replayed replayed;
  bus.attach(replayed);
  links::MergedSource merged(std::move(sources));
  for (Chunk chunk; merged.next(chunk);) bus.take(chunk);
  bus.finish();
  return replayed;
}

/// A track at a time between two of its rows.
inline std::optional<geo::NorthEast> position_at(const std::vector<Replayed::At<Solution>>& track, Time t,
                                                 const Geodetic& origin) {
  for (std::size_t i = 1; i < track.size(); ++i) {
    if (t < track[i - 1].t || t > track[i].t) continue;
    const auto a = geo::difference(origin, track[i - 1].value.position);
    const auto b = geo::difference(origin, track[i].value.position);
    const double f = seconds(t - track[i - 1].t) / seconds(track[i].t - track[i - 1].t);
    return geo::NorthEast{a.north_m + f * (b.north_m - a.north_m), a.east_m + f * (b.east_m - a.east_m)};
  }
  return std::nullopt;
}

/// The turn and scale that lay one track best over reference points: untrimmed least squares.
struct TurnAndScale {
  double turn_deg = 0.0, scale = 1.0, rms_m = 0.0;
  int points = 0;
};
inline TurnAndScale best_turn(
    const std::vector<std::pair<geo::NorthEast, geo::NorthEast>>& track_and_reference) {
  const double n = static_cast<double>(track_and_reference.size());
  geo::NorthEast d0, z0;
  for (const auto& [d, z] : track_and_reference) {
    d0.north_m += d.north_m / n, d0.east_m += d.east_m / n;
    z0.north_m += z.north_m / n, z0.east_m += z.east_m / n;
  }
  double C = 0, S = 0, dd = 0;
  for (const auto& [d, z] : track_and_reference) {
    const double dN = d.north_m - d0.north_m, dE = d.east_m - d0.east_m;
    const double zN = z.north_m - z0.north_m, zE = z.east_m - z0.east_m;
    C += dN * zN + dE * zE;
    S += dN * zE - dE * zN;
    dd += dN * dN + dE * dE;
  }
  TurnAndScale best{std::atan2(S, C) * kDegPerRad, std::hypot(C, S) / dd, 0.0, static_cast<int>(n)};
  const double c = best.scale * std::cos(best.turn_deg * kRadPerDeg),
               s = best.scale * std::sin(best.turn_deg * kRadPerDeg);
  for (const auto& [d, z] : track_and_reference) {
    const double dN = d.north_m - d0.north_m, dE = d.east_m - d0.east_m;
    const double rN = z.north_m - z0.north_m - (c * dN - s * dE),
                 rE = z.east_m - z0.east_m - (s * dN + c * dE);
    best.rms_m += (rN * rN + rE * rE) / n;
  }
  best.rms_m = std::sqrt(best.rms_m);
  return best;
}

}  // namespace leadline::test
