#pragma once

#include <QPainter>
#include <QPen>
#include <cstdint>
#include <span>
#include <vector>

#include "ui/chart/chart_view.h"

namespace leadline::ui {

/// How a track is drawn: twice, first wider in the halo.
struct TrackPens {
  QPen halo, line;  ///< dashes in multiples of the line's width, as QPen has them
};

/// A polyline of any length that costs what is seen of it. It grows at its end only. Each coarser level
/// keeps, of the level below, the vertices that a line may not leave out by more than its tolerance (the
/// sleeve of Zhao and Saalfeld 1997, one look at each vertex); a level is cut into runs with bounding boxes,
/// so that a strip of the screen touches few. GUI thread.
class TrackPath {
 public:
  TrackPath();

  void clear();
  void append(std::span<const maps::PlanePoint> points);
  [[nodiscard]] std::size_t size() const { return points_.size(); }
  [[nodiscard]] maps::PlanePoint at(std::size_t i) const { return points_[i]; }

  /// Paints the first `shown` points where they lie within `exposed` (screen px), no further than 0.5 px from
  /// where they are.
  void paint(QPainter& painter, const ChartView& view, const QRect& exposed, std::size_t shown,
             const TrackPens& pens) const;
  /// Paints the last segments alone, from point `from` to point `shown` - 1, over what paint() left.
  void paint_added(QPainter& painter, const ChartView& view, std::size_t from, std::size_t shown,
                   const TrackPens& pens) const;

  /// How many vertices a scale is drawn with: what a picture of the whole costs.
  [[nodiscard]] std::size_t vertices(double metres_per_px) const;

 private:
  /// One vertex of a level.
  struct Vertex {
    maps::PlanePoint at;
    double along_m = 0.0;     ///< length of this level's line up to here, for dashes that do not jump
    std::uint32_t index = 0;  ///< among all points
  };
  /// Consecutive vertices and what they cover; neighbours share a vertex.
  struct Run {
    std::size_t first = 0, last = 0;
    maps::PlaneBox box;
  };
  struct Level {
    double tolerance_m = 0.0;
    std::vector<Vertex> kept;
    std::vector<Run> runs;
    // The sleeve that is open: directions from the last kept vertex that pass all since within the tolerance.
    Vertex newest;
    bool open = false;
    double bearing_rad = 0.0, left_rad = 0.0, right_rad = 0.0, reach_m = 0.0;
  };

  void feed(std::size_t level, const Vertex& vertex);
  void keep(std::size_t level, const Vertex& vertex);
  [[nodiscard]] const Level& level_for(double metres_per_px) const;
  void stroke(QPainter& painter, const ChartView& view, const QRect& exposed, const Level& level,
              std::size_t shown, const QPen& pen) const;

  std::vector<maps::PlanePoint> points_;
  std::vector<Level> levels_;
};

}  // namespace leadline::ui
