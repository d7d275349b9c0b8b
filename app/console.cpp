#include "app/console.h"

#include <dlfcn.h>
#include <fmt/format.h>

#include <charconv>
#include <cstdio>
#include <cstdlib>
#include <filesystem>

#include "app/beside_program.h"
#include "app/configuration.h"
#include "app/console/request.h"
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
  if (options.after_s && options.session.empty())
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
  if (!options.config.empty()) {
    const auto loaded = load_configuration(options.config, plugins);
    for (const auto& problem : loaded.problems) failure(problem);
    if (!loaded.problems.empty()) return Exit::misused;
    given = names_of(loaded.configuration);
  }

  ConsoleRequest request;
  request.session = options.session;
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
