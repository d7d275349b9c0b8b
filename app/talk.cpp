#include "app/talk.h"

#include <spdlog/sinks/stdout_sinks.h>
#include <spdlog/spdlog.h>

namespace leadline::app {
namespace {

spdlog::logger& logger() {
  static const auto made = [] {
    auto to_stderr = spdlog::stderr_logger_st("leadline");
    to_stderr->set_pattern("%v");
    return to_stderr;
  }();
  return *made;
}

}  // namespace

void set_loudness(Loudness loudness) {
  logger().set_level(loudness == Loudness::quiet    ? spdlog::level::err
                     : loudness == Loudness::normal ? spdlog::level::info
                                                    : spdlog::level::debug);
}

void detail(std::string_view line) { logger().debug("{}", line); }
void note(std::string_view line) { logger().info("{}", line); }
void warning(std::string_view line) { logger().warn("warning: {}", line); }
void failure(std::string_view line) { logger().error("error: {}", line); }

}  // namespace leadline::app
