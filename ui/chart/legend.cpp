#include "ui/chart/legend.h"

#include <QFontMetricsF>
#include <algorithm>
#include <cmath>

#include "ui/chart/fix_marks.h"
#include "ui/chart/furniture_panel.h"
#include "ui/look/look.h"

namespace leadline::ui {
namespace {

constexpr double kRow_px = 19.0, kPad_px = 8.0, kSampleLeft_px = 13.0, kSample_px = 30.0, kTextLeft_px = 52.0;

}  // namespace

QRectF legend_box(QPointF lower_left, const std::vector<LegendRow>& rows) {
  if (rows.empty()) return {};
  double text = 0.0;
  for (const LegendRow& row : rows)
    text = std::max(text, QFontMetricsF(font(12)).horizontalAdvance(row.name));
  const double height = kRow_px * static_cast<double>(rows.size()) + 2.0 * kPad_px - 2.0;
  return {lower_left.x(), lower_left.y() - height, std::ceil(kTextLeft_px + text + 12.0), height};
}

QRectF draw_legend(QPainter& painter, QPointF lower_left, const std::vector<LegendRow>& rows,
                   const Colours& colours) {
  const QRectF box = legend_box(lower_left, rows);
  if (box.isNull()) return box;
  draw_furniture_panel(painter, box, colours);
  painter.save();
  double middle = box.top() + kPad_px - 1.0 + kRow_px / 2.0;
  for (const LegendRow& row : rows) {
    const QPointF left(box.left() + kSampleLeft_px, std::round(middle));
    const QPointF centre = left + QPointF(kSample_px / 2.0, 0.0);
    switch (row.sample) {
      case LegendRow::Sample::line: {
        QPainterPath line(left);
        line.lineTo(left + QPointF(kSample_px, 0.0));
        painter.setRenderHint(QPainter::Antialiasing);
        painter.strokePath(line, pen_of(row.style, colours));
        break;
      }
      case LegendRow::Sample::fix_used:
        draw_fix_used(painter, centre, colours);
        break;
      case LegendRow::Sample::fix_refused:
        draw_fix_refused(painter, centre, centre, colours);
        break;
      case LegendRow::Sample::fixes:
        draw_fix_used(painter, left + QPointF(9.0, 0.0), colours);
        draw_fix_refused(painter, left + QPointF(22.0, 0.0), left + QPointF(22.0, 0.0), colours);
        break;
    }
    painter.setFont(font(12));
    painter.setPen(colours.of(Role::text));
    painter.drawText(QRectF(box.left() + kTextLeft_px, middle - kRow_px / 2.0, box.width(), kRow_px),
                     Qt::AlignLeft | Qt::AlignVCenter, row.name);
    middle += kRow_px;
  }
  painter.restore();
  return box;
}

}  // namespace leadline::ui
