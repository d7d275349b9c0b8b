#include "ui/widgets/paint_text.h"

#include <QFontMetricsF>
#include <cmath>

#include "ui/look/look.h"

namespace leadline::ui {

double text_width(const QString& text, const QFont& font) {
  return QFontMetricsF(font).horizontalAdvance(text);
}

QString elided(const QString& text, const QFont& font, double width) {
  return QFontMetricsF(font).elidedText(text, Qt::ElideRight, std::max(0.0, width));
}

double draw_text(QPainter& painter, QPointF at, const QString& text, const QFont& font,
                 const QColor& colour) {
  if (text.isEmpty()) return at.x();
  painter.setFont(font);
  painter.setPen(colour);
  painter.drawText(at, text);
  return at.x() + text_width(text, font);
}

double draw_text_right(QPainter& painter, QPointF at, const QString& text, const QFont& font,
                       const QColor& colour) {
  const double left = at.x() - text_width(text, font);
  draw_text(painter, {left, at.y()}, text, font, colour);
  return left;
}

void draw_text_centred(QPainter& painter, QPointF at, const QString& text, const QFont& font,
                       const QColor& colour) {
  draw_text(painter, {at.x() - text_width(text, font) / 2, at.y()}, text, font, colour);
}

double base_line(double y, const QFont& font) { return std::round(y + QFontMetricsF(font).capHeight() / 2); }

QFont title_font() {
  QFont made = font(12, true);
  made.setLetterSpacing(QFont::AbsoluteSpacing, 0.3);
  return made;
}

void draw_hatch(QPainter& painter, const QRectF& rect, const QColor& stripe) {
  painter.save();
  painter.setClipRect(rect, Qt::IntersectClip);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(QPen(stripe, 3.0, Qt::SolidLine, Qt::FlatCap));
  const double step = 9.0 * std::sqrt(2.0), h = rect.height();
  for (double x = rect.left() - h; x < rect.right() + step; x += step)
    painter.drawLine(QPointF(x - 3, rect.bottom() + 3), QPointF(x + h + 3, rect.top() - 3));
  painter.restore();
}

void draw_rule(QPainter& painter, QPoint from, QPoint to, const QColor& colour) {
  const QPoint a(std::min(from.x(), to.x()), std::min(from.y(), to.y()));
  painter.fillRect(QRect(a, QSize(std::abs(to.x() - from.x()) + 1, std::abs(to.y() - from.y()) + 1)), colour);
}

}  // namespace leadline::ui
