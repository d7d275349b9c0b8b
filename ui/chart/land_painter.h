#pragma once

#include <QPainter>
#include <QTransform>
#include <vector>

#include "maps/charts/coastline.h"
#include "ui/look/colours.h"

namespace leadline::ui {

/// Land, lakes in the colour of `sea`, and the coast line, 1 px; only what touches `exposed` costs. The
/// transform takes plane metres to screen px.
void draw_land(QPainter& painter, const std::vector<maps::PlaneRing>& land, const QTransform& plane_to_screen,
               const QRectF& exposed, Role sea, const Colours& colours);

}  // namespace leadline::ui
