#include "ui/chart/track_path.h"

#include <QPolygonF>
#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace leadline::ui {
namespace {

constexpr double kFinest_m = 0.001;  ///< a quarter of a pixel at the closest scale
constexpr std::size_t kLevels = 22;  ///< doubling: the coarsest is a quarter of a pixel at the farthest scale
constexpr std::size_t kRun = 64;
/// Of a pixel: levels are made of each other, so errors add up to twice a level's own tolerance.
constexpr double kToleranceShare = 0.25;

void widen(maps::PlaneBox& box, maps::PlanePoint p) {
  box.west_m = std::min(box.west_m, p.east_m);
  box.east_m = std::max(box.east_m, p.east_m);
  box.south_m = std::min(box.south_m, p.north_m);
  box.north_m = std::max(box.north_m, p.north_m);
}

bool meet(const maps::PlaneBox& a, const maps::PlaneBox& b) {
  return a.west_m <= b.east_m && b.west_m <= a.east_m && a.south_m <= b.north_m && b.south_m <= a.north_m;
}

maps::PlanePoint between(maps::PlanePoint a, maps::PlanePoint b, double t) {
  return {a.east_m + t * (b.east_m - a.east_m), a.north_m + t * (b.north_m - a.north_m)};
}

/// The part of a segment within a box as fractions of its length (Liang and Barsky 1984); empty: none.
std::optional<std::pair<double, double>> part_within(maps::PlanePoint a, maps::PlanePoint b,
                                                     const maps::PlaneBox& box) {
  double from = 0.0, to = 1.0;
  const auto cut = [&](double step, double room) {  // step * t <= room
    if (step == 0.0) return room >= 0.0;
    const double t = room / step;
    if (step > 0.0)
      to = std::min(to, t);
    else
      from = std::max(from, t);
    return from <= to;
  };
  const double east = b.east_m - a.east_m, north = b.north_m - a.north_m;
  if (!cut(-east, a.east_m - box.west_m) || !cut(east, box.east_m - a.east_m) ||
      !cut(-north, a.north_m - box.south_m) || !cut(north, box.north_m - a.north_m))
    return std::nullopt;
  return std::pair(from, to);
}

double apart(maps::PlanePoint a, maps::PlanePoint b) {
  return std::hypot(b.east_m - a.east_m, b.north_m - a.north_m);
}

void polyline(QPainter& painter, QPen pen, const QPolygonF& line, double along_px) {
  if (line.size() < 2) return;
  if (pen.style() == Qt::CustomDashLine) pen.setDashOffset(along_px / pen.widthF());
  painter.setPen(pen);
  painter.drawPolyline(line);
}

}  // namespace

TrackPath::TrackPath() { clear(); }

void TrackPath::clear() {
  points_.clear();
  levels_.assign(kLevels, {});
  double tolerance_m = kFinest_m;
  for (Level& level : levels_) level.tolerance_m = tolerance_m, tolerance_m *= 2.0;
}

void TrackPath::append(std::span<const maps::PlanePoint> points) {
  points_.reserve(std::max(points_.capacity(), points_.size() + points.size()));
  for (const maps::PlanePoint& p : points) {
    feed(0, {p, 0.0, static_cast<std::uint32_t>(points_.size())});
    points_.push_back(p);
  }
}

void TrackPath::feed(std::size_t number, const Vertex& vertex) {
  Level& level = levels_[number];
  if (level.kept.empty()) {
    keep(number, vertex);
    return;
  }
  const Vertex& last = level.kept.back();
  const double distance_m = apart(last.at, vertex.at);
  if (level.open || distance_m > level.tolerance_m) {
    const double bearing = std::atan2(vertex.at.east_m - last.at.east_m, vertex.at.north_m - last.at.north_m);
    const double half = distance_m > level.tolerance_m ? std::asin(level.tolerance_m / distance_m) : kPi;
    if (!level.open) {
      level.open = true;
      level.bearing_rad = bearing;
      level.left_rad = -half;
      level.right_rad = half;
      level.reach_m = distance_m;
    } else {
      const double off = std::remainder(bearing - level.bearing_rad, 2.0 * kPi);
      // Out of the sleeve, or turning back along it: the vertex before is a corner.
      if (off < level.left_rad || off > level.right_rad || distance_m < level.reach_m - level.tolerance_m) {
        const Vertex corner = level.newest;
        keep(number, corner);
        feed(number, vertex);
        return;
      }
      level.left_rad = std::max(level.left_rad, off - half);
      level.right_rad = std::min(level.right_rad, off + half);
      level.reach_m = std::max(level.reach_m, distance_m);
    }
  }
  level.newest = vertex;
}

