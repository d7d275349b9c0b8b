#include "app/replay.h"

#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <thread>

#include "app/configuration.h"
#include "app/inputs.h"
#include "app/interrupt.h"
#include "app/magnetic_models.h"
#include "app/talk.h"
#include "core/decode/registry.h"
#include "core/flow/bus.h"
#include "core/links/merged_source.h"
#include "core/nav/engines/registry.h"
#include "core/nav/engines/ship_track.h"
#include "sessions/export/solution_csv.h"
#include "sessions/export/summary.h"

namespace leadline::app {
namespace {

using Steady = std::chrono::steady_clock;

/// What engines have to tell the operator.
class Speaker final : public Sink {
 public:
  void take(const Envelope& envelope) override {
    if (const auto* health = std::get_if<Health>(&envelope.message)) {
      const std::string line = iso8601(envelope.valid, 1) + " " + std::string(health->text.view());
      if (health->level == Health::Level::warning)
        warning(line);
      else
        note(line);
    } else if (const auto* change = std::get_if<ModeChange>(&envelope.message)) {
      constexpr const char* kNames[] = {"A", "B", "C", "D", "E1", "E0"};
      detail(fmt::format("{} availability {} -> {}: {}", iso8601(envelope.valid, 1),
                         kNames[static_cast<std::size_t>(change->from)],
                         kNames[static_cast<std::size_t>(change->to)], change->reason.view()));
    }
  }
};

/// Holds a replay back to `speed` times real time.
class Pace {
 public:
  explicit Pace(double speed) : speed_(speed) {}
  void wait_for(Arrival arrival) {
    if (speed_ <= 0.0) return;
    if (!first_) first_ = arrival, started_ = Steady::now();
    const auto due = started_ + std::chrono::nanoseconds(static_cast<std::int64_t>(
                                    static_cast<double>((arrival - *first_).count()) / speed_));
    while (!interrupted() && Steady::now() < due)
      std::this_thread::sleep_for(
          std::min<Steady::duration>(due - Steady::now(), std::chrono::milliseconds(100)));
  }

 private:
  double speed_;
  std::optional<Arrival> first_;
  Steady::time_point started_;
};

/// A bar on a terminal, redrawn ten times a second at most.
class Progress {
 public:
  Progress(bool shown, std::uint64_t total_bytes) : shown_(shown), total_(total_bytes) {}
  ~Progress() {
    if (shown_) std::fputs("\r\033[K", stderr);
  }
  void add(std::uint64_t bytes) {
    done_ += bytes;
    if (!shown_ || done_ < next_) return;
    next_ = done_ + total_ / 200 + 1;
    const int parts = total_ == 0 ? 0 : static_cast<int>(40 * done_ / total_);
    fmt::print(stderr, "\r[{:<40}] {:3.0f} %", std::string(static_cast<std::size_t>(parts), '='),
               100.0 * static_cast<double>(done_) / static_cast<double>(total_));
  }

