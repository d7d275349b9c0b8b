#include "ui/chart/graticule.h"

#include <QFontMetricsF>
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "core/geo/geodesy.h"
#include "core/types/expect.h"
#include "ui/look/halo_text.h"
#include "ui/look/look.h"

namespace leadline::ui {
namespace {

constexpr double kNearest_px = 110.0, kFurthest_px = 260.0;
constexpr double kCrowded_px = 14.0;  // meridians near a pole
constexpr double kQuarter_min = 90.0 * 60.0;

struct NiceStep {
  double min;
  bool preferred;
};
// From 0.05' to 0.1' and on by 2 and 2.5; 2.5 alone is more than 260 / 110, so a 25 helps out between.
constexpr std::array<NiceStep, 22> kSteps{
    {{0.01, true},  {0.02, true},  {0.025, false}, {0.05, true},  {0.1, true},   {0.2, true},
     {0.25, false}, {0.5, true},   {1.0, true},    {2.0, true},   {3.0, false},  {5.0, true},
     {10.0, true},  {20.0, true},  {30.0, true},   {60.0, true},  {120.0, true}, {180.0, false},
     {300.0, true}, {600.0, true}, {900.0, true},  {1800.0, true}}};

double step_for(double px_per_min) {
  double best = kSteps.front().min;
  double best_cost = 1e300;
  for (const NiceStep& step : kSteps) {
    const double px = step.min * px_per_min;
    const double outside = px < kNearest_px ? kNearest_px / px : px > kFurthest_px ? px / kFurthest_px : 1.0;
    // Within the range the preferred ones, and the finer first.
    const double cost = outside > 1.0 ? 1e6 * outside : (step.preferred ? 0.0 : 1e3) + px;
    if (cost < best_cost) {
      best_cost = cost;
      best = step.min;
    }
  }
  return best;
}

double metres_per_lat_min(Angle lat) { return geo::radii(lat).meridian_m * kRadPerDeg / 60.0; }
double metres_per_lon_min(Angle lat) {
  return geo::radii(lat).prime_vertical_m * cos(lat) * kRadPerDeg / 60.0;
}

/// What the screen shows: minutes, longitudes counted on from the centre's.
struct Range {
  double south = 0.0, north = 0.0, west = 0.0, east = 0.0;
  bool pole = false;  ///< all longitudes
};

bool shows(const ChartView& view, Geodetic point) {
  // Far from the origin the plane has no meaning: a pole on the other side of the world is not shown.
  if (geo::geodesic(view.centre(), point).distance_m > 8e6) return false;
  return QRectF(QPointF(), view.size()).contains(view.to_screen(point));
}

Range range_of(const ChartView& view) {
  constexpr int kSamples = 12;
  const double w = view.size().width(), h = view.size().height();
  const Geodetic centre = view.centre();
  Range range{centre.lat.deg() * 60.0, centre.lat.deg() * 60.0, 0.0, 0.0, false};
  const auto take = [&](QPointF at) {
    const Geodetic p = view.to_geodetic(at);
    const double lat = p.lat.deg() * 60.0;
    const double lon = (p.lon - centre.lon).wrapped_pi().deg() * 60.0;
    range.south = std::min(range.south, lat);
    range.north = std::max(range.north, lat);
    range.west = std::min(range.west, lon);
    range.east = std::max(range.east, lon);
  };
  for (int i = 0; i <= kSamples; ++i) {
    const double s = static_cast<double>(i) / kSamples;
    for (const QPointF at : {QPointF(s * w, 0), QPointF(s * w, h), QPointF(0, s * h), QPointF(w, s * h)})
      take(at);
  }
  for (const double pole : {90.0, -90.0}) {
    if (!shows(view, {Angle::deg(pole), centre.lon})) continue;
    range.pole = true;
    (pole > 0.0 ? range.north : range.south) = pole * 60.0;
  }
  // Between two samples of an edge a parallel or a meridian may bulge.
  const double more_lat = (range.north - range.south) * 0.02;
  range.south = std::max(range.south - more_lat, -kQuarter_min);
  range.north = std::min(range.north + more_lat, kQuarter_min);
  const double centre_lon = centre.lon.deg() * 60.0;
  const double more_lon = (range.east - range.west) * 0.02;
  range.west = range.pole ? centre_lon - 10'800.0 : centre_lon + range.west - more_lon;
  range.east = range.pole ? centre_lon + 10'800.0 : centre_lon + range.east + more_lon;
  return range;
}

/// A curve of the globe as a polyline: halved until every middle lies within 0.25 px of its chord.
template <class PlaceAt>
QPolygonF traced(const ChartView& view, const PlaceAt& place_at, double from, double to, int pieces) {
  const auto screen = [&](double t) { return view.to_screen(place_at(t)); };
  QPolygonF points;
  const auto halve = [&](const auto& self, double t0, QPointF p0, double t1, QPointF p1, int depth) -> void {
    const double middle = (t0 + t1) / 2.0;
    const QPointF p = screen(middle);
    const QPointF bow = p - (p0 + p1) / 2.0;
    if (depth > 0 && bow.x() * bow.x() + bow.y() * bow.y() > 0.25 * 0.25) {
      self(self, t0, p0, middle, p, depth - 1);
      self(self, middle, p, t1, p1, depth - 1);
    } else {
      points << p1;
    }
  };
  double t0 = from;
  QPointF p0 = screen(t0);
  points << p0;
  for (int i = 1; i <= pieces; ++i) {
    const double t1 = from + (to - from) * i / pieces;
    const QPointF p1 = screen(t1);
    halve(halve, t0, p0, t1, p1, 8);
    t0 = t1;
    p0 = p1;
  }
  return points;
}

Geodetic place(double lat_min, double lon_min) {
  return {Angle::deg(lat_min / 60.0), geo::normal_longitude(Angle::deg(lon_min / 60.0))};
}

/// The latitude, minutes, where meridians of a step are kCrowded_px apart.
double crowded_lat_min(double lon_step_min, double metres_per_px) {
  const double wanted = kCrowded_px * metres_per_px / lon_step_min;
  double low = 0.0, high = 90.0;
  for (int i = 0; i < 50; ++i) {
    const double middle = (low + high) / 2.0;
    (metres_per_lon_min(Angle::deg(middle)) > wanted ? low : high) = middle;
  }
  return low * 60.0;
}

int decimals(double step_min) {
  for (int n = 0; n < 3; ++n) {
    const double scaled = step_min * std::pow(10.0, n);
    if (std::abs(scaled - std::round(scaled)) < 1e-6) return n;
  }
  return 3;
}

/// Where a line meets the left edge (x = 0) or the lower (y = height), if it does.
std::optional<QPointF> meets(const QPolygonF& line, bool left, QSize size) {
  for (int i = 1; i < line.size(); ++i) {
    const QPointF a = line[i - 1], b = line[i];
    const double da = left ? a.x() : a.y() - size.height();
    const double db = left ? b.x() : b.y() - size.height();
    if ((da <= 0.0) == (db <= 0.0)) continue;
    const QPointF p = a + (b - a) * (da / (da - db));
    const double along = left ? p.y() : p.x();
    if (along >= 0.0 && along <= (left ? size.height() : size.width())) return p;
  }
  return std::nullopt;
}

}  // namespace

GraticuleStep graticule_step(const ChartView& view) {
  const Geodetic centre = view.centre();
  // Where the meridians of a polar view are furthest apart on the screen.
  double lat = std::abs(centre.lat.deg());
  if (lat > 80.0) {
    const QSize size = view.size();
    for (const QPointF corner : {QPointF(0, 0), QPointF(size.width(), 0), QPointF(0, size.height()),
                                 QPointF(size.width(), size.height())})
      lat = std::min(lat, std::abs(view.to_geodetic(corner).lat.deg()));
  }
  const double px = view.metres_per_px();
  return {step_for(metres_per_lat_min(centre.lat) / px), step_for(metres_per_lon_min(Angle::deg(lat)) / px)};
}

std::vector<GraticuleLine> graticule_lines(const ChartView& view, GraticuleStep step) {
  LL_EXPECT(step.lat_min > 0.0 && step.lon_min > 0.0);
  const Range range = range_of(view);
  const int pieces = range.pole ? 24 : 2;
  std::vector<GraticuleLine> lines;

  for (double k = std::ceil(range.south / step.lat_min); k * step.lat_min <= range.north; ++k) {
    const double lat = k * step.lat_min;
    if (std::abs(lat) > kQuarter_min - 1e-6) continue;  // a pole is a point
    lines.push_back({false, lat,
                     traced(
                         view, [&](double lon) { return place(lat, lon); }, range.west, range.east, pieces)});
  }

  const double crowded = crowded_lat_min(step.lon_min, view.metres_per_px());
  const double last = range.pole ? range.east - step.lon_min / 2.0 : range.east;
  for (double k = std::ceil(range.west / step.lon_min); k * step.lon_min <= last; ++k) {
    const double lon = k * step.lon_min;
    const bool to_pole = std::abs(std::remainder(lon, kQuarter_min)) < 1e-6;
    const double south = to_pole ? range.south : std::max(range.south, -crowded);
    const double north = to_pole ? range.north : std::min(range.north, crowded);
    if (north <= south) continue;
    double named = std::remainder(lon, 21'600.0);
    if (named >= 10'800.0 - 1e-6) named -= 21'600.0;
    lines.push_back({true, named,
                     traced(
                         view, [&](double lat) { return place(lat, lon); }, south, north, 2)});
  }
  return lines;
}

void draw_graticule(QPainter& painter, const ChartView& view, GraticuleStep step, const QRect& exposed,
                    const Colours& colours) {
  painter.save();
  painter.setClipRect(exposed, Qt::IntersectClip);
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(colours.of(Role::grid, 0.38), 1.0));
  for (const GraticuleLine& line : graticule_lines(view, step)) {
    const QRectF box = line.points.boundingRect();
    if (!box.adjusted(-1, -1, 1, 1).intersects(exposed)) continue;
    // A line along the px is one px wide and sharp; a turned one is smooth.
    if (box.width() < 0.6) {
      const double x = std::floor(box.center().x()) + 0.5;
      painter.setRenderHint(QPainter::Antialiasing, false);
      painter.drawLine(QPointF(x, box.top()), QPointF(x, box.bottom()));
    } else if (box.height() < 0.6) {
      const double y = std::floor(box.center().y()) + 0.5;
      painter.setRenderHint(QPainter::Antialiasing, false);
      painter.drawLine(QPointF(box.left(), y), QPointF(box.right(), y));
    } else {
      painter.setRenderHint(QPainter::Antialiasing);
      painter.drawPolyline(line.points);
    }
  }
  painter.restore();
}

void draw_graticule_figures(QPainter& painter, const ChartView& view, GraticuleStep step,
                            const std::vector<QRectF>& taken, const Colours& colours) {
  const QFont small = font(11);
  const QFontMetricsF metrics(small);
  const QSize size = view.size();
  const QRectF chart(QPointF(), size);
  std::vector<QRectF> full = taken;
  for (const GraticuleLine& line : graticule_lines(view, step)) {
    const QString figure = graticule_figure(line, step);
    // Parallels at the left and meridians below, unless the chart is turned so that they only meet the other.
    for (const bool left : {!line.meridian, line.meridian}) {
      const auto at = meets(line.points, left, size);
      if (!at) continue;
      QRectF box(0, 0, metrics.horizontalAdvance(figure), metrics.ascent() + metrics.descent());
      if (left) {
        box.moveBottomLeft({6.0, std::round(at->y()) - 1.0});
      } else {
        box.moveBottomLeft({std::round(at->x()) + 4.0, size.height() - 4.0});
      }
      const QRectF with_halo = box.adjusted(-3, -2, 3, 2);
      if (!chart.contains(box) ||
          std::any_of(full.begin(), full.end(), [&](QRectF other) { return other.intersects(with_halo); }))
        continue;
      full.push_back(with_halo);
      draw_halo_text(painter, {box.left(), box.top() + metrics.ascent()}, figure, small, Role::ink, colours);
      break;
    }
  }
}

QString graticule_figure(const GraticuleLine& line, GraticuleStep step) {
  const double step_min = line.meridian ? step.lon_min : step.lat_min;
  const int places = decimals(step_min);
  const auto scale = static_cast<long long>(std::llround(std::pow(10.0, places)));
  const long long units = std::llround(std::abs(line.value_min) * static_cast<double>(scale));
  const long long degrees = units / (60 * scale);
  const double minutes = static_cast<double>(units % (60 * scale)) / static_cast<double>(scale);
  QString text = QStringLiteral("%1°").arg(degrees);
  if (step_min < 60.0)
    text += QStringLiteral("%1′").arg(minutes, places > 0 ? places + 3 : 2, 'f', places, QLatin1Char('0'));
  if (units == 0 || (line.meridian && units == 180 * 60 * scale)) return text;
  const bool positive = line.value_min > 0.0;
  return text + (line.meridian ? (positive ? " E" : " W") : (positive ? " N" : " S"));
}

}  // namespace leadline::ui
