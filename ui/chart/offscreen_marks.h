#pragma once

#include <QPainter>
#include <QString>
#include <vector>

#include "ui/bridge/snapshot.h"
#include "ui/chart/symbols.h"

namespace leadline::ui {

/// A body that the chart does not show, told at its edge.
struct OffscreenMark {
  Body body = Body::vehicle;
  QPointF at;     ///< where it is: screen px outside the chart
  QString range;  ///< "1.2 km", from whatever the chart follows
  SymbolLook look;
};

/// Whether a mark is due: the position is outside.
[[nodiscard]] bool is_offscreen(QPointF at, QSize chart);

/// Each symbol with its tip 12 px inside the edge, on the way from the middle to the body, pointing outward;
/// clear of furniture (`taken`) and of one another, moved along the edge where it must. Returns their
/// rectangles, ranges included.
std::vector<QRectF> draw_offscreen_marks(QPainter& painter, QSize chart,
                                         const std::vector<OffscreenMark>& marks,
                                         const std::vector<QRectF>& taken, const Colours& colours);

}  // namespace leadline::ui
