#include "ui/chart/overview.h"

#include <QImage>
#include <QPainter>

#include "core/geo/geodesy.h"
#include "ui/look/halo_text.h"
#include "ui/look/look.h"
#include "ui/models/figures.h"

namespace leadline::ui {
namespace {

constexpr double kStandsStill_m = 2'000.0;  ///< below a pixel at any of its scales

struct Scale {
  double metres_per_px, bar_m;
};
constexpr Scale kScales[] = {{2'500.0, 100'000.0}, {8'000.0, 500'000.0}, {25'000.0, 1'000'000.0}};

bool shows_land(const QImage& picture, const Colours& colours) {
  const QRgb land = colours.of(Role::land).rgb();
  for (int y = 0; y < picture.height(); y += 2)
    for (int x = 0; x < picture.width(); x += 2)
      if (picture.pixel(x, y) == land) return true;
  return false;
}

void paint_bar(QPainter& painter, const Scale& scale, const Colours& colours) {
  const double length = scale.bar_m / scale.metres_per_px;
  const QPointF left(8.5, Overview::kSize.height() - 12.5);
  for (const auto& [role, width] : {std::pair(Role::halo, 3.6), std::pair(Role::ink, 1.4)}) {
    painter.setPen(QPen(colours.of(role), width, Qt::SolidLine, Qt::SquareCap));
    painter.drawPolyline(
        QPolygonF({left - QPointF(0, 4), left, left + QPointF(length, 0), left + QPointF(length, -4)}));
  }
  draw_halo_text(painter, left + QPointF(length + 8, 1),
                 QString::fromStdString(number_text(scale.bar_m / 1e3, 0) + " km"), font(12), Role::ink,
                 colours);
}

}  // namespace

void Overview::paint(QPainter& painter, QPoint top_left, const Background& background, Geodetic centre,
                     const Colours& colours) {
  const bool moved = picture_.isNull() || geo::geodesic(centre_, centre).distance_m > kStandsStill_m;
  if (moved || colours_ != colours) {
    QImage picture(kSize, QImage::Format_RGB32);
    for (const Scale& scale : kScales) {
      QPainter p(&picture);
      p.setRenderHint(QPainter::Antialiasing);
      background.paint_overview(p, QRect(QPoint(0, 0), kSize), centre, scale.metres_per_px, colours);
      const bool near = shows_land(picture, colours);
      if (!near && &scale != std::end(kScales) - 1) continue;
      p.setRenderHint(QPainter::Antialiasing);
      paint_bar(p, scale, colours);
      break;
    }
    picture_ = QPixmap::fromImage(picture);
    centre_ = centre;
    colours_ = colours;
  }
  painter.drawPixmap(top_left, picture_);
}

}  // namespace leadline::ui
