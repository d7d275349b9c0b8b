#include "ui/chart/stamp.h"

#include <QPixmapCache>
#include <cmath>

namespace leadline::ui {

void draw_stamp(QPainter& painter, QPointF at, const QString& name, int half_px, const Colours& colours,
                const std::function<void(QPainter&, QPointF)>& paint) {
  constexpr int kPhases = 4;
  const QPointF corner(std::floor(at.x()), std::floor(at.y()));
  const int phase_x = static_cast<int>((at.x() - corner.x()) * kPhases);
  const int phase_y = static_cast<int>((at.y() - corner.y()) * kPhases);
  const double ratio = painter.device()->devicePixelRatioF();
  const QString key = QStringLiteral("%1 %2 %3 %4 %5 %6")
                          .arg(name)
                          .arg(static_cast<int>(colours.palette()))
                          .arg(colours.luminance())
                          .arg(ratio)
                          .arg(phase_x)
                          .arg(phase_y);
  QPixmap mark;
  if (!QPixmapCache::find(key, &mark)) {
    mark = QPixmap(QSize(2 * half_px, 2 * half_px) * ratio);
    mark.setDevicePixelRatio(ratio);
    mark.fill(Qt::transparent);
    QPainter inside(&mark);
    inside.setRenderHint(QPainter::Antialiasing);
    paint(inside, {half_px + (phase_x + 0.5) / kPhases, half_px + (phase_y + 0.5) / kPhases});
    inside.end();
    QPixmapCache::insert(key, mark);
  }
  painter.drawPixmap(corner - QPointF(half_px, half_px), mark);
}

}  // namespace leadline::ui
