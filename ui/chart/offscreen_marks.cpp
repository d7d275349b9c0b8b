#include "ui/chart/offscreen_marks.h"

#include <QFontMetricsF>
#include <algorithm>
#include <cmath>

#include "core/types/angle.h"
#include "ui/chart/halo.h"
#include "ui/look/halo_text.h"
#include "ui/look/look.h"

namespace leadline::ui {
namespace {

constexpr double kInside_px = 12.0;
constexpr double kTip_px = 18.0;  // from a symbol's position to its tip
constexpr double kStep_px = 8.0;  // along the edge, looking for room

/// Where the way from the middle leaves a rectangle.
QPointF on_edge(QRectF box, QPointF way) {
  const double x = way.x() == 0.0 ? 1e300 : box.width() / 2.0 / std::abs(way.x());
  const double y = way.y() == 0.0 ? 1e300 : box.height() / 2.0 / std::abs(way.y());
  return box.center() + way * std::min(x, y);
}

/// A point moved along the rectangle's border, clockwise.
QPointF along(QRectF box, QPointF from, double distance) {
  const double w = box.width(), h = box.height(), round = 2.0 * (w + h);
  double s = 0.0;
  if (from.y() <= box.top() + 1e-6)
    s = from.x() - box.left();
  else if (from.x() >= box.right() - 1e-6)
    s = w + from.y() - box.top();
  else if (from.y() >= box.bottom() - 1e-6)
    s = w + h + box.right() - from.x();
  else
    s = 2.0 * w + h + box.bottom() - from.y();
  s = std::fmod(std::fmod(s + distance, round) + round, round);
  if (s < w) return {box.left() + s, box.top()};
  if (s < w + h) return {box.right(), box.top() + s - w};
  if (s < 2.0 * w + h) return {box.right() - (s - w - h), box.bottom()};
  return {box.left(), box.bottom() - (s - 2.0 * w - h)};
}

struct Spot {
  QPointF at;
  QRectF text, both;
};

Spot spot_at(QPointF at, QRectF border, QSizeF text_size) {
  // The range on the inner side: right of a mark at the left edge, left of one at the right, else beside it.
  Spot spot{at, QRectF(QPointF(), text_size), {}};
  const bool right = at.x() > border.center().x();
  spot.text.moveCenter(at);
  if (right) {
    spot.text.moveRight(at.x() - kTip_px - 3.0);
  } else {
    spot.text.moveLeft(at.x() + kTip_px + 3.0);
  }
  spot.both = spot.text.united(QRectF(at.x() - kTip_px, at.y() - kTip_px, 2.0 * kTip_px, 2.0 * kTip_px));
  return spot;
}

}  // namespace

bool is_offscreen(QPointF at, QSize chart) { return !QRectF(QPointF(), chart).contains(at); }

std::vector<QRectF> draw_offscreen_marks(QPainter& painter, QSize chart,
                                         const std::vector<OffscreenMark>& marks,
                                         const std::vector<QRectF>& taken, const Colours& colours) {
  std::vector<QRectF> boxes;
  const double in = kInside_px + kTip_px;
  const QRectF border = QRectF(QPointF(), chart).adjusted(in, in, -in, -in);
  if (border.width() <= 0.0 || border.height() <= 0.0) return boxes;
  const QFont small = font(12);
  const QFontMetricsF metrics(small);
  for (const OffscreenMark& mark : marks) {
    const QPointF middle = border.center(), way = mark.at - middle;
    const double length = std::hypot(way.x(), way.y());
    if (!std::isfinite(length) || length < 1.0) continue;
    const QSizeF size(metrics.horizontalAdvance(mark.range), metrics.ascent() + metrics.descent());
    const auto free = [&](QRectF box) {
      const auto clear = [&](QRectF other) { return !other.intersects(box); };
      return std::all_of(taken.begin(), taken.end(), clear) && std::all_of(boxes.begin(), boxes.end(), clear);
    };
    const QPointF wanted = on_edge(border, way / length);
    Spot spot = spot_at(wanted, border, size);
    const double furthest = border.width() + border.height();
    for (double off = kStep_px; off < furthest && !free(spot.both); off += kStep_px) {
      for (const double side : {off, -off}) {
        const Spot other = spot_at(along(border, wanted, side), border, size);
        if (!free(other.both)) continue;
        spot = other;
        break;
      }
    }

    const QPointF outward = mark.at - spot.at;
    const double angle = std::atan2(outward.x(), -outward.y()) * kDegPerRad;
    switch (mark.body) {
      case Body::ship:
        draw_ship(painter, spot.at, angle, mark.look, colours);
        break;
      case Body::vehicle:
        draw_vehicle(painter, spot.at, angle, mark.look, colours);
        break;
      case Body::target: {
        // A circle has no direction: a tip outside it points.
        painter.save();
        painter.setRenderHint(QPainter::Antialiasing);
        painter.translate(spot.at);
        painter.rotate(angle);
        const QPolygonF tip({{-5.5, -12.0}, {0, -kTip_px}, {5.5, -12.0}});
        QPainterPath path;
        path.addPolygon(tip);
        path.closeSubpath();
        painter.strokePath(path, halo_pen(0.0, Halo::symbol, colours));
        painter.fillPath(path, colours.of(Role::target));
        painter.restore();
        draw_target(painter, spot.at, mark.look, colours);
        break;
      }
    }
    draw_halo_text(painter, {spot.text.left(), spot.text.top() + metrics.ascent()}, mark.range, small,
                   Role::ink, colours);
    boxes.push_back(spot.both);
  }
  return boxes;
}

}  // namespace leadline::ui
