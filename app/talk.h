#pragma once

#include <string_view>

namespace leadline::app {

enum class Loudness { quiet, normal, verbose };

/// What the program says while it works: to stderr, one line a message. Results never come this way.
void set_loudness(Loudness loudness);
void detail(std::string_view line);   ///< only with --verbose
void note(std::string_view line);     ///< not with --quiet
void warning(std::string_view line);  ///< not with --quiet
void failure(std::string_view line);  ///< always

}  // namespace leadline::app
