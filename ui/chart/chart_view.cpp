#include "ui/chart/chart_view.h"

#include <algorithm>
#include <cmath>

#include "core/geo/geodesy.h"

namespace leadline::ui {
namespace {

constexpr double kFarFromOrigin_m = 50'000.0;
constexpr double kConvergenceLimit_rad = 0.5 * kRadPerDeg;

QPoint whole(QPointF px) {
  return {static_cast<int>(std::lround(px.x())), static_cast<int>(std::lround(px.y()))};
}

QPointF middle(QSize size) { return {size.width() / 2.0, size.height() / 2.0}; }

}  // namespace

ChartView::ChartView(Geodetic centre, QSize size, double metres_per_px, Angle up)
    : projection_(centre),
      size_(size),
      metres_per_px_(std::clamp(metres_per_px, kClosest, kFarthest)),
      up_(up.wrapped_2pi()),
      cos_up_(cos(up_)),
      sin_up_(sin(up_)),
      origin_px_(whole(middle(size))) {}

Geodetic ChartView::centre() const { return to_geodetic(middle(size_)); }

// A bearing b of the plane points to (sin(b - up), -cos(b - up)) on the screen.
QPointF ChartView::turned(maps::PlanePoint p) const {
  return {(p.east_m * cos_up_ - p.north_m * sin_up_) / metres_per_px_,
          -(p.east_m * sin_up_ + p.north_m * cos_up_) / metres_per_px_};
}

QPointF ChartView::to_screen(maps::PlanePoint point) const { return turned(point) + QPointF(origin_px_); }

maps::PlanePoint ChartView::to_plane(QPointF screen) const {
  const QPointF p = (screen - QPointF(origin_px_)) * metres_per_px_;
  return {p.x() * cos_up_ - p.y() * sin_up_, -p.x() * sin_up_ - p.y() * cos_up_};
}

double ChartView::screen_angle_deg(Angle true_bearing, Geodetic at) const {
  return (true_bearing - projection_.convergence(at) - up_).wrapped_2pi().deg();
}

QTransform ChartView::plane_to_screen() const {
  const double k = 1.0 / metres_per_px_;
  return {cos_up_ * k,  -sin_up_ * k,           -sin_up_ * k,
          -cos_up_ * k, double(origin_px_.x()), double(origin_px_.y())};
}

maps::PlaneBox ChartView::plane_box(QRectF screen) const {
  const maps::PlanePoint first = to_plane(screen.topLeft());
  maps::PlaneBox box{first.east_m, first.north_m, first.east_m, first.north_m};
  for (const QPointF corner : {screen.topRight(), screen.bottomLeft(), screen.bottomRight()}) {
    const maps::PlanePoint p = to_plane(corner);
    box.west_m = std::min(box.west_m, p.east_m);
    box.east_m = std::max(box.east_m, p.east_m);
    box.south_m = std::min(box.south_m, p.north_m);
    box.north_m = std::max(box.north_m, p.north_m);
  }
  return box;
}

void ChartView::put(maps::PlanePoint point, QPointF screen) { origin_px_ = whole(screen - turned(point)); }

void ChartView::resize(QSize size) {
  const maps::PlanePoint centre = to_plane(middle(size_));
  size_ = size;
  put(centre, middle(size));
}

void ChartView::centre_on(Geodetic centre) {
  const maps::PlanePoint p = projection_.forward(centre);
  const bool far = !(std::hypot(p.east_m, p.north_m) <= kFarFromOrigin_m) ||
                   std::abs(projection_.convergence(centre).rad()) > kConvergenceLimit_rad;
  if (far) {
    projection_ = maps::LocalProjection(centre);
    put({}, middle(size_));
  } else {
    put(p, middle(size_));
  }
}

void ChartView::pan(QPoint px) { origin_px_ += px; }

void ChartView::zoom(double factor, QPointF fixed) {
  const maps::PlanePoint p = to_plane(fixed);
  metres_per_px_ = std::clamp(metres_per_px_ / factor, kClosest, kFarthest);
  put(p, fixed);
}

void ChartView::set_metres_per_px(double metres_per_px) {
  zoom(metres_per_px_ / metres_per_px, middle(size_));
}

void ChartView::turn(Angle up) {
  if (up.wrapped_2pi() == up_) return;
  const maps::PlanePoint centre = to_plane(middle(size_));
  up_ = up.wrapped_2pi();
  cos_up_ = cos(up_);
  sin_up_ = sin(up_);
  put(centre, middle(size_));
}

double scale_denominator(double metres_per_px) { return metres_per_px / (0.0254 / 96.0); }

}  // namespace leadline::ui
