#pragma once

#include <QImage>
#include <QPainter>
#include <functional>
#include <optional>

#include "ui/chart/chart_view.h"

namespace leadline::ui {

/// The standing part of the chart as one opaque picture that moves with the view: only what comes into sight
/// is painted, and nothing is moved in memory (the picture is a torus of pixels). GUI thread.
class Ground {
 public:
  /// Paints screen rectangle `exposed`; the painter is clipped to it and takes screen coordinates.
  using Paint = std::function<void(QPainter&, const QRect& exposed)>;

  /// Brings the picture to `view`. Another scale, turn, size or projection paints everything anew.
  void update(const ChartView& view, const Paint& paint);
  /// Everything, or a part of the plane, is to be painted anew at the next update.
  void invalidate();
  void invalidate(const maps::PlaneBox& box);
  /// Paints over what is there, for what only grows. After update() with the same view.
  void add(const QRect& screen, const Paint& paint);
  /// Onto the screen: up to four opaque copies.
  void draw(QPainter& painter) const;

  /// How many pixels were painted since the last call; what a frame cost.
  [[nodiscard]] long long take_painted_px();

 private:
  void paint_part(QRect screen, const Paint& paint);

  QImage picture_;
  std::optional<ChartView> view_;
  std::vector<maps::PlaneBox> stale_;
  long long painted_px_ = 0;
};

}  // namespace leadline::ui
