#include "ui/chart/fix_marks.h"

#include <QFontMetricsF>
#include <algorithm>
#include <cmath>

#include "ui/chart/halo.h"
#include "ui/chart/stamp.h"
#include "ui/look/halo_text.h"
#include "ui/look/look.h"

namespace leadline::ui {
namespace {

void paint_ring(QPainter& painter, QPointF at, const Colours& colours) {
  QPainterPath ring;
  ring.addEllipse(at, 2.8, 2.8);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.strokePath(ring, halo_pen(1.3, Halo::line, colours));
  painter.fillPath(ring, colours.of(Role::halo, 0.75));
  painter.strokePath(ring, pen_of({Role::fix, 1.3}, colours));
}

}  // namespace

void draw_fix_used(QPainter& painter, QPointF at, const Colours& colours) {
  draw_stamp(painter, at, QStringLiteral("fix"), 7, colours,
             [&](QPainter& inside, QPointF middle) { paint_ring(inside, middle, colours); });
}

void draw_fix_refused(QPainter& painter, QPointF at, QPointF solution, const Colours& colours) {
  painter.setRenderHint(QPainter::Antialiasing);
  if (at != solution) {
    QPainterPath line(at);
    line.lineTo(solution);
    stroke_haloed(painter, line, {Role::fix_refused, 1.0, {2.0, 3.0}}, Halo::track, colours);
  }
  QPainterPath cross;
  cross.moveTo(at + QPointF(-5, -5));
  cross.lineTo(at + QPointF(5, 5));
  cross.moveTo(at + QPointF(-5, 5));
  cross.lineTo(at + QPointF(5, -5));
  stroke_haloed(painter, cross, {Role::fix_refused, 2.0, {}, 1.0, Qt::RoundCap}, Halo::line, colours);
}

QRectF draw_usbl_beam(QPainter& painter, QPointF ship, QPointF vehicle, const QString& label,
                      const Colours& colours, const std::vector<QRectF>& taken) {
  QPainterPath path(ship);
  path.lineTo(vehicle);
  painter.setRenderHint(QPainter::Antialiasing);
  stroke_haloed(painter, path, {Role::beam, 1.3, {9.0, 3.0, 2.0, 3.0}}, Halo::line, colours);
  const QLineF line(ship, vehicle);
  if (label.isEmpty() || line.length() < 1.0) return {};

  const QFont small = font(12);
  const QFontMetricsF metrics(small);
  const QSizeF size(metrics.horizontalAdvance(label), metrics.ascent() + metrics.descent());
  if (line.length() < 2.0 * size.width()) return {};
  // Off the line by its own half extent along the normal, on the upper side first.
  QPointF normal(-line.dy() / line.length(), line.dx() / line.length());
  if (normal.y() > 0.0) normal = -normal;
  const double off =
      std::abs(normal.x()) * size.width() / 2.0 + std::abs(normal.y()) * size.height() / 2.0 + 3.0;
  const auto box_at = [&](double along, double side) {
    QRectF box(QPointF(), size);
    box.moveCenter(line.pointAt(along) + normal * off * side);
    return box;
  };
  QRectF box = box_at(0.6, 1.0);
  const auto is_free = [&](QRectF wanted) {
    return std::none_of(taken.begin(), taken.end(), [&](QRectF other) { return other.intersects(wanted); });
  };
  for (const double along : {0.6, 0.5, 0.7, 0.4, 0.8, 0.3}) {
    for (const double side : {1.0, -1.0})
      if (!is_free(box) && is_free(box_at(along, side))) box = box_at(along, side);
  }
  draw_halo_text(painter, {box.left(), box.top() + metrics.ascent()}, label, small, Role::ink, colours);
  return box;
}

}  // namespace leadline::ui
