#include "ui/look/halo_text.h"

#include <QCache>
#include <QCoreApplication>
#include <QFontMetricsF>
#include <QPainterPath>
#include <QPixmap>
#include <cmath>

namespace leadline::ui {
namespace {

constexpr int kCachedPixels = 4'000'000;
constexpr double kHaloPx = 3.0, kHaloOpacity = 0.85;
constexpr int kMargin = 3;  // round of the halo, and antialiasing

struct Glyphs {
  QPixmap picture;
  QPoint base;  // left end of the base line within it, px
};

QCache<QString, Glyphs>& cache() {
  static QCache<QString, Glyphs> kept(kCachedPixels);
  static const bool cleared_in_time = [] {
    qAddPostRoutine([] { cache().clear(); });  // no pixmap outlives the application
    return true;
  }();
  Q_UNUSED(cleared_in_time)
  return kept;
}

Glyphs render(const QString& text, const QFont& font, const QColor& colour, const QColor& halo,
              double ratio) {
  QPainterPath path;
  path.addText(0, 0, font, text);
  const QRect box = path.boundingRect().toAlignedRect().adjusted(-kMargin, -kMargin, kMargin, kMargin);
  QPixmap picture((QSizeF(box.size()) * ratio).toSize());
  picture.setDevicePixelRatio(ratio);
  picture.fill(Qt::transparent);
  QPainter painter(&picture);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.translate(-box.topLeft());
  painter.strokePath(path, QPen(halo, kHaloPx, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  painter.fillPath(path, colour);
  return {picture, -box.topLeft()};
}

}  // namespace

void draw_halo_text(QPainter& painter, QPointF at, const QString& text, const QFont& font, Role role,
                    const Colours& colours) {
  if (text.isEmpty()) return;
  const double ratio = painter.device()->devicePixelRatioF();
  const QColor colour = colours.of(role), halo = colours.of(Role::halo, kHaloOpacity);
  const QString key = QString::number(colour.rgb(), 36) + QLatin1Char(' ') + QString::number(halo.rgb(), 36) +
                      QLatin1Char(' ') + QString::number(ratio) + font.key() + QLatin1Char('\n') + text;
  const Glyphs* glyphs = cache().object(key);
  Glyphs made;
  if (!glyphs) {
    made = render(text, font, colour, halo, ratio);
    const QSize size = made.picture.size();
    cache().insert(key, new Glyphs(made), size.width() * size.height());
    glyphs = &made;  // the cache may have refused it
  }
  const QPointF device = painter.transform().map(at);
  const QTransform kept = painter.transform();
  painter.resetTransform();
  painter.drawPixmap(
      QPoint(static_cast<int>(std::lround(device.x())), static_cast<int>(std::lround(device.y()))) -
          glyphs->base,
      glyphs->picture);
  painter.setTransform(kept);
}

}  // namespace leadline::ui
