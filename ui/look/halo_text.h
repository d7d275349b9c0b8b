#pragma once

#include <QFont>
#include <QPainter>
#include <QString>

#include "ui/look/colours.h"

namespace leadline::ui {

/// Text for the chart: stroked 3 px with the halo at 85 %, then filled. `at` is the left end of the base
/// line; the glyphs are cached as a pixmap, so that standing text costs a blit. Upright in device
/// coordinates.
void draw_halo_text(QPainter& painter, QPointF at, const QString& text, const QFont& font, Role role,
                    const Colours& colours);

}  // namespace leadline::ui
