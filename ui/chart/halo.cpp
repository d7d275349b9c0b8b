#include "ui/chart/halo.h"

namespace leadline::ui {

QPen pen_of(const LineStyle& line, const Colours& colours) {
  QPen pen(colours.of(line.role, line.opacity), line.width_px, Qt::SolidLine, line.cap, Qt::MiterJoin);
  if (line.dash_px.isEmpty()) return pen;
  QVector<qreal> dashes = line.dash_px;
  for (qreal& length : dashes) length /= line.width_px;  // Qt counts dashes in widths
  pen.setDashPattern(dashes);
  return pen;
}

QPen halo_pen(double width_px, Halo halo, const Colours& colours) {
  const double more = halo == Halo::symbol ? 5.0 : 2.4;
  const double opacity = halo == Halo::track ? 0.70 : 0.85;
  return {colours.of(Role::halo, opacity), width_px + more, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin};
}

void stroke_haloed(QPainter& painter, const QPainterPath& path, const LineStyle& line, Halo halo,
                   const Colours& colours) {
  painter.strokePath(path, halo_pen(line.width_px, halo, colours));
  painter.strokePath(path, pen_of(line, colours));
}

}  // namespace leadline::ui
