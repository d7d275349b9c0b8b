#include "app/console.h"

#include <dlfcn.h>
#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <charconv>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <thread>

#include "app/beside_program.h"
#include "app/configuration.h"
#include "app/console/request.h"
#include "app/interrupt.h"
#include "app/live_run.h"
#include "app/outputs.h"
#include "app/plugins.h"
#include "app/talk.h"
#include "sessions/store/session.h"

namespace leadline::app {
namespace {

constexpr int kSmallestWidth = 800, kSmallestHeight = 600, kLargest = 16'384;

Exit failed(const Error& error, Exit exit = Exit::failed) {
  failure(error.line());
  return exit;
}

/// "1920x1080".
std::optional<std::pair<int, int>> parse_size(const std::string& text) {
  std::pair<int, int> size;
  const char *at = text.data(), *end = at + text.size();
  const auto width = std::from_chars(at, end, size.first);
  if (width.ec != std::errc() || width.ptr == end || *width.ptr != 'x') return std::nullopt;
  const auto height = std::from_chars(width.ptr + 1, end, size.second);
  if (height.ec != std::errc() || height.ptr != end) return std::nullopt;
  if (size.first < kSmallestWidth || size.second < kSmallestHeight || size.first > kLargest ||
      size.second > kLargest)
    return std::nullopt;
  return size;
}

ConsoleNames names_of(const Configuration& configuration) {
  return {configuration.vehicle, configuration.navigation.navigation.engine,
          configuration.navigation.navigation.body == "ship"};
}

/// A configuration whose sources all have links, and no session that is there already: a live run.
bool wants_live(const ConsoleOptions& options, const Configuration& configuration) {
  return !std::filesystem::exists(options.session) &&
         std::all_of(configuration.sources.begin(), configuration.sources.end(),
                     [](const auto& source) { return !source.options.link.empty(); });
}

/// The live run on a core thread of its own.
ConsoleLive live_request(LiveRun& live, const Configuration& configuration, std::thread& core,
                         std::atomic<bool>& ended, Result<void>& outcome) {
  ConsoleLive request;
  request.sources = source_infos(configuration);
  for (const auto& source : configuration.sources) request.decoders.push_back(source.options.decoder);
  request.engines = live.engine_names();
  request.names = names_of(configuration);
  request.session = live.session_path();
  request.start = [&](const std::vector<Sink*>& sinks) {
    for (Sink* sink : sinks) live.attach(*sink);
    core = std::thread([&] { outcome = live.run([&] { return !ended && !interrupted(); }); });
  };
  request.stop = [&] {
    ended = true;
    if (core.joinable()) core.join();
    return outcome;
  };
  request.links = [&] {
    std::vector<ConsoleLink> links;
    for (const auto& [address, sources, status, not_decoded] : live.links())
      links.push_back({address.text(), status.last_error, sources, status.open, status.heard_bytes,
                       status.heard_frames, status.kernel_drops});
    return links;
  };
  request.over = interrupted;
  return request;
}

/// A screen, or for a picture none at all.
bool has_display() {
  for (const char* name : {"QT_QPA_PLATFORM", "DISPLAY", "WAYLAND_DISPLAY"})
    if (const char* value = std::getenv(name); value != nullptr && *value != '\0') return true;
  return false;
}

/// The loaded library's entry.
struct LoadedConsole {
  ConsoleEntry run = nullptr;
};

Result<LoadedConsole> load_console() {
  const auto library = installed_or_beside("lib", kConsoleLibrary);
  void* handle = ::dlopen(library.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (handle == nullptr)
    return Error{fmt::format("cannot be loaded ({})", ::dlerror()), library.string(),
                 "install the console again"};
  auto* entry = reinterpret_cast<ConsoleEntry>(::dlsym(handle, kConsoleEntry));
  if (entry == nullptr)
    return Error{"is not the console of this program", library.string(), "install the console again"};
  return LoadedConsole{entry};
}

}  // namespace

Exit console(const ConsoleOptions& options) {
  const auto size = parse_size(options.size);
  if (!size)
    return failed({fmt::format("\"{}\" is no size from {}x{} to {}x{}", options.size, kSmallestWidth,
                               kSmallestHeight, kLargest, kLargest),
                   "--size", "write it as 1920x1080"},
                  Exit::misused);
  if (options.after_s && options.session.empty() && options.config.empty())
    return failed({"counts seconds of a session, and there is none", "--after", "give --session"},
                  Exit::misused);
  if (!has_display()) {
    if (options.screenshot.empty())
      return failed({"there is no display", "DISPLAY",
                     "log in at a screen, or make a picture with --screenshot FILE.png"});
    ::setenv("QT_QPA_PLATFORM", "offscreen", 1);
  }
  const PluginHost plugins = load_plugins(options.plugin_paths);
  std::optional<ConsoleNames> given;
  LoadedConfiguration loaded_config;
  std::unique_ptr<LiveRun> live;
  if (!options.config.empty()) {
    loaded_config = load_configuration(options.config, plugins);
    for (const auto& problem : loaded_config.problems) failure(problem);
    if (!loaded_config.problems.empty()) return Exit::misused;
    given = names_of(loaded_config.configuration);
    if (wants_live(options, loaded_config.configuration)) {
      catch_interrupts();
      auto opened = LiveRun::open({.session = options.session}, loaded_config.configuration, plugins);
      if (!opened) return failed(opened.error());
      live = std::move(opened).value();
      for (const auto& line : live->notes()) note(line);
    }
  }
  std::thread core;
  std::atomic<bool> ended = false;
  Result<void> outcome;
  ConsoleLive live_part;

  ConsoleRequest request;
  if (live) {
    live_part = live_request(*live, loaded_config.configuration, core, ended, outcome);
    request.live = &live_part;
  } else {
    request.session = options.session;
  }
  request.screenshot = options.screenshot;
  request.after_s = options.after_s;
  request.width = size->first;
  request.height = size->second;
  request.palette = options.palette;
  request.charts = options.charts;
  request.charts_folder = installed_or_beside("share/leadline", "charts").string();
  request.say = [](const std::string& line) { failure(line); };
  request.detail = [](const std::string& line) { detail(line); };
  request.names = [&](const std::string& path, sessions::RunId run) -> Result<ConsoleNames> {
    if (given) return *given;
    auto session = sessions::Session::open(path, sessions::Access::read);
    if (!session) return session.error();
    const auto text = session.value().configuration(run);
    if (!text) return text.error();
    const auto loaded = parse_configuration(text.value(), path + " (its configuration)", plugins);
    if (!loaded.problems.empty()) return Error{loaded.problems.front(), "", "names are the defaults"};
    return names_of(loaded.configuration);
  };
  const auto entry = load_console();
  if (!entry) return failed(entry.error());
  const int status = entry.value().run(request);
  // Qt's platform plugins and GDAL's hundred libraries take themselves down in no defined order, and lose
  // memory on the way: all of ours is gone by now, so nothing is left to do.
  std::fflush(nullptr);
  std::_Exit(status);
}

}  // namespace leadline::app