void TrackPath::keep(std::size_t number, const Vertex& vertex) {
  Level& level = levels_[number];
  Vertex kept = vertex;
  if (!level.kept.empty()) kept.along_m = level.kept.back().along_m + apart(level.kept.back().at, vertex.at);
  const std::size_t place = level.kept.size();
  level.kept.push_back(kept);
  level.newest = kept;
  level.open = false;
  if (level.runs.empty()) {
    level.runs.push_back({place, place, {kept.at.east_m, kept.at.north_m, kept.at.east_m, kept.at.north_m}});
  } else {
    Run& run = level.runs.back();
    run.last = place;
    widen(run.box, kept.at);
    if (place - run.first >= kRun)
      level.runs.push_back(
          {place, place, {kept.at.east_m, kept.at.north_m, kept.at.east_m, kept.at.north_m}});
  }
  if (number + 1 < levels_.size()) feed(number + 1, vertex);
}

const TrackPath::Level& TrackPath::level_for(double metres_per_px) const {
  std::size_t number = 0;
  while (number + 1 < levels_.size() && levels_[number + 1].tolerance_m <= kToleranceShare * metres_per_px)
    ++number;
  return levels_[number];
}

std::size_t TrackPath::vertices(double metres_per_px) const { return level_for(metres_per_px).kept.size(); }

void TrackPath::stroke(QPainter& painter, const ChartView& view, const QRect& exposed, const Level& level,
                       std::size_t shown, const QPen& pen) const {
  // So wide that an end cut off at the edge, and a joint beyond it, is not seen.
  const double margin = 4.0 * pen.widthF() + 4.0;
  const maps::PlaneBox box = view.plane_box(QRectF(exposed).adjusted(-margin, -margin, margin, margin));
  const QTransform to_screen = view.plane_to_screen();
  const auto px = [&](maps::PlanePoint p) { return to_screen.map(QPointF(p.east_m, p.north_m)); };
  const double k = 1.0 / view.metres_per_px();
  QPolygonF line;
  line.reserve(kRun + 2);
  // Vertices that are shown: those up to `shown`, then straight to the last shown point.
  const auto end = std::partition_point(level.kept.begin(), level.kept.end(),
                                        [&](const Vertex& v) { return v.index < shown; });
  const auto count = static_cast<std::size_t>(end - level.kept.begin());
  for (const Run& run : level.runs) {
    if (run.first >= count) break;
    if (!meet(run.box, box)) continue;
    // Of a run, the stretches that meet the box, cut off at its edge: a stroke costs its length.
    const std::size_t last = std::min(run.last, count - 1);
    double along_m = 0.0;
    line.clear();
    for (std::size_t i = run.first; i < last; ++i) {
      const Vertex &a = level.kept[i], &b = level.kept[i + 1];
      const auto inside = part_within(a.at, b.at, box);
      if (!inside) continue;
      if (line.isEmpty()) {
        along_m = a.along_m + inside->first * (b.along_m - a.along_m);
        line << px(between(a.at, b.at, inside->first));
      }
      line << px(between(a.at, b.at, inside->second));
      const bool goes_on = inside->second == 1.0 && i + 1 < last;
      if (goes_on && part_within(b.at, level.kept[i + 2].at, box)) continue;
      polyline(painter, pen, line, along_m * k);
      line.clear();
    }
  }
  if (count == 0) return;
  // The way on to the last shown point: each finer level's last vertex lies in the sleeve of the level above.
  const Vertex& last = level.kept[count - 1];
  line.clear();
  line << px(last.at);
  std::uint32_t reached = last.index;
  for (const Level* finer = &level; finer-- != levels_.data();) {
    const auto after = std::partition_point(finer->kept.begin(), finer->kept.end(),
                                            [&](const Vertex& v) { return v.index < shown; });
    if (after == finer->kept.begin() || (after - 1)->index <= reached) continue;
    line << px((after - 1)->at);
    reached = (after - 1)->index;
  }
  if (reached + 1 < shown) line << px(points_[shown - 1]);
  if (line.boundingRect().adjusted(-margin, -margin, margin, margin).intersects(exposed))
    polyline(painter, pen, line, last.along_m * k);
}

void TrackPath::paint(QPainter& painter, const ChartView& view, const QRect& exposed, std::size_t shown,
                      const TrackPens& pens) const {
  shown = std::min(shown, points_.size());
  if (shown < 2) return;
  const Level& level = level_for(view.metres_per_px());
  stroke(painter, view, exposed, level, shown, pens.halo);
  stroke(painter, view, exposed, level, shown, pens.line);
}

void TrackPath::paint_added(QPainter& painter, const ChartView& view, std::size_t from, std::size_t shown,
                            const TrackPens& pens) const {
  shown = std::min(shown, points_.size());
  if (from + 1 >= shown) return;
  const Level& level = level_for(view.metres_per_px());
  const auto before = std::partition_point(level.kept.begin(), level.kept.end(),
                                           [&](const Vertex& v) { return v.index <= from; });
  double along_m = 0.0;
  if (before != level.kept.begin()) {
    const Vertex& vertex = *(before - 1);
    along_m = vertex.along_m + apart(vertex.at, points_[from]);
  }
  QPolygonF line;
  for (std::size_t i = from; i < shown; ++i) line << view.to_screen(points_[i]);
  polyline(painter, pens.halo, line, along_m / view.metres_per_px());
  polyline(painter, pens.line, line, along_m / view.metres_per_px());
}

}  // namespace leadline::ui
