#pragma once

#include <QPainter>
#include <QString>
#include <cstdint>
#include <vector>

#include "ui/chart/halo.h"

namespace leadline::ui {

/// One row of the legend: a sample of what the chart shows, and its name. Only what is shown has a row.
struct LegendRow {
  enum class Sample : std::uint8_t { line, fix_used, fix_refused, fixes };
  Sample sample = Sample::line;
  LineStyle style;  ///< of a line
  QString name;
};

/// Its lower left corner stands at a point, above the scale bar. Returns its rectangle; null without rows.
QRectF draw_legend(QPainter& painter, QPointF lower_left, const std::vector<LegendRow>& rows,
                   const Colours& colours);
[[nodiscard]] QRectF legend_box(QPointF lower_left, const std::vector<LegendRow>& rows);

}  // namespace leadline::ui
