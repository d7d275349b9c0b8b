#include "ui/chart/watermark.h"

#include <QFontMetricsF>
#include <QPainterPath>
#include <cmath>

#include "ui/look/look.h"

namespace leadline::ui {

void draw_replay_watermark(QPainter& painter, const QRect& exposed, const Colours& colours) {
  constexpr double kAcross_px = 420.0, kDown_px = 210.0;
  QFont large = font(28, true);
  large.setPixelSize(64);
  const QString word = QStringLiteral("REPLAY");
  QPainterPath text;
  text.addText({}, large, word);
  QTransform turn;
  turn.rotate(-24.0);
  const QPointF middle = text.boundingRect().center();
  const QPainterPath mark = turn.map(text.translated(-middle));
  const QRectF reach = mark.boundingRect();

  painter.save();
  painter.setClipRect(exposed, Qt::IntersectClip);
  painter.setRenderHint(QPainter::Antialiasing);
  const QColor violet = colours.of(Role::replay, 0.17);
  const int first = static_cast<int>(std::floor((exposed.top() - reach.bottom()) / kDown_px));
  const int last = static_cast<int>(std::ceil((exposed.bottom() - reach.top()) / kDown_px));
  for (int row = first; row <= last; ++row) {
    const double shift = (row % 2 == 0 ? 0.30 : 0.80) * kAcross_px;
    const double y = (row + 0.45) * kDown_px;
    const int left = static_cast<int>(std::floor((exposed.left() - reach.right() - shift) / kAcross_px));
    const int right = static_cast<int>(std::ceil((exposed.right() - reach.left() - shift) / kAcross_px));
    for (int column = left; column <= right; ++column) {
      const QPointF at(column * kAcross_px + shift, y);
      if (!reach.translated(at).intersects(exposed)) continue;
      painter.fillPath(mark.translated(at), violet);
    }
  }
  painter.restore();
}

}  // namespace leadline::ui
