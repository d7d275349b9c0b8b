#pragma once

#include <QPainter>

#include "ui/chart/chart_view.h"
#include "ui/look/colours.h"

namespace leadline::ui {

/// What a scale bar stands for and how long it is on the screen, at the view's centre.
struct ScaleBar {
  double length_m = 0.0;
  double length_px = 0.0;
};
/// 1, 2 or 5 x 10^n m of 120 to 260 px; 104 px at the least, where 2 is too short and 5 too long.
[[nodiscard]] ScaleBar scale_bar(const ChartView& view);

/// Bottom left, above the graticule's figures. Returns its rectangle.
QRectF draw_scale_bar(QPainter& painter, const ChartView& view, const Colours& colours);
[[nodiscard]] QRectF scale_bar_box(const ChartView& view);

}  // namespace leadline::ui
