#pragma once

#include <QImage>
#include <QLineF>
#include <QPainter>
#include <cmath>
#include <cstdlib>
#include <string>

#include "core/types/angle.h"
#include "ui/chart/chart_view.h"
#include "ui/look/colours.h"

namespace leadline::ui::test {

/// What `paint` draws on a ground of one role, enlarged `times` for exact looks at small shapes.
template <class Paint>
QImage drawn(QSize size, const Colours& colours, Role ground, double times, const Paint& paint) {
  QImage image(size * times, QImage::Format_RGB32);
  image.fill(colours.of(ground));
  QPainter painter(&image);
  painter.scale(times, times);
  paint(painter);
  return image;
}

inline int apart(QRgb a, QColor b) {
  return std::abs(qRed(a) - b.red()) + std::abs(qGreen(a) - b.green()) + std::abs(qBlue(a) - b.blue());
}
inline bool is(const QImage& image, QPoint at, QColor colour, int tolerance = 60) {
  return image.rect().contains(at) && apart(image.pixel(at), colour) <= tolerance;
}

/// The pixel of a colour that is furthest from a point, as the line from there: a symbol's tip.
inline QLineF furthest(const QImage& image, QPointF from, QColor colour, int tolerance = 60) {
  QLineF best(from, from);
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) {
      if (!is(image, {x, y}, colour, tolerance)) continue;
      const QLineF line(from, {x + 0.5, y + 0.5});
      if (line.length() > best.length()) best = line;
    }
  }
  return best;
}

/// Clockwise from the top of the screen, [0, 360).
inline double screen_bearing_deg(QLineF line) {
  return Angle::rad(std::atan2(line.dx(), -line.dy())).wrapped_2pi().deg();
}
inline double turn_deg(double from_deg, double to_deg) { return std::remainder(to_deg - from_deg, 360.0); }

/// How many pixels of two pictures differ at all.
inline int differing(const QImage& a, const QImage& b) {
  int count = 0;
  for (int y = 0; y < a.height(); ++y)
    for (int x = 0; x < a.width(); ++x) count += a.pixel(x, y) != b.pixel(x, y) ? 1 : 0;
  return count;
}

inline Geodetic at_deg(double lat, double lon) { return {Angle::deg(lat), Angle::deg(lon)}; }

/// Save under /tmp to look at: LEADLINE_LOOK=1.
inline void look_at(const QImage& image, const std::string& name) {
  if (qEnvironmentVariableIsSet("LEADLINE_LOOK"))
    image.save(QStringLiteral("/tmp/leadline-%1.png").arg(QString::fromStdString(name)));
}

}  // namespace leadline::ui::test
