#pragma once

#include <QPainter>
#include <QString>
#include <cstdint>

#include "ui/chart/chart_view.h"
#include "ui/look/colours.h"
#include "ui/models/chart_choice.h"

namespace leadline::ui {

/// true_motion: the sea stands still and the body moves; relative: the body stands still.
enum class Motion : std::uint8_t { true_motion, relative };

/// What the orientation box says besides the view itself.
struct OrientationFacts {
  Orientation orientation = Orientation::north_up;
  Motion motion = Motion::true_motion;
  QString follow;  ///< name of the body the chart follows; empty: none
};

/// Top right: north arrow (true north at the view's centre), orientation, motion, scale. Never hidden.
/// Returns its rectangle.
QRectF draw_orientation_box(QPainter& painter, const ChartView& view, const OrientationFacts& facts,
                            const Colours& colours);
[[nodiscard]] QRectF orientation_box(const ChartView& view, const OrientationFacts& facts);

}  // namespace leadline::ui
