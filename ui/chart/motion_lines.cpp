#include "ui/chart/motion_lines.h"

#include <cmath>

#include "ui/chart/halo.h"

namespace leadline::ui {
namespace {

QPointF ahead(double angle_deg) {
  const double a = angle_deg * kRadPerDeg;
  return {std::sin(a), -std::cos(a)};
}

}  // namespace

QLineF heading_line(QPointF at, double angle_deg, double start_px, double length_px) {
  const QPointF way = ahead(angle_deg);
  return {at + way * start_px, at + way * (start_px + length_px)};
}

QLineF heading_line_to_edge(QPointF at, double angle_deg, double start_px, QRectF chart) {
  const QPointF way = ahead(angle_deg), start = at + way * start_px;
  // Liang and Barsky: the part of the ray within each pair of sides.
  double first = 0.0, last = 1e9;
  const auto within = [&](double step, double from, double low, double high) {
    if (step == 0.0) {
      if (from < low || from > high) last = -1.0;
      return;
    }
    const double a = (low - from) / step, b = (high - from) / step;
    first = std::max(first, std::min(a, b));
    last = std::min(last, std::max(a, b));
  };
  within(way.x(), start.x(), chart.left(), chart.right());
  within(way.y(), start.y(), chart.top(), chart.bottom());
  if (last <= first) return {};
  return {start, start + way * last};
}

void draw_heading_line(QPainter& painter, QLineF line, Role role, const Colours& colours) {
  if (line.isNull()) return;
  QPainterPath path(line.p1());
  path.lineTo(line.p2());
  painter.setRenderHint(QPainter::Antialiasing);
  stroke_haloed(painter, path, {role, 1.6}, Halo::line, colours);
}

std::optional<QLineF> course_vector(const ChartView& view, Geodetic at, geo::NorthEast velocity,
                                    double sigma_mps, double seconds) {
  const double speed_mps = std::hypot(velocity.north_m, velocity.east_m);
  if (!(speed_mps >= 3.0 * sigma_mps)) return std::nullopt;
  const Geodetic to = geo::displaced(at, velocity.north_m * seconds, velocity.east_m * seconds);
  const QLineF line(view.to_screen(at), view.to_screen(to));
  if (!(line.length() >= 8.0)) return std::nullopt;
  return line;
}

void draw_course_vector(QPainter& painter, QLineF line, Role role, const Colours& colours) {
  if (line.isNull()) return;
  const QPointF back = (line.p1() - line.p2()) / line.length();
  QPainterPath shaft(line.p1()), head;
  shaft.lineTo(line.p2());
  bool first = true;
  for (const double side : {-1.0, 1.0}) {
    const double a = side * 30.0 * kRadPerDeg;  // 150 deg off the course
    const QPointF barb(back.x() * std::cos(a) - back.y() * std::sin(a),
                       back.x() * std::sin(a) + back.y() * std::cos(a));
    if (first) {
      head.moveTo(line.p2() + barb * 8.0);
      head.lineTo(line.p2());
    } else {
      head.lineTo(line.p2() + barb * 8.0);
    }
    first = false;
  }
  painter.setRenderHint(QPainter::Antialiasing);
  const QPen halo = halo_pen(1.6, Halo::line, colours);
  QPainterPath both = shaft;
  both.addPath(head);
  painter.strokePath(both, halo);
  painter.strokePath(shaft, pen_of({role, 1.6, {6.0, 4.0}}, colours));
  painter.strokePath(head, pen_of({role, 1.6}, colours));
}

}  // namespace leadline::ui
