#include "ui/chart/track_layer.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace leadline::ui {
namespace {

/// More new points than that are cheaper in a picture painted anew, simplified.
constexpr std::size_t kMostAdded = 256;

std::size_t shown_at(const Track& track, Time now) {
  const auto end = std::partition_point(track.points.begin(), track.points.end(),
                                        [&](const TrackPoint& p) { return p.valid <= now; });
  return static_cast<std::size_t>(end - track.points.begin());
}

}  // namespace

TrackKind track_kind(const Track& track) {
  if (track.engine == kShipTrack) return TrackKind::ship;
  if (track.name == "dead-reckoning") return TrackKind::dead_reckoning;
  return track.name == "fusion" ? TrackKind::fused : TrackKind::other;
}

LineStyle track_line(TrackKind kind) {
  switch (kind) {
    case TrackKind::fused:
      return {Role::track_fused, 2.2, {}};
    case TrackKind::dead_reckoning:
      return {Role::track_dr, 1.5, {7, 4}};
    case TrackKind::ship:
      return {Role::ship, 1.2, {}};
    case TrackKind::other:
      break;
  }
  return {Role::track_smooth, 1.6, {12, 3}};
}

TrackPens track_pens(TrackKind kind, const Colours& colours) {
  const LineStyle line = track_line(kind);
  return {halo_pen(line.width_px, Halo::track, colours), pen_of(line, colours)};
}

TrackLayer::Change TrackLayer::sync(const History& history, const maps::LocalProjection& projection,
                                    Time now) {
  bool anew = history_ != &history || origin_ != projection.origin() || lines_.size() > history.tracks.size();
  for (std::size_t i = 0; !anew && i < lines_.size(); ++i)
    anew = history.tracks[i].points.size() < lines_[i].path.size();
  if (anew) {
    history_ = &history;
    origin_ = projection.origin();
    lines_.clear();
  }
  if (lines_.size() < history.tracks.size()) lines_.resize(history.tracks.size());
  bool grown = false;
  std::array<Geodetic, 256> from;
  std::array<maps::PlanePoint, 256> to;
  for (std::size_t i = 0; i < lines_.size(); ++i) {
    Line& line = lines_[i];
    const Track& track = history.tracks[i];
    line.kind = track_kind(track);
    while (line.path.size() < track.points.size()) {
      const std::size_t begin = line.path.size(), count = std::min(from.size(), track.points.size() - begin);
      for (std::size_t k = 0; k < count; ++k) from[k] = track.points[begin + k].position;
      projection.forward({from.data(), count}, {to.data(), count});
      line.path.append({to.data(), count});
    }
    const std::size_t shown = shown_at(track, now);
    anew |= shown < line.painted || shown > line.painted + kMostAdded;
    grown |= shown > line.painted;
    line.shown = shown;
  }
  pending_ = std::max(pending_, anew ? Change::anew : grown ? Change::grown : Change::none);
  if (pending_ == Change::anew)
    for (Line& line : lines_) line.painted = line.shown;  // paint() paints it all
  return pending_;
}

void TrackLayer::paint(QPainter& painter, const ChartView& view, const QRect& exposed,
                       const Colours& colours) const {
  // The shown engine's own line comes last: it lies on top of those it is compared with.
  for (const bool fused : {false, true})
    for (const Line& line : lines_)
      if ((line.kind == TrackKind::fused) == fused)
        line.path.paint(painter, view, exposed, line.painted, track_pens(line.kind, colours));
}

QRect TrackLayer::added(const ChartView& view) const {
  QRectF all;
  for (const Line& line : lines_) {
    if (line.painted >= line.shown) continue;
    QPolygonF points;
    for (std::size_t i = line.painted == 0 ? 0 : line.painted - 1; i < line.shown; ++i)
      points << view.to_screen(line.path.at(i));
    all |= points.boundingRect().adjusted(-4, -4, 4, 4);
  }
  return all.toAlignedRect();
}

void TrackLayer::paint_added(QPainter& painter, const ChartView& view, const Colours& colours) const {
  for (const Line& line : lines_)
    line.path.paint_added(painter, view, line.painted == 0 ? 0 : line.painted - 1, line.shown,
                          track_pens(line.kind, colours));
}

void TrackLayer::settle() {
  for (Line& line : lines_) line.painted = line.shown;
  pending_ = Change::none;
}

std::optional<maps::PlaneBox> TrackLayer::extent() const {
  std::optional<maps::PlaneBox> box;
  for (const Line& line : lines_)
    for (std::size_t i = 0; i < line.shown; ++i) {
      const maps::PlanePoint p = line.path.at(i);
      if (!std::isfinite(p.east_m) || !std::isfinite(p.north_m)) continue;
      if (!box) box = maps::PlaneBox{p.east_m, p.north_m, p.east_m, p.north_m};
      box->west_m = std::min(box->west_m, p.east_m);
      box->east_m = std::max(box->east_m, p.east_m);
      box->south_m = std::min(box->south_m, p.north_m);
      box->north_m = std::max(box->north_m, p.north_m);
    }
  return box;
}

std::vector<TrackKind> TrackLayer::kinds() const {
  std::vector<TrackKind> found;
  for (const Line& line : lines_)
    if (line.shown > 1 && std::find(found.begin(), found.end(), line.kind) == found.end())
      found.push_back(line.kind);
  return found;
}

}  // namespace leadline::ui
