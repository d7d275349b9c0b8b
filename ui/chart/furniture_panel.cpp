#include "ui/chart/furniture_panel.h"

namespace leadline::ui {

void draw_furniture_panel(QPainter& painter, QRectF box, const Colours& colours) {
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing, false);
  painter.fillRect(box, colours.of(Role::bg_panel));
  painter.setPen(QPen(colours.of(Role::line), 1.0));
  painter.setBrush(Qt::NoBrush);
  painter.drawRect(box.adjusted(0, 0, -1, -1));
  painter.restore();
}

}  // namespace leadline::ui
