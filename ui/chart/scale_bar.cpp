#include "ui/chart/scale_bar.h"

#include <QFontMetricsF>
#include <cmath>

#include "core/geo/geodesy.h"
#include "ui/chart/halo.h"
#include "ui/look/halo_text.h"
#include "ui/look/look.h"

namespace leadline::ui {
namespace {

constexpr double kLeft_px = 18.0;
constexpr double kFoot_px = 28.0;  // the graticule's figures stand below
constexpr double kBar_px = 7.0;
constexpr double kLongest_px = 260.0;

// True metres a px across the view's middle, which is where they are measured.
double true_metres_per_px(const ChartView& view, double over_px) {
  const QPointF middle(view.size().width() / 2.0, view.size().height() / 2.0), half(over_px / 2.0, 0.0);
  const double distance_m =
      geo::geodesic(view.to_geodetic(middle - half), view.to_geodetic(middle + half)).distance_m;
  return distance_m / over_px;
}

bool in_km(const ScaleBar& scale) { return scale.length_m >= 1'000.0; }
QString figure_of(const ScaleBar& scale, int quarter) {
  return QString::number(scale.length_m * quarter / 4.0 / (in_km(scale) ? 1'000.0 : 1.0), 'g', 6);
}
QString unit_of(const ScaleBar& scale) { return in_km(scale) ? QStringLiteral(" km") : QStringLiteral(" m"); }

QRectF bar_of(const ChartView& view, double length_px) {
  return {kLeft_px, view.size().height() - kFoot_px - kBar_px, length_px, kBar_px};
}

}  // namespace

ScaleBar scale_bar(const ChartView& view) {
  const double room_m = kLongest_px * true_metres_per_px(view, kLongest_px);
  const double power = std::pow(10.0, std::floor(std::log10(room_m)));
  ScaleBar bar{power, 0.0};
  for (const double times : {2.0, 5.0})
    if (times * power <= room_m) bar.length_m = times * power;
  bar.length_px = bar.length_m / true_metres_per_px(view, kLongest_px);
  bar.length_px = bar.length_m / true_metres_per_px(view, bar.length_px);
  return bar;
}

QRectF scale_bar_box(const ChartView& view) {
  const ScaleBar scale = scale_bar(view);
  const QFontMetricsF metrics(font(12));
  const QString last = figure_of(scale, 4);
  const double beyond =
      metrics.horizontalAdvance(last + unit_of(scale)) - metrics.horizontalAdvance(last) / 2.0;
  return bar_of(view, scale.length_px).adjusted(-8.0, -8.0 - metrics.ascent(), beyond + 4.0, 4.0);
}

QRectF draw_scale_bar(QPainter& painter, const ChartView& view, const Colours& colours) {
  const ScaleBar scale = scale_bar(view);
  const QRectF bar = bar_of(view, scale.length_px);
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  QPainterPath edge;
  edge.addRect(bar);
  painter.strokePath(edge, halo_pen(1.2, Halo::line, colours));
  painter.fillPath(edge, colours.of(Role::halo));
  for (const int quarter : {0, 2}) {
    painter.fillRect(QRectF(bar.left() + bar.width() * quarter / 4.0, bar.top(), bar.width() / 4.0, kBar_px),
                     colours.of(Role::ink));
  }
  painter.strokePath(edge, pen_of({Role::ink, 1.2}, colours));

  const QFont small = font(12);
  const QFontMetricsF metrics(small);
  for (const int quarter : {0, 1, 2, 4}) {
    const QString text = figure_of(scale, quarter);
    const QPointF at(bar.left() + bar.width() * quarter / 4.0 - metrics.horizontalAdvance(text) / 2.0,
                     bar.top() - 5.0);
    draw_halo_text(painter, at, quarter == 4 ? text + unit_of(scale) : text, small, Role::ink, colours);
  }
  painter.restore();
  return scale_bar_box(view);
}

}  // namespace leadline::ui
