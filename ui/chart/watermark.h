#pragma once

#include <QPainter>
#include <QRect>

#include "ui/look/colours.h"

namespace leadline::ui {

/// REPLAY all over the chart, above the rasters and below the symbols: 64 px bold at -24 deg every
/// 420 x 210 px, every other row half a step along. Standing on the screen; only what `exposed` shows is
/// drawn.
void draw_replay_watermark(QPainter& painter, const QRect& exposed, const Colours& colours);

}  // namespace leadline::ui
