#pragma once

#include <QPointF>
#include <QRectF>
#include <QSize>
#include <QTransform>

#include "maps/charts/local_projection.h"

namespace leadline::ui {

/// How the chart looks at the world: where, how close, which bearing is up. A value.
/// Screen x is right and y down, px; the origin of pixels is the projection's origin at (0, 0) of the plane,
/// so that two views of one projection, scale and turn differ by whole pixels (origin_px is kept whole).
class ChartView {
 public:
  explicit ChartView(Geodetic centre, QSize size = {1, 1}, double metres_per_px = 1.0, Angle up = {});

  [[nodiscard]] const maps::LocalProjection& projection() const { return projection_; }
  [[nodiscard]] QSize size() const { return size_; }
  [[nodiscard]] double metres_per_px() const { return metres_per_px_; }
  /// The plane bearing that points to the top of the screen.
  [[nodiscard]] Angle up() const { return up_; }
  [[nodiscard]] Geodetic centre() const;
  /// Screen position of the plane's origin; whole px.
  [[nodiscard]] QPoint origin_px() const { return origin_px_; }

  [[nodiscard]] QPointF to_screen(maps::PlanePoint point) const;
  [[nodiscard]] QPointF to_screen(Geodetic point) const { return to_screen(projection_.forward(point)); }
  [[nodiscard]] maps::PlanePoint to_plane(QPointF screen) const;
  [[nodiscard]] Geodetic to_geodetic(QPointF screen) const { return projection_.reverse(to_plane(screen)); }
  /// Clockwise on the screen from its top, degrees, of a true bearing at a place: for QPainter::rotate.
  [[nodiscard]] double screen_angle_deg(Angle true_bearing, Geodetic at) const;
  /// Plane metres (x east, y north) to screen px.
  [[nodiscard]] QTransform plane_to_screen() const;
  /// The part of the plane that a screen rectangle shows, its bounding box where the view is turned.
  [[nodiscard]] maps::PlaneBox plane_box(QRectF screen) const;

  void resize(QSize size);
  /// Re-centred in a new projection when the centre is far (50 km, or 0.5 deg of convergence) from the old
  /// origin.
  void centre_on(Geodetic centre);
  void pan(QPoint px);
  /// Keeps what is under `fixed` where it is. Clamped to kClosest..kFarthest.
  void zoom(double factor, QPointF fixed);
  void set_metres_per_px(double metres_per_px);
  void turn(Angle up);

  static constexpr double kClosest = 0.005;     ///< m/px
  static constexpr double kFarthest = 5'000.0;  ///< m/px

 private:
  [[nodiscard]] QPointF turned(maps::PlanePoint point) const;
  void put(maps::PlanePoint point, QPointF screen);

  maps::LocalProjection projection_;
  QSize size_;
  double metres_per_px_;
  Angle up_;
  double cos_up_, sin_up_;
  QPoint origin_px_;
};

/// One px is 1/96 inch: the N of "1 : N".
[[nodiscard]] double scale_denominator(double metres_per_px);

}  // namespace leadline::ui
