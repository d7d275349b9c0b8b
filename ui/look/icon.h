#pragma once

#include <QColor>
#include <QPixmap>
#include <QRectF>
#include <QString>

class QPainter;

namespace leadline::ui {

/// The icon ui/resources/icons/<name>.svg, `px` wide and high, in one colour; from a bounded cache.
/// GUI thread. Aborts when there is no such icon.
[[nodiscard]] QPixmap icon(const QString& name, int px, const QColor& colour, double device_ratio = 1.0);

/// Draws it centred on a whole pixel.
void draw_icon(QPainter& painter, QPointF centre, const QString& name, int px, const QColor& colour);

}  // namespace leadline::ui
