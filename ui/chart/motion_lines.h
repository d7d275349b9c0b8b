#pragma once

#include <QLineF>
#include <QRectF>
#include <optional>

#include "core/geo/geodesy.h"
#include "ui/chart/chart_view.h"
#include "ui/chart/symbols.h"

namespace leadline::ui {

inline constexpr double kShipHeadingLine_px = 72.0;     ///< from the bow
inline constexpr double kVehicleHeadingLine_px = 44.0;  ///< from the tip
inline constexpr double kVehicleVector_s = 60.0;
inline constexpr double kShipVector_s = 360.0;

/// From `start_px` ahead of the position (the bow's or tip's) on for length_px.
[[nodiscard]] QLineF heading_line(QPointF at, double angle_deg, double start_px, double length_px);
/// The same, on to the chart's edge; null where it never is on the chart.
[[nodiscard]] QLineF heading_line_to_edge(QPointF at, double angle_deg, double start_px, QRectF chart);
void draw_heading_line(QPainter& painter, QLineF line, Role role, const Colours& colours);

/// Where a body drifts to at its velocity over ground (m/s, true axes at its place) in `seconds`, as seen in
/// the view. Empty when shorter than 8 px or slower than three times its sigma (m/s).
[[nodiscard]] std::optional<QLineF> course_vector(const ChartView& view, Geodetic at, geo::NorthEast velocity,
                                                  double sigma_mps, double seconds);
/// Drawn before the symbol, which then covers its beginning.
void draw_course_vector(QPainter& painter, QLineF line, Role role, const Colours& colours);

}  // namespace leadline::ui
