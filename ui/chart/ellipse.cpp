#include "ui/chart/ellipse.h"

#include <QFontMetricsF>
#include <algorithm>
#include <cmath>

#include "ui/chart/halo.h"
#include "ui/chart/stamp.h"
#include "ui/look/halo_text.h"
#include "ui/look/look.h"

namespace leadline::ui {

std::optional<SigmaEllipse> sigma_ellipse(double var_north_m2, double cov_north_east_m2, double var_east_m2) {
  const double mean = (var_north_m2 + var_east_m2) / 2.0;
  const double half = (var_north_m2 - var_east_m2) / 2.0;
  const double spread = std::hypot(half, cov_north_east_m2);
  const double smaller = mean - spread;
  if (!std::isfinite(spread) || !std::isfinite(mean) || smaller < -1e-9 * mean || mean < 0.0)
    return std::nullopt;
  Angle azimuth = Angle::rad(std::atan2(cov_north_east_m2, half) / 2.0);
  if (azimuth.rad() < 0.0) azimuth = azimuth + Angle::rad(kPi);
  return SigmaEllipse{std::sqrt(mean + spread), std::sqrt(std::max(smaller, 0.0)), azimuth};
}

namespace {

/// Up to this semi-axis the picture of an ellipse is kept: it changes slowly, and stroking it costs 50 us.
constexpr double kKept_px = 160.0;

void paint_ellipse(QPainter& painter, QPointF centre, double major_px, double minor_px, double angle_deg,
                   Role role, const Colours& colours) {
  QPainterPath path;
  path.addEllipse(QPointF(), minor_px, major_px);
  QTransform place;
  place.translate(centre.x(), centre.y());
  place.rotate(angle_deg);
  path = place.map(path);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.strokePath(path, halo_pen(1.4, Halo::line, colours));
  painter.fillPath(path, colours.of(role, 0.12));
  painter.strokePath(path, pen_of({role, 1.4}, colours));
}

}  // namespace

bool draw_sigma_ellipse(QPainter& painter, const ChartView& view, Geodetic at, const SigmaEllipse& ellipse,
                        Role role, const Colours& colours) {
  const double major_px = ellipse.major_m / view.metres_per_px();
  const double minor_px = ellipse.minor_m / view.metres_per_px();
  if (!(major_px >= 10.0)) return false;
  const QPointF centre = view.to_screen(at);
  const double angle_deg = view.screen_angle_deg(ellipse.azimuth, at);
  if (major_px > kKept_px) {
    paint_ellipse(painter, centre, major_px, minor_px, angle_deg, role, colours);
    return true;
  }
  // To a quarter of a pixel at the tip, as the stamp's own place is.
  const auto steps = [](double value, double step) { return static_cast<int>(std::lround(value / step)); };
  const double turn_deg = 0.25 / major_px * kDegPerRad;
  const int major = steps(major_px, 0.25), minor = steps(minor_px, 0.25), angle = steps(angle_deg, turn_deg);
  const QString name =
      QStringLiteral("ellipse %1 %2 %3 %4").arg(static_cast<int>(role)).arg(major).arg(minor).arg(angle);
  draw_stamp(painter, centre, name, static_cast<int>(std::ceil(major_px)) + 4, colours,
             [&](QPainter& inside, QPointF middle) {
               paint_ellipse(inside, middle, major * 0.25, minor * 0.25, angle * turn_deg, role, colours);
             });
  return true;
}

void draw_doubt(QPainter& painter, QPointF at, double radius_px, SymbolState state, Role role,
                const Colours& colours) {
  if (state == SymbolState::live || !(radius_px >= 10.0)) return;
  QPainterPath circle;
  circle.addEllipse(at, radius_px, radius_px);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.strokePath(circle, halo_pen(1.6, Halo::track, colours));
  if (state == SymbolState::stale) painter.fillPath(circle, colours.of(role, 0.10));
  painter.strokePath(circle, pen_of({role, 2.0, {2.0, 4.0}}, colours));
}

QRectF age_box(QPointF at, double doubt_px, const QString& text) {
  const QFontMetricsF metrics(font(13, true));
  // Beside a small circle, within reach of the symbol of a large one.
  const double out = std::clamp(doubt_px, 14.0, 40.0) * 0.7071 + 3.0;
  const double height = metrics.ascent() + metrics.descent();
  return {at.x() + out, at.y() - out - height / 2.0, metrics.horizontalAdvance(text), height};
}

QRectF draw_age(QPainter& painter, QPointF at, double doubt_px, const QString& text, const Colours& colours) {
  const QFont bold = font(13, true);
  const QRectF box = age_box(at, doubt_px, text);
  draw_halo_text(painter, {box.left(), box.top() + QFontMetricsF(bold).ascent()}, text, bold, Role::ink,
                 colours);
  return box;
}

}  // namespace leadline::ui
