#include "app/replay_report.h"

#include <fmt/format.h>

#include <cmath>

#include "app/talk.h"

namespace leadline::app {

void Speaker::take(const Envelope& envelope) {
  if (const auto* health = std::get_if<Health>(&envelope.message)) {
    const std::string text(health->text.view());
    const std::string name = envelope.source < sources_.size() ? sources_[envelope.source].name : "";
    const bool named = name.empty() || text.find(name) != std::string::npos;
    const std::string line = iso8601(envelope.valid, 1) + " " + (named ? "" : name + ": ") + text;
    if (health->level == Health::Level::warning)
      warning(line);
    else
      note(line);
  } else if (const auto* alarm = std::get_if<Alarm>(&envelope.message)) {
    failure("alarm: " + std::string(alarm->text.view()));
  } else if (const auto* change = std::get_if<ModeChange>(&envelope.message)) {
    constexpr const char* kNames[] = {"A", "B", "C", "D", "E1", "E0"};
    detail(fmt::format("{} availability {} -> {}: {}", iso8601(envelope.valid, 1),
                       kNames[static_cast<std::size_t>(change->from)],
                       kNames[static_cast<std::size_t>(change->to)], change->reason.view()));
  }
}

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
    if (input.session != nullptr && input.session->failure()) {
      warning(input.session->failure()->line());
      damaged = true;
    }
    if (input.stamped != nullptr && input.stamped->backward_stamps() > 0)
      note(fmt::format("{}: {} stamps go back in time; they are taken as the latest before them", input.path,
                       input.stamped->backward_stamps()));
    if (input.stamped != nullptr && input.stamped->failure()) {
      warning(input.stamped->failure()->line());
      damaged = true;
    }
    if (input.capture != nullptr) {
      for (const auto& [port, count] : input.capture->for_nobody())
        note(fmt::format("{}: {} packets to {}, which is no source's link", input.path, count, port));
      if (const auto missing = input.capture->missing_bytes(); missing > 0)
        warning(fmt::format("{}: {} bytes of TCP streams were not captured", input.path, missing));
      if (input.capture->failure()) warning(input.capture->failure()->line());
      damaged = damaged || input.capture->missing_bytes() > 0 || input.capture->failure();
    }
    if (input.tlog == nullptr) continue;
    for (const auto& [name, count] : input.tlog->unknown_sources())
      note(fmt::format("{}: {} lines of source \"{}\", which the configuration does not know", input.path,
                       count, name));
  }
  return damaged;
}

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

void report_engines(const std::vector<std::string>& names, const sessions::Summary& summary) {
  for (std::size_t i = 0; i < names.size(); ++i) {
    const auto& figures = summary.engines()[i];
    std::string line =
        fmt::format("{}: {} rows, {:.1f} m run, {} fixes accepted, {} rejected", names[i], figures.rows,
                    figures.distance_run_m, figures.fixes_accepted, figures.fixes_rejected);
    if (figures.end_error_m) line += fmt::format(", {:.1f} m from the last fix", *figures.end_error_m);
    note(line);
    if (figures.rows == 0)
      warning(names[i] + ": no position: it needs a start (a fix or [navigation.initial]) and motion");
  }
}

}  // namespace leadline::app
