#pragma once

#include <cstdint>

namespace leadline::ui {

/// How much room the window has.
enum class Fold : std::uint8_t {
  wide,     ///< 1920 x 1080 and what is near it
  compact,  ///< 1280 x 800: bars are lower, the rose folds away
  small,    ///< 800 x 600: the strip of tiles stands for the panels
};

}  // namespace leadline::ui
