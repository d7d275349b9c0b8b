#pragma once

#include <QPainter>
#include <QPolygonF>
#include <QRect>
#include <QString>
#include <vector>

#include "ui/chart/chart_view.h"
#include "ui/look/colours.h"

namespace leadline::ui {

/// Steps between parallels and between meridians, minutes of arc.
struct GraticuleStep {
  double lat_min = 1.0, lon_min = 1.0;
  bool operator==(const GraticuleStep&) const = default;
};
/// From 0.01' to 30 deg, so that lines at the view's centre are 110 to 260 px apart wherever such a step
/// exists: at 89 N meridians are counted at the equator-ward edge, where they are furthest apart.
[[nodiscard]] GraticuleStep graticule_step(const ChartView& view);

/// One meridian or parallel as the view shows it: no further than 0.25 px from where it is.
struct GraticuleLine {
  bool meridian = false;
  double value_min = 0.0;  ///< minutes north or east; longitude in [-10800, 10800)
  QPolygonF points;        ///< screen px
};
/// All that cross the view. Near a pole a meridian ends where its neighbours come closer than 14 px; those of
/// 0, 90, 180, 270 deg reach it. About 0.2 ms.
[[nodiscard]] std::vector<GraticuleLine> graticule_lines(const ChartView& view, GraticuleStep step);

/// The lines within `exposed`, a strip or all.
void draw_graticule(QPainter& painter, const ChartView& view, GraticuleStep step, const QRect& exposed,
                    const Colours& colours);
/// The figures on the left and lower edge, none under what is `taken` (furniture).
void draw_graticule_figures(QPainter& painter, const ChartView& view, GraticuleStep step,
                            const std::vector<QRectF>& taken, const Colours& colours);

/// "36°54.7′ N", with the decimals its step needs; 180 deg and 0 without a letter.
[[nodiscard]] QString graticule_figure(const GraticuleLine& line, GraticuleStep step);

}  // namespace leadline::ui
