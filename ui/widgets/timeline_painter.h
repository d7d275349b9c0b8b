#pragma once

#include <QPainter>
#include <QRect>
#include <optional>

#include "ui/look/colours.h"
#include "ui/models/timeline_data.h"

namespace leadline::ui {

/// Time to x and back, for a span drawn between two margins.
struct TimeScale {
  TimeSpan span;
  double left = 0, width = 1;  ///< px

  static constexpr double kMargin = 16;
  TimeScale(TimeSpan shown, const QRect& rect);
  [[nodiscard]] double x(Time t) const;
  [[nodiscard]] Time at(double x) const;  ///< clamped to the span
};

inline constexpr int kTimelineHeight = 92;

/// All that stands still while the play head moves: availability band, alerts, events, gaps, sigma, hours.
void draw_timeline(QPainter& painter, const QRect& rect, const TimelineData& data, TimeSpan span,
                   const Colours& colours);
/// Violet brackets; `until` not after `from`: only its beginning is set.
void draw_loop(QPainter& painter, const QRect& rect, TimeSpan loop, TimeSpan span, const Colours& colours);
void draw_play_head(QPainter& painter, const QRect& rect, Time now, TimeSpan span, const Colours& colours);

}  // namespace leadline::ui
