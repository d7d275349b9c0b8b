#include "ui/look/icon.h"

#include <QCache>
#include <QCoreApplication>
#include <QFile>
#include <QPainter>
#include <QSvgRenderer>
#include <cmath>

#include "core/types/expect.h"

namespace leadline::ui {
namespace {

constexpr int kCachedPixels = 1'000'000;

QCache<QString, QPixmap>& cache() {
  static QCache<QString, QPixmap> kept(kCachedPixels);
  static const bool cleared_in_time = [] {
    qAddPostRoutine([] { cache().clear(); });  // no pixmap outlives the application
    return true;
  }();
  Q_UNUSED(cleared_in_time)
  return kept;
}

QPixmap render(const QString& name, int device_px, const QColor& colour) {
  QFile file(QStringLiteral(":/icons/%1.svg").arg(name));
  LL_EXPECT(file.open(QIODevice::ReadOnly));
  QByteArray svg = file.readAll();
  svg.replace("currentColor", colour.name().toLatin1());
  QSvgRenderer renderer(svg);
  QPixmap picture(device_px, device_px);
  picture.fill(Qt::transparent);
  QPainter painter(&picture);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setOpacity(colour.alphaF());
  renderer.render(&painter);
  return picture;
}

}  // namespace

QPixmap icon(const QString& name, int px, const QColor& colour, double device_ratio) {
  const int device_px = static_cast<int>(std::lround(px * device_ratio));
  const QString key = name + QLatin1Char(' ') + QString::number(device_px) + QLatin1Char(' ') +
                      QString::number(colour.rgba(), 16);
  if (const QPixmap* kept = cache().object(key)) return *kept;
  QPixmap made = render(name, device_px, colour);
  made.setDevicePixelRatio(device_ratio);
  cache().insert(key, new QPixmap(made), device_px * device_px);
  return made;
}

void draw_icon(QPainter& painter, QPointF centre, const QString& name, int px, const QColor& colour) {
  const QPointF corner(std::round(centre.x() - px / 2.0), std::round(centre.y() - px / 2.0));
  painter.drawPixmap(corner, icon(name, px, colour, painter.device()->devicePixelRatioF()));
}

}  // namespace leadline::ui
