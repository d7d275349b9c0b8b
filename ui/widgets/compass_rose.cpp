#include "ui/widgets/compass_rose.h"

#include <QPainterPath>
#include <cmath>

#include "ui/look/look.h"
#include "ui/widgets/paint_text.h"
#include "ui/widgets/tile_painter.h"

namespace leadline::ui {
namespace {

constexpr double kRing = 67;

QPointF toward(double bearing_deg, double r) {
  const double a = bearing_deg * M_PI / 180.0;
  return {r * std::sin(a), -r * std::cos(a)};
}

void draw_dial(QPainter& painter, const Colours& colours) {
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(colours.of(Role::line), 1.2));
  painter.drawEllipse(QPointF(), kRing, kRing);
  for (int bearing = 0; bearing < 360; bearing += 10) {
    const bool main = bearing % 30 == 0;
    painter.setPen(QPen(colours.of(Role::text_2), main ? 1.4 : 1.0));
    painter.drawLine(toward(bearing, kRing), toward(bearing, kRing - (main ? 9 : 5)));
  }
  const char* const names[]{"N", "E", "S", "W"};
  for (int i = 0; i < 4; ++i) {
    const QFont letter = font(13, i == 0);
    const QPointF at = toward(90 * i, kRing - 19);
    draw_text_centred(painter, {at.x(), base_line(at.y(), letter)}, QString::fromLatin1(names[i]), letter,
                      colours.of(Role::text));
  }
}

QPainterPath own_shape(Role own) {
  QPainterPath path;
  if (own == Role::ship)
    path.addPolygon(QPolygonF{{{0, -26}, {11, -8}, {11, 22}, {-11, 22}, {-11, -8}}});
  else
    path.addPolygon(QPolygonF{{{0, -32}, {15, 22}, {0, 11}, {-15, 22}}});
  path.closeSubpath();
  return path;
}

void draw_current(QPainter& painter, double to_deg, const Colours& colours) {
  painter.save();
  painter.rotate(to_deg);
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(colours.of(Role::text_2), 1.4, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  painter.drawLine(QPointF(-1.8, -25), QPointF(-1.8, -39));
  painter.drawLine(QPointF(1.8, -25), QPointF(1.8, -39));
  painter.drawPolyline(QPolygonF{{{-6, -36}, {0, -44}, {6, -36}}});
  painter.restore();
}

}  // namespace

void draw_compass_rose(QPainter& painter, QPointF centre, const RoseAngles& angles, Role own,
                       const Colours& colours) {
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  painter.translate(centre);
  draw_dial(painter, colours);
  if (angles.current_to_deg) draw_current(painter, *angles.current_to_deg, colours);
  if (angles.course_deg) {
    QPen pen(colours.of(Role::text_2), 1.4);
    pen.setDashPattern({4, 3});
    painter.setPen(pen);
    painter.drawLine(toward(*angles.course_deg, 24), toward(*angles.course_deg, kRing - 10));
  }
  if (angles.heading_deg && angles.state != ValueState::lost) {
    const bool whole = angles.state != ValueState::stale;
    painter.save();
    painter.rotate(*angles.heading_deg);
    QPen edge(colours.of(own), 1.6, Qt::SolidLine, Qt::FlatCap, Qt::MiterJoin);
    if (angles.simulated) edge.setDashPattern({4, 2.5});
    painter.setPen(edge);
    painter.setBrush(whole && !angles.simulated ? colours.of(own) : colours.of(own, 0.2));
    painter.drawPath(own_shape(own));
    painter.setPen(QPen(colours.of(own), 1.6));
    painter.drawLine(QPointF(0, own == Role::ship ? -26 : -32), QPointF(0, -(kRing - 10)));
    painter.restore();
  }
  if (angles.set_heading_deg) {
    painter.save();
    painter.rotate(*angles.set_heading_deg);
    painter.setBrush(colours.of(Role::bg_tile));
    painter.setPen(QPen(colours.of(Role::plan), 1.6, Qt::SolidLine, Qt::FlatCap, Qt::MiterJoin));
    const QPolygonF bug{{{0, -kRing + 4}, {5.5, -kRing - 5}, {-5.5, -kRing - 5}}};
    painter.drawPolygon(bug);
    painter.restore();
  }
  painter.restore();
}

CompassRose::CompassRose(Role own, QWidget* parent) : QWidget(parent), own_(own) {
  setAccessibleName(QStringLiteral("Compass rose"));
}

void CompassRose::set(const std::optional<RoseAngles>& angles) {
  if (angles == angles_) return;
  angles_ = angles;
  update();
}

void CompassRose::paintEvent(QPaintEvent* /*event*/) {
  if (!angles_) return;
  QPainter painter(this);
  const Colours& colours = Look::current().colours();
  // The ground of a tile in the same state, without its words.
  TileText ground;
  ground.replay = angles_->replay;
  ground.simulated = angles_->simulated;
  draw_tile_ground(painter, rect(), ground, colours);
  draw_compass_rose(painter, QRectF(rect()).center(), *angles_, own_, colours);
}

}  // namespace leadline::ui
