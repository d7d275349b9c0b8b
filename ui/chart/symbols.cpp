#include "ui/chart/symbols.h"

#include <QPolygonF>
#include <algorithm>

#include "core/types/expect.h"
#include "ui/chart/halo.h"
#include "ui/chart/stamp.h"

namespace leadline::ui {
namespace {

/// A symbol as it is when all is well.
struct Shape {
  QPainterPath outline;
  Role role = Role::ink;
  double edge_px = 0.0;  ///< 0: a filled shape without an edge
  double fill = 1.0;     ///< opacity
};

QPainterPath closed(const QPolygonF& points) {
  QPainterPath path;
  path.addPolygon(points);
  path.closeSubpath();
  return path;
}

void paint(QPainter& painter, const Shape& shape, SymbolLook look, const Colours& colours) {
  const bool live = look.state == SymbolState::live;
  const bool dashed = look.simulated || look.state == SymbolState::lost;
  LineStyle edge{shape.role, shape.edge_px};
  if (!live) edge.width_px = 1.6;
  if (look.simulated) edge.width_px = 1.8;
  if (dashed) edge.dash_px = {4.0, 2.5};

  painter.strokePath(shape.outline, halo_pen(edge.width_px, Halo::symbol, colours));
  if (look.simulated) painter.fillPath(shape.outline, colours.of(Role::halo, 0.5));
  if (live && !look.simulated) painter.fillPath(shape.outline, colours.of(shape.role, shape.fill));
  if (look.state == SymbolState::stale)
    painter.fillPath(shape.outline, colours.of(shape.role, 0.35 * shape.fill));
  if (edge.width_px > 0.0) painter.strokePath(shape.outline, pen_of(edge, colours));
}

void dot(QPainter& painter, double radius_px, Role role, const Colours& colours) {
  painter.setPen(Qt::NoPen);
  painter.setBrush(colours.of(role));
  painter.drawEllipse(QPointF(), radius_px, radius_px);
}

/// The painter at a position, turned; put back at the end.
class Placed {
 public:
  Placed(QPainter& painter, QPointF at, double angle_deg) : painter_(painter) {
    painter_.save();
    painter_.setRenderHint(QPainter::Antialiasing);
    painter_.translate(at);
    painter_.rotate(angle_deg);
  }
  ~Placed() { painter_.restore(); }
  Placed(const Placed&) = delete;
  Placed& operator=(const Placed&) = delete;

 private:
  QPainter& painter_;
};

}  // namespace

bool shows_true_scale(const Hull& hull, double metres_per_px, bool shown_before) {
  LL_EXPECT(metres_per_px > 0.0);
  const double length_px = hull.length_m / metres_per_px, beam_px = hull.beam_m / metres_per_px;
  return shown_before ? length_px >= 34.0 && beam_px >= 5.0 : length_px >= 40.0 && beam_px >= 6.0;
}

void draw_ship(QPainter& painter, QPointF at, double angle_deg, SymbolLook look, const Colours& colours) {
  static const QPainterPath kPentagon = closed(QPolygonF({{0, -13}, {7, -3}, {7, 11}, {-7, 11}, {-7, -3}}));
  const Placed placed(painter, at, angle_deg);
  paint(painter, {kPentagon, Role::ship}, look, colours);
  const bool filled = look == SymbolLook{};
  dot(painter, 2.0, filled ? Role::halo : Role::ship, colours);
}

void draw_hull(QPainter& painter, QPointF at, double angle_deg, const Hull& hull, double metres_per_px,
               SymbolLook look, const Colours& colours) {
  const double ahead = hull.bow_m / metres_per_px, length = hull.length_m / metres_per_px;
  const double side = hull.beam_m / metres_per_px / 2.0;
  // Shoulders at 55 % of the way from the reference point to the bow; with the reference point near the bow
  // or abaft the stern that would bend the hull, so they stay within bounds.
  const double shoulder = std::clamp(0.55 * ahead, ahead - 0.45 * length, ahead - 0.05 * length);
  const Shape shape{closed(QPolygonF({{0, -ahead},
                                      {side, -shoulder},
                                      {side, length - ahead},
                                      {-side, length - ahead},
                                      {-side, -shoulder}})),
                    Role::ship, 2.0, 0.28};
  const Placed placed(painter, at, angle_deg);
  paint(painter, shape, look, colours);
  QPainterPath cross;
  cross.moveTo(-5, 0);
  cross.lineTo(5, 0);
  cross.moveTo(0, -5);
  cross.lineTo(0, 5);
  stroke_haloed(painter, cross, {Role::ship, 1.6}, Halo::line, colours);
}

void draw_vehicle(QPainter& painter, QPointF at, double angle_deg, SymbolLook look, const Colours& colours) {
  static const QPainterPath kArrow = closed(QPolygonF({{0, -14}, {8.5, 10}, {0, 5}, {-8.5, 10}}));
  const Placed placed(painter, at, angle_deg);
  paint(painter, {kArrow, Role::vehicle}, look, colours);
}

void draw_target(QPainter& painter, QPointF at, SymbolLook look, const Colours& colours) {
  static const QPainterPath kCircle = [] {
    QPainterPath path;
    path.addEllipse(QPointF(), kTargetEdge_px, kTargetEdge_px);
    return path;
  }();
  const QString name = QStringLiteral("target %1 %2").arg(static_cast<int>(look.state)).arg(look.simulated);
  draw_stamp(painter, at, name, 16, colours, [&](QPainter& inside, QPointF middle) {
    const Placed placed(inside, middle, 0.0);
    paint(inside, {kCircle, Role::target, 2.4, 0.18}, look, colours);
    dot(inside, 3.2, Role::halo, colours);
    dot(inside, 2.0, Role::target, colours);
  });
}

void draw_brackets(QPainter& painter, QPointF at, Role role, const Colours& colours) {
  constexpr double kHalf = 16.0, kArm = 7.0;
  QPainterPath corners;
  for (const double x : {-1.0, 1.0}) {
    for (const double y : {-1.0, 1.0}) {
      corners.moveTo(x * kHalf, y * (kHalf - kArm));
      corners.lineTo(x * kHalf, y * kHalf);
      corners.lineTo(x * (kHalf - kArm), y * kHalf);
    }
  }
  const Placed placed(painter, at, 0.0);
  QPen halo = halo_pen(0.0, Halo::symbol, colours);
  halo.setWidthF(4.5);
  painter.strokePath(corners, halo);
  painter.strokePath(corners, pen_of({role, 1.8}, colours));
}

}  // namespace leadline::ui
