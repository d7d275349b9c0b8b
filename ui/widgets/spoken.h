#pragma once

#include <QString>

#include "ui/models/tile_text.h"

namespace leadline::ui {

/// For screen readers: "Depth 1512.4 metres, sigma 0.3, age 0.2 s, live".
[[nodiscard]] QString spoken(const TileText& text);
/// For the tool tip: all that the tile knows, a fact a line.
[[nodiscard]] QString explained(const TileText& text);

[[nodiscard]] QString state_word(ValueState state);

}  // namespace leadline::ui
