#include "ui/chart/orientation_box.h"

#include <QFontMetricsF>
#include <algorithm>
#include <cmath>

#include "ui/chart/furniture_panel.h"
#include "ui/chart/halo.h"
#include "ui/look/look.h"
#include "ui/models/figures.h"

namespace leadline::ui {
namespace {

constexpr double kTextLeft_px = 68.0, kHeight_px = 70.0;

QString motion_text(const OrientationFacts& facts) {
  const QString motion = facts.motion == Motion::true_motion ? QStringLiteral("TM") : QStringLiteral("RM");
  return facts.follow.isEmpty() ? motion : motion + QStringLiteral(" · follow ") + facts.follow;
}

// Turns about the middle of arrow and letter together, so that both stay in the box at any angle.
void draw_north_arrow(QPainter& painter, QPointF middle, double north_deg, const Colours& colours) {
  const auto polygon = [](std::initializer_list<QPointF> points) {
    QPainterPath path;
    path.addPolygon(QPolygonF(QVector<QPointF>(points)));
    path.closeSubpath();
    return path;
  };
  const QPainterPath whole = polygon({{0, -20}, {11, 20}, {0, 13}, {-11, 20}});
  const QPainterPath right = polygon({{0, -20}, {11, 20}, {0, 13}});
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  painter.translate(middle);
  painter.rotate(north_deg);
  painter.translate(0, -7);
  QPen halo = halo_pen(1.2, Halo::symbol, colours);
  painter.strokePath(whole, halo);
  painter.fillPath(whole, colours.of(Role::halo));
  painter.fillPath(right, colours.of(Role::ink));
  QPen edge = pen_of({Role::ink, 1.2}, colours);
  edge.setJoinStyle(Qt::RoundJoin);
  painter.strokePath(whole, edge);
  painter.translate(0, 27);
  painter.rotate(-north_deg);  // letters stand upright
  painter.setFont(font(12, true));
  painter.setPen(colours.of(Role::ink));
  painter.drawText(QRectF(-10, -8, 20, 16), Qt::AlignCenter, QStringLiteral("N"));
  painter.restore();
}

}  // namespace

QRectF orientation_box(const ChartView& view, const OrientationFacts& facts) {
  const double text = QFontMetricsF(font(13)).horizontalAdvance(motion_text(facts));
  const double room = view.size().width() - 2.0 * kFurnitureMargin_px;
  const double width = std::min(std::max(184.0, std::ceil(kTextLeft_px + text + 12.0)), room);
  return {view.size().width() - kFurnitureMargin_px - width, kFurnitureMargin_px, width, kHeight_px};
}

QRectF draw_orientation_box(QPainter& painter, const ChartView& view, const OrientationFacts& facts,
                            const Colours& colours) {
  const QRectF box = orientation_box(view, facts);
  draw_furniture_panel(painter, box, colours);
  draw_north_arrow(painter, box.topLeft() + QPointF(33, 35), view.screen_angle_deg(Angle(), view.centre()),
                   colours);

  const char* up = facts.orientation == Orientation::north_up  ? "N UP"
                   : facts.orientation == Orientation::head_up ? "H UP"
                                                               : "C UP";
  painter.save();
  painter.setPen(colours.of(Role::text));
  const double width = box.width() - kTextLeft_px - 8.0;
  const auto line = [&](double top, const QFont& of, const QString& text) {
    painter.setFont(of);
    painter.drawText(QRectF(box.left() + kTextLeft_px, box.top() + top, width, 20.0),
                     Qt::AlignLeft | Qt::AlignVCenter,
                     QFontMetricsF(of).elidedText(text, Qt::ElideRight, width));
  };
  line(5.0, font(15, true), QString::fromLatin1(up));
  line(25.0, font(13), motion_text(facts));
  line(44.0, font(13), QString::fromStdString(scale_text(scale_denominator(view.metres_per_px()))));
  painter.restore();
  return box;
}

}  // namespace leadline::ui
