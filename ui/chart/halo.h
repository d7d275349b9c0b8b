#pragma once

#include <QPainter>
#include <QPainterPath>
#include <QPen>
#include <QVector>

#include "ui/look/colours.h"

namespace leadline::ui {

/// A line of the chart: everything in px, dashes as on and off lengths along it.
struct LineStyle {
  Role role = Role::ink;
  double width_px = 1.6;
  QVector<double> dash_px{};  ///< empty: solid
  double opacity = 1.0;
  Qt::PenCapStyle cap = Qt::FlatCap;
};
[[nodiscard]] QPen pen_of(const LineStyle& line, const Colours& colours);

/// What is stroked, and so how much halo shows beside it.
enum class Halo { symbol, line, track };
/// The first, wider stroke: solid under dashes too, so that the gaps stand out from a raster.
[[nodiscard]] QPen halo_pen(double width_px, Halo halo, const Colours& colours);

/// Strokes twice, first the halo. Painter: antialiased by the caller.
void stroke_haloed(QPainter& painter, const QPainterPath& path, const LineStyle& line, Halo halo,
                   const Colours& colours);

}  // namespace leadline::ui