 private:
  bool shown_;
  std::uint64_t total_, done_ = 0, next_ = 0;
};

std::uint64_t file_size(const std::string& path) {
  std::ifstream in(path, std::ios::ate | std::ios::binary);
  return in ? static_cast<std::uint64_t>(in.tellg()) : 0;
}

std::optional<double> speed_of(const std::string& text) {
  if (text == "max") return 0.0;
  char* end = nullptr;
  const double speed = std::strtod(text.c_str(), &end);
  if (text.empty() || *end != '\0' || !(speed > 0.0) || speed > 1e6) return std::nullopt;
  return speed;
}

/// What a log suffered, said once at the end.
bool report_damage(const Bus& bus, const Inputs& inputs) {
  bool damaged = !inputs.empty.empty() || bus.stray().damaged();
  for (const auto& path : inputs.empty) warning(path + ": is empty");
  for (const auto& source : bus.sources()) {
    const Ledger& ledger = bus.ledger(source.id);
    damaged = damaged || ledger.damaged();
    for (const auto& reason : ledger.refusals())
      warning(fmt::format("{}: {} refused: {}", source.name, reason.count, reason.name));
    if (const auto bytes = ledger.bytes(ByteClass::skipped); bytes > 0)
      warning(fmt::format("{}: {} bytes skipped: they belong to no telegram", source.name, bytes));
    if (const auto unknown = ledger.frames(ByteClass::unknown); unknown > 0)
      note(fmt::format("{}: {} telegrams of unknown kinds", source.name, unknown));
  }
  for (const auto& input : inputs.open) {
    if (input.stamped != nullptr && input.stamped->backward_stamps() > 0)
      note(fmt::format("{}: {} stamps go back in time; they are taken as the latest before them", input.path,
                       input.stamped->backward_stamps()));
    if (input.stamped != nullptr && input.stamped->failure()) {
      warning(input.stamped->failure()->line());
      damaged = true;
    }
    if (input.tlog == nullptr) continue;
    for (const auto& [name, count] : input.tlog->unknown_sources())
      note(fmt::format("{}: {} lines of source \"{}\", which the configuration does not know", input.path,
                       count, name));
  }
  return damaged;
}

/// A device's clock that is seconds off would put its facts beside those of the others.
void report_clocks(const Bus& bus, const sessions::Summary& summary) {
  constexpr double kToleratedS = 2.0;
  for (const auto& source : bus.sources()) {
    const auto offset_s = summary.clock_offset_s(source.id);
    if (!offset_s) continue;
    const double left_s = *offset_s - static_cast<double>(source.time_offset_ns) * 1e-9;
    if (std::abs(left_s) > kToleratedS)
      warning(fmt::format(
          "{}: its clock is {:.2f} s {}; set time_offset_s = {:.2f} if that is its clock and no delay",
          source.name, std::abs(left_s), left_s > 0.0 ? "behind" : "ahead", *offset_s));
  }
}

bool write_text(const std::string& path, const std::string& text) {
  std::ofstream out(path, std::ios::binary);
  out << text;
  return static_cast<bool>(out.flush());
}

}  // namespace

Exit replay(const ReplayOptions& options) {
  const auto begun = Steady::now();
  const auto speed = speed_of(options.speed);
  if (!speed) {
    failure("--speed: \"" + options.speed + "\" is neither max nor a factor above 0");
    return Exit::misused;
  }
  auto loaded = load_configuration(options.config);
  for (const auto& problem : loaded.problems) failure(problem);
  if (!loaded.problems.empty()) return Exit::misused;
  const Configuration& configuration = loaded.configuration;

  std::vector<std::string> engine_names = options.engines;
  if (engine_names.empty()) engine_names.push_back(configuration.navigation.navigation.engine);

  Inputs inputs = open_inputs(options.inputs, configuration);
  Exit worst = Exit::done;
  for (const auto& [exit, error] : inputs.errors) {
    failure(error.line());
    worst = std::max(worst, exit);
  }
  if (worst != Exit::done) return worst;
  if (inputs.open.empty()) {
    failure("every input is empty: " + inputs.empty.front());
    return Exit::failed;
  }

  const auto magnetic = load_magnetic_models();
  const bool magnetic_needed = std::any_of(
      configuration.sources.begin(), configuration.sources.end(),
      [](const auto& s) { return s.options.heading == "magnetic" && !s.options.declination_deg; });
  if (!magnetic && magnetic_needed) warning(magnetic.error().line());

  Bus bus(source_infos(configuration));
  for (const auto& source : configuration.sources) {
    const auto id = static_cast<SourceId>(&source - configuration.sources.data());
    bus.attach(
        id,
        decode::make_decoder(source.options.decoder, decoder_settings(source.options), source.table).value());
  }

  nav::EngineSetup setup;
  setup.body = configuration.navigation.navigation.body == "ship" ? Body::ship : Body::vehicle;
  setup.options = configuration.navigation;
  setup.sources = bus.sources();
  setup.magnetic = magnetic ? &magnetic.value() : nullptr;
  std::vector<std::unique_ptr<Engine>> engines;
  for (const auto& name : engine_names) {
    setup.id = static_cast<EngineId>(engines.size());
    auto engine = nav::make_engine(name, setup);
    if (!engine) {
      failure(engine.error().line());
      return Exit::misused;
    }
    engines.push_back(std::move(engine).value());
  }
  engines.push_back(std::make_unique<nav::ShipTrack>(setup.sources, setup.options, setup.magnetic));
  for (auto& engine : engines) bus.attach(*engine);

  std::vector<bool> stamped(configuration.sources.size(), false);
  std::uint64_t total_bytes = 0;
  std::vector<std::unique_ptr<Source>> sources;
  for (auto& input : inputs.open) {
    for (const SourceId id : input.stamped_ids) stamped[id] = true;
    total_bytes += file_size(input.path);
    sources.push_back(std::move(input.source));
  }
  sessions::Summary summary(engine_names, options.inputs, configuration.navigation.navigation.body, stamped);
  Speaker speaker;
  bus.attach(summary);
  bus.attach(speaker);
  std::optional<sessions::SolutionCsv> csv;
  if (!options.csv.empty()) {
    auto made = sessions::SolutionCsv::create(options.csv, engine_names, bus.sources());
    if (!made) {
      failure(made.error().line());
      return Exit::failed;
    }
    csv.emplace(std::move(made).value());
    bus.attach(*csv);
  }

  catch_interrupts();
  links::MergedSource merged(std::move(sources));
  {
    Progress progress(options.progress, total_bytes);
    Pace pace(*speed);
    for (Chunk chunk; !interrupted() && merged.next(chunk);) {
      pace.wait_for(chunk.arrival);
      bus.take(chunk);
      progress.add(chunk.bytes.size() + chunk.stamp_bytes);
    }
  }
  bus.finish();

  const bool damaged = report_damage(bus, inputs);
  report_clocks(bus, summary);
  if (csv) {
    if (const auto closed = csv->close(); !closed) {
      failure(closed.error().line());
      return Exit::failed;
    }
    const double wall_s = std::chrono::duration<double>(Steady::now() - begun).count();
    if (!write_text(options.csv + "/summary.json", summary.json(bus, wall_s))) {
      failure(options.csv + "/summary.json: cannot be written; is the disk full?");
      return Exit::failed;
    }
  }
  for (std::size_t i = 0; i < engine_names.size(); ++i) {
    const auto& figures = summary.engines()[i];
    std::string line =
        fmt::format("{}: {} rows, {:.1f} m run, {} fixes accepted, {} rejected", engine_names[i],
                    figures.rows, figures.distance_run_m, figures.fixes_accepted, figures.fixes_rejected);
    if (figures.end_error_m) line += fmt::format(", {:.1f} m from the last fix", *figures.end_error_m);
    note(line);
    if (figures.rows == 0)
      warning(engine_names[i] + ": no position: it needs a start (a fix or [navigation.initial]) and motion");
  }
  if (interrupted()) return Exit::interrupted;
  return damaged ? Exit::damaged : Exit::done;
}

}  // namespace leadline::app
