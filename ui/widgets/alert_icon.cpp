#include "ui/widgets/alert_icon.h"

#include <QPainterPath>
#include <cmath>

#include "ui/look/icon.h"

namespace leadline::ui {
namespace {

QPainterPath triangle(QPointF centre, double size) {
  QPainterPath path(centre + QPointF(0, -0.52 * size));
  path.lineTo(centre + QPointF(0.56 * size, 0.44 * size));
  path.lineTo(centre + QPointF(-0.56 * size, 0.44 * size));
  path.closeSubpath();
  return path;
}

QString glyph_of(Alarm::Priority priority, AlertMark mark) {
  switch (mark) {
    case AlertMark::unacknowledged:
      return priority == Alarm::Priority::caution ? QStringLiteral("exclamation") : QStringLiteral("speaker");
    case AlertMark::silenced:
      return priority == Alarm::Priority::caution ? QStringLiteral("exclamation")
                                                  : QStringLiteral("speaker-off");
    case AlertMark::acknowledged:
      return QStringLiteral("exclamation");
    case AlertMark::rectified:
      return QStringLiteral("check");
  }
  return {};
}

}  // namespace

AlertRoles alert_roles(Alarm::Priority priority) {
  switch (priority) {
    case Alarm::Priority::caution:
      return {Role::caution, Role::caution_on, Role::caution_mark, Role::caution_icon, Role::caution_glyph};
    case Alarm::Priority::warning:
      return {Role::warning, Role::warning_on, Role::warning_mark, Role::warning_icon, Role::warning_glyph};
    case Alarm::Priority::alarm:
    case Alarm::Priority::emergency:
      break;
  }
  return {Role::alarm, Role::alarm_on, Role::alarm_mark, Role::alarm_icon, Role::alarm_glyph};
}

const char* alert_word(Alarm::Priority priority) {
  switch (priority) {
    case Alarm::Priority::caution:
      return "CAUTION";
    case Alarm::Priority::warning:
      return "WARNING";
    case Alarm::Priority::alarm:
      return "ALARM";
    case Alarm::Priority::emergency:
      break;
  }
  return "EMERGENCY";
}

void draw_alert_icon(QPainter& painter, QPointF centre, double size, Alarm::Priority priority, AlertMark mark,
                     const Colours& colours, AlertGround ground) {
  const AlertRoles roles = alert_roles(priority);
  const bool on_fill = ground == AlertGround::fill;
  const QColor shape = colours.of(on_fill ? roles.on : roles.icon);
  const QColor glyph = colours.of(on_fill ? roles.fill : roles.glyph);
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  const QColor edge = on_fill ? shape : colours.of(roles.mark);
  painter.setPen(QPen(edge, 1.3, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  painter.setBrush(shape);
  QPointF middle = centre;
  double room = 0.66;
  switch (priority) {
    case Alarm::Priority::caution:
      painter.drawRect(QRectF(centre.x() - 0.45 * size, centre.y() - 0.45 * size, 0.9 * size, 0.9 * size));
      break;
    case Alarm::Priority::warning:
      painter.drawEllipse(centre, 0.48 * size, 0.48 * size);
      break;
    case Alarm::Priority::emergency: {
      const QPointF behind = centre + QPointF(-0.30 * size, 0);
      painter.drawPath(triangle(behind, size));
      middle = centre + QPointF(0.22 * size, 0);
      painter.setPen(
          QPen(on_fill ? glyph : colours.of(Role::bg_tile), 1.3, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
      [[fallthrough]];
    }
    case Alarm::Priority::alarm:
      painter.drawPath(triangle(middle, size));
      middle += QPointF(0, 0.12 * size);
      room = 0.56;
      break;
  }
  draw_icon(painter, middle, glyph_of(priority, mark), static_cast<int>(std::lround(size * room)), glyph);
  painter.restore();
}

}  // namespace leadline::ui
