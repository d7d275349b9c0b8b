#pragma once

#include <QPainter>
#include <functional>

#include "ui/look/colours.h"

namespace leadline::ui {

/// A small mark that looks the same wherever it stands: painted once for each look and quarter of a pixel,
/// then copied, since there may be thousands. half_px: it lies within that of its place. paint: at the given
/// point.
void draw_stamp(QPainter& painter, QPointF at, const QString& name, int half_px, const Colours& colours,
                const std::function<void(QPainter&, QPointF)>& paint);

}  // namespace leadline::ui
