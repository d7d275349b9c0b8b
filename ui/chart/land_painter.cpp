#include "ui/chart/land_painter.h"

#include <cmath>

namespace leadline::ui {
namespace {

constexpr double kMargin_px = 4.0;  // beyond what is exposed, where edges of the cut polygon may run
constexpr double kFinest_px = 0.5;  // points closer than this are one

// Sutherland and Hodgman 1974, one side: keep(p) >= 0 is within.
template <class Keep>
void cut_side(std::vector<QPointF>& polygon, std::vector<QPointF>& spare, const Keep& keep) {
  spare.clear();
  for (std::size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++) {
    const double from = keep(polygon[j]), to = keep(polygon[i]);
    if ((from < 0.0) != (to < 0.0)) {
      spare.push_back(polygon[j] + (polygon[i] - polygon[j]) * (from / (from - to)));
    }
    if (to >= 0.0) spare.push_back(polygon[i]);
  }
  polygon.swap(spare);
}

void cut_to(std::vector<QPointF>& polygon, std::vector<QPointF>& spare, const QRectF& box) {
  cut_side(polygon, spare, [&](QPointF p) { return p.x() - box.left(); });
  if (!polygon.empty()) cut_side(polygon, spare, [&](QPointF p) { return box.right() - p.x(); });
  if (!polygon.empty()) cut_side(polygon, spare, [&](QPointF p) { return p.y() - box.top(); });
  if (!polygon.empty()) cut_side(polygon, spare, [&](QPointF p) { return box.bottom() - p.y(); });
}

bool touches(QPointF a, QPointF b, const QRectF& box) {
  return std::fmax(a.x(), b.x()) >= box.left() && std::fmin(a.x(), b.x()) <= box.right() &&
         std::fmax(a.y(), b.y()) >= box.top() && std::fmin(a.y(), b.y()) <= box.bottom();
}

bool close(QPointF a, QPointF b) {
  return std::abs(a.x() - b.x()) < kFinest_px && std::abs(a.y() - b.y()) < kFinest_px;
}

// The ring's shore within the box as few long lines.
void draw_shore(QPainter& painter, const maps::PlaneRing& ring, const std::vector<QPointF>& points,
                const QRectF& box, std::vector<QPointF>& line) {
  const std::size_t n = points.size();
  line.clear();
  const auto finish = [&] {
    if (line.size() > 1) painter.drawPolyline(line.data(), static_cast<int>(line.size()));
    line.clear();
  };
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t next = i + 1 == n ? 0 : i + 1;
    if (ring.shore[i] == 0 || !touches(points[i], points[next], box)) {
      finish();
      continue;
    }
    if (line.empty()) line.push_back(points[i]);
    if (!close(line.back(), points[next])) line.push_back(points[next]);
  }
  finish();
}

}  // namespace

void draw_land(QPainter& painter, const std::vector<maps::PlaneRing>& land, const QTransform& plane_to_screen,
               const QRectF& exposed, Role sea, const Colours& colours) {
  const QRectF box = exposed.adjusted(-kMargin_px, -kMargin_px, kMargin_px, kMargin_px);
  painter.save();
  painter.setClipRect(exposed, Qt::IntersectClip);
  painter.setRenderHint(QPainter::Antialiasing);
  const QPen coast(colours.of(Role::coast), 1.0);
  std::vector<QPointF> points, polygon, spare;
  for (const maps::PlaneRing& ring : land) {
    const maps::PlaneBox& b = ring.bounds;
    const QRectF bounds(b.west_m, b.south_m, b.east_m - b.west_m, b.north_m - b.south_m);
    if (!plane_to_screen.mapRect(bounds).intersects(box)) continue;
    points.clear();
    for (const maps::PlanePoint p : ring.points)
      points.push_back(plane_to_screen.map(QPointF(p.east_m, p.north_m)));
    polygon.clear();
    for (const QPointF p : points) {
      if (polygon.empty() || !close(polygon.back(), p)) polygon.push_back(p);
    }
    cut_to(polygon, spare, box);
    if (polygon.size() > 2) {
      painter.setPen(Qt::NoPen);
      painter.setBrush(colours.of(ring.water ? sea : Role::land));
      painter.drawPolygon(polygon.data(), static_cast<int>(polygon.size()), Qt::OddEvenFill);
    }
    painter.setPen(coast);
    painter.setBrush(Qt::NoBrush);
    draw_shore(painter, ring, points, box, spare);
  }
  painter.restore();
}

}  // namespace leadline::ui
