#include "app/record.h"

#include <fmt/format.h>

#include <chrono>

#include "app/configuration.h"
#include "app/interrupt.h"
#include "app/live_run.h"
#include "app/outputs.h"
#include "app/plugins.h"
#include "app/replay_report.h"
#include "app/talk.h"

namespace leadline::app {
namespace {

Exit failed(const Error& error, Exit exit = Exit::failed) {
  failure(error.line());
  return exit;
}

void report_links(const LiveRun& live) {
  for (const auto& [address, sources, status, not_decoded] : live.links()) {
    std::string line = fmt::format("{}: {} bytes in {} pieces, opened {} times", address.text(),
                                   status.heard_bytes, status.heard_frames, status.times_opened);
    if (status.kernel_drops > 0) line += fmt::format(", {} dropped by the kernel", status.kernel_drops);
    if (not_decoded > 0) line += fmt::format(", {} recorded and not decoded for overload", not_decoded);
    note(line);
  }
  const auto queue = live.queue();
  if (queue.spilled_bytes > 0)
    note(fmt::format("{} bytes waited on the disk while the core was busy", queue.spilled_bytes));
}

}  // namespace

Exit record(const RecordOptions& options) {
  const PluginHost plugins = load_plugins(options.plugin_paths);
  const LoadedConfiguration loaded = load_configuration(options.config, plugins);
  for (const auto& problem : loaded.problems) failure(problem);
  if (!loaded.problems.empty()) return Exit::misused;
  const Configuration& configuration = loaded.configuration;
  for (const auto& source : configuration.sources)
    if (source.options.link.empty())
      return failed({"source " + source.options.name + " has no link, so nothing can be heard from it",
                     options.config, "give it one, like link = \"udp://0.0.0.0:4001\""},
                    Exit::misused);

  catch_interrupts();
  auto opened = LiveRun::open({.session = options.session}, configuration, plugins);
  if (!opened) return failed(opened.error());
  LiveRun& live = *opened.value();
  for (const auto& line : live.notes()) note(line);
  Speaker speaker(live.bus().sources());
  live.attach(speaker);
  note("recording into " + live.session_path());

  using Steady = std::chrono::steady_clock;
  const auto begun = Steady::now();
  const auto done = live.run([&] {
    return !interrupted() && (!options.duration_s ||
                              Steady::now() - begun < std::chrono::duration<double>(*options.duration_s));
  });
  report_links(live);
  const bool damaged = report_damage(live.bus(), {});
  const Lateness& late = live.solution_lateness();
  if (late.count() > 0)
    note(fmt::format("arrival to solution: p50 {:.3f} ms, p99 {:.3f} ms, max {:.3f} ms over {} solutions",
                     late.quantile_ms(0.5), late.quantile_ms(0.99), late.max_ms(), late.count()));
  if (const auto recording = live.recording())
    note(fmt::format("{}: {} frames recorded, at most {} KiB of memory waiting for the disk{}",
                     live.session_path(), recording->acknowledged, recording->most_waiting_bytes >> 10,
                     recording->facts_left_out + recording->frames_left_out > 0
                         ? fmt::format(", {} frames and {} facts left out for lack of room",
                                       recording->frames_left_out, recording->facts_left_out)
                         : ""));
  if (!done) return failed(done.error());
  return damaged ? Exit::damaged : Exit::done;
}

}  // namespace leadline::app
