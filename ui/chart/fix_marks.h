#pragma once

#include <QPainter>
#include <QRectF>
#include <QString>
#include <vector>

#include "ui/look/colours.h"

namespace leadline::ui {

/// A ring. Kept as a pixmap (to a quarter of a px), there may be thousands.
void draw_fix_used(QPainter& painter, QPointF at, const Colours& colours);
/// A cross, and a dotted line to where the solution was; none where that is the same place.
void draw_fix_refused(QPainter& painter, QPointF at, QPointF solution, const Colours& colours);

/// From the ship to where her USBL last saw the vehicle. Not drawn once the fix is stale: the caller's
/// choice. `label` ("USBL 3 s") stands beside the line at 60 % of it, on the upper side or the other, or a
/// little along where that is `taken`; returns its rectangle, null without one or on a line shorter than two.
QRectF draw_usbl_beam(QPainter& painter, QPointF ship, QPointF vehicle, const QString& label,
                      const Colours& colours, const std::vector<QRectF>& taken = {});

}  // namespace leadline::ui
