#pragma once

#include <QPainter>
#include <QRectF>

#include "ui/look/colours.h"

namespace leadline::ui {

/// From the chart's edge to its furniture.
inline constexpr double kFurnitureMargin_px = 12.0;

/// The ground of orientation box, layer badge and legend: opaque, so that figures read on any raster.
void draw_furniture_panel(QPainter& painter, QRectF box, const Colours& colours);

}  // namespace leadline::ui
