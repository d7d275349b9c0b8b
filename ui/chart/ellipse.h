#pragma once

#include <QString>
#include <optional>

#include "ui/chart/chart_view.h"
#include "ui/chart/symbols.h"

namespace leadline::ui {

/// The one-sigma ellipse of a horizontal position.
struct SigmaEllipse {
  double major_m = 0.0, minor_m = 0.0;  ///< semi-axes, major >= minor >= 0
  Angle azimuth;                        ///< of the major axis from true north, [0, pi)
};
/// Semi-axes and direction by the eigenvalues of the 2 x 2 covariance in north and east, m^2. Empty when it
/// is none: not finite, or not positive semi-definite beyond rounding.
[[nodiscard]] std::optional<SigmaEllipse> sigma_ellipse(double var_north_m2, double cov_north_east_m2,
                                                        double var_east_m2);

/// Painted from a semi-axis of 10 px on; false: smaller, the label's figure alone tells it.
bool draw_sigma_ellipse(QPainter& painter, const ChartView& view, Geodetic at, const SigmaEllipse& ellipse,
                        Role role, const Colours& colours);

/// The dotted circle round a stale or lost symbol; nothing round a live one, or when it hides in the symbol.
void draw_doubt(QPainter& painter, QPointF at, double radius_px, SymbolState state, Role role,
                const Colours& colours);
/// The age of a stale symbol ("14 s"), or when it was last seen of a lost one ("last 13:59:56 Z"), bold at
/// its upper right. Returns the rectangle.
QRectF draw_age(QPainter& painter, QPointF at, double doubt_px, const QString& text, const Colours& colours);
[[nodiscard]] QRectF age_box(QPointF at, double doubt_px, const QString& text);

}  // namespace leadline::ui
