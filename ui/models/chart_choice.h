#pragma once

// What the operator chooses of the chart; the rail asks for it, the chart shows it.

#include <cstdint>

namespace leadline::ui {

/// Which bearing is up.
enum class Orientation : std::uint8_t { north_up, head_up, course_up };
enum class Tool : std::uint8_t { select, pan, measure };

}  // namespace leadline::ui
