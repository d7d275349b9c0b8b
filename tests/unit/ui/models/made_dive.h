#pragma once

// The small dive in a session file, and what a player that is asked for its state may be compared with.

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <thread>

#include "sessions/recorder/recorder.h"
#include "tests/unit/sessions/made_session.h"
#include "tests/unit/ui/bridge/made_messages.h"
#include "ui/models/session_player.h"

namespace leadline::test {

inline sessions::RunInfo dive_run(sessions::RunKind kind = sessions::RunKind::record) {
  sessions::RunInfo info;
  info.kind = kind;
  info.started = {kDiveNs};
  info.configuration_text = "version = 1\n";
  const ui::ConsoleSetup setup = dive_setup();
  info.engines = setup.engines;
  for (const auto& source : setup.sources) {
    auto& recorded = info.sources.emplace_back();
    recorded.info.id = static_cast<SourceId>(info.sources.size() - 1);
    recorded.info.name = source.name;
    recorded.info.body = source.body == ui::Body::ship     ? Body::ship
                         : source.body == ui::Body::target ? Body::target
                                                           : Body::vehicle;
    recorded.decoder = source.decoder;
  }
  return info;
}

/// Another run of a session that is made, if it is not there.
inline void record(const std::string& path, const std::vector<Envelope>& messages,
                   const sessions::RunInfo& info = dive_run()) {
  auto session = std::filesystem::exists(path) ? sessions::Session::open(path, sessions::Access::append)
                                               : sessions::Session::create(path, {});
  ASSERT_TRUE(session) << session.error().line();
  auto recorder = sessions::Recorder::start(std::move(session).value(), info, lossless());
  ASSERT_TRUE(recorder) << recorder.error().line();
  for (const Envelope& message : messages) recorder.value()->take(message);
  const auto finished = recorder.value()->finish();
  ASSERT_TRUE(finished) << finished.error().line();
}

inline Result<std::unique_ptr<ui::SessionPlayer>> open_player(const std::string& path,
                                                              std::optional<sessions::RunId> run = {},
                                                              const ui::SetupNames& names = {}) {
  auto session = sessions::Session::open(path, sessions::Access::read);
  if (!session) return session.error();
  auto runs = ui::choose_runs(session.value(), run);
  if (!runs) return runs.error();
  const auto& newest = runs.value().back().run;
  const auto sources = session.value().sources(newest.id);
  if (!sources) return sources.error();
  auto setup = ui::setup_of(newest, sources.value(), path, names);
  return ui::SessionPlayer::open(path, std::move(runs).value(), std::move(setup));
}

/// Waits for the background; false: it did not come to an end.
inline bool load_all(ui::SessionPlayer& player) {
  for (int i = 0; i < 6'000 && !player.history().complete; ++i) {
    if (!player.take_loaded()) std::this_thread::sleep_for(std::chrono::milliseconds(5));
    if (player.failure()) return false;
  }
  return player.history().complete;
}

/// Everything in which two snapshots differ, in words; empty: nothing.
inline std::string differences(const ui::Snapshot& a, const ui::Snapshot& b) {
  std::string text;
  const auto differ = [&](const char* what, bool same) {
    if (!same) text += std::string(what) + " ";
  };
  const auto body = [&](const char* what, const std::optional<ui::BodyState>& x,
                        const std::optional<ui::BodyState>& y) {
    differ(what, x.has_value() == y.has_value());
    if (!x || !y) return;
    const std::string name(what);
    differ((name + ".solution").c_str(), x->solution == y->solution && x->valid == y->valid);
    differ((name + ".rate").c_str(), x->rate_hz == y->rate_hz);
    differ((name + ".position").c_str(), x->position == y->position);
    differ((name + ".heading").c_str(), x->heading == y->heading);
    differ((name + ".velocity").c_str(), x->velocity == y->velocity);
    differ((name + ".depth").c_str(), x->depth == y->depth);
    differ((name + ".attitude").c_str(), x->attitude == y->attitude);
    differ((name + ".altitude").c_str(), x->altitude == y->altitude);
  };
  differ("now", a.now == b.now);
  body("ship", a.ship, b.ship);
  body("vehicle", a.vehicle, b.vehicle);
  differ("others", a.others == b.others);
  differ("targets", a.targets == b.targets);
  differ("availability", a.availability == b.availability);
  differ("alerts", a.alerts == b.alerts);
  differ("beam", a.beam == b.beam);
  for (std::size_t i = 0; i < std::max(a.sources.size(), b.sources.size()); ++i) {
    if (i >= a.sources.size() || i >= b.sources.size() || !(a.sources[i] == b.sources[i])) {
      text += "source " + std::to_string(i);
      if (i < a.sources.size() && i < b.sources.size()) {
        const auto &x = a.sources[i], &y = b.sources[i];
        differ(".rate", x.rate_hz == y.rate_hz), differ(".period", x.period_s == y.period_s);
        differ(".last", x.last == y.last), differ(".latency", x.latency_s == y.latency_s);
        differ(".frames", x.frames == y.frames), differ(".refused", x.refused == y.refused);
        differ(".fixes", x.fixes_judged == y.fixes_judged && x.fixes_refused == y.fixes_refused);
      }
      text += " ";
    }
  }
  return text;
}

}  // namespace leadline::test
