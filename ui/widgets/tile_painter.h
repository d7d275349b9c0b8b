#pragma once

#include <QPainter>
#include <QRect>

#include "ui/look/colours.h"
#include "ui/models/tile_text.h"

namespace leadline::ui {

struct TileStyle {
  int value_px = 28;  ///< 28 or 18, of the type scale
  bool lone = false;  ///< outside a panel: a recorded value carries the tag REPLAY beside its edge
  bool operator==(const TileStyle&) const = default;
};

/// Heights of a tile: of 28 px values, of 18 px values, with a note below, with the two lines of a position.
inline constexpr int kTileHeight = 61, kSmallTileHeight = 47, kNoteTileHeight = 81, kPositionTileHeight = 82;

/// A value in its state. Every part has its place; a value too wide for it is written smaller, never over
/// its neighbour.
void draw_tile(QPainter& painter, const QRect& rect, const TileText& text, const Colours& colours,
               TileStyle style = {});

/// Its ground alone: fill, hatch, borders and edges of the state.
void draw_tile_ground(QPainter& painter, const QRect& rect, const TileText& text, const Colours& colours);

}  // namespace leadline::ui
