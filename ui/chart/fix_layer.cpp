#include "ui/chart/fix_layer.h"

#include <algorithm>
#include <cmath>

#include "ui/chart/fix_marks.h"
#include "ui/chart/halo.h"

namespace leadline::ui {
namespace {

constexpr double kCell_px = 10.0;   ///< of used fixes, one is drawn in each
constexpr double kReach_px = 12.0;  ///< of a mark around its place

std::uint64_t cell_of(maps::PlanePoint p, double metres_per_px, bool used) {
  const double k = 1.0 / (kCell_px * metres_per_px);
  const auto column = static_cast<std::int64_t>(std::floor(p.east_m * k));
  const auto row = static_cast<std::int64_t>(std::floor(p.north_m * k));
  return (static_cast<std::uint64_t>(column) & 0x7FFFFFFFU) << 32 |
         (static_cast<std::uint64_t>(row) & 0x7FFFFFFFU) << 1 | (used ? 1U : 0U);
}

QRectF covered(const ChartView& view, maps::PlanePoint fix, maps::PlanePoint solution, bool refused) {
  const QPointF at = view.to_screen(fix), to = refused ? view.to_screen(solution) : at;
  return QRectF(QPointF(std::min(at.x(), to.x()), std::min(at.y(), to.y())),
                QPointF(std::max(at.x(), to.x()), std::max(at.y(), to.y())))
      .adjusted(-kReach_px, -kReach_px, kReach_px, kReach_px);
}

/// A dot: it was heard and had no say.
void draw_fix_not_used(QPainter& painter, QPointF at, const Colours& colours) {
  QPainterPath dot;
  dot.addEllipse(at, 0.8, 0.8);
  stroke_haloed(painter, dot, {Role::track_dr, 1.4}, Halo::line, colours);
}

}  // namespace

FixLayer::Change FixLayer::sync(const History& history, const ChartView& view, Time now) {
  bool anew =
      history_ != &history || origin_ != view.projection().origin() || history.fixes.size() < marks_.size();
  if (anew) {
    history_ = &history;
    origin_ = view.projection().origin();
    marks_.clear();
    taken_.clear();
    kinds_ = {};
    shown_ = painted_ = 0;
  }
  const std::size_t before = marks_.size();
  for (std::size_t i = before; i < history.fixes.size(); ++i) {
    const FixMark& fix = history.fixes[i];
    marks_.push_back(
        {view.projection().forward(fix.position), view.projection().forward(fix.solution), fix.accepted});
  }
  if (metres_per_px_ != view.metres_per_px()) {
    metres_per_px_ = view.metres_per_px();
    taken_.clear();
    thin(0, metres_per_px_);
    anew = true;
  } else {
    thin(before, metres_per_px_);
  }
  const auto end = std::partition_point(history.fixes.begin(), history.fixes.end(),
                                        [&](const FixMark& f) { return f.valid <= now; });
  const auto shown = static_cast<std::size_t>(end - history.fixes.begin());
  const bool earlier = shown < shown_;
  if (earlier) kinds_ = {};
  for (std::size_t i = earlier ? 0 : shown_; i < shown; ++i) {
    kinds_.used |= marks_[i].accepted == true;
    kinds_.refused |= marks_[i].accepted == false;
    kinds_.not_used |= !marks_[i].accepted;
  }
  shown_ = shown;
  anew |= shown < painted_;
  pending_ = std::max(pending_, anew ? Change::anew : shown > painted_ ? Change::grown : Change::none);
  if (pending_ == Change::anew) painted_ = shown_;  // paint() paints them all
  return pending_;
}

void FixLayer::thin(std::size_t first, double metres_per_px) {
  for (std::size_t i = first; i < marks_.size(); ++i) {
    Mark& mark = marks_[i];
    const bool refused = mark.accepted == false;
    mark.drawn = refused || taken_.insert(cell_of(mark.fix, metres_per_px, mark.accepted.has_value())).second;
  }
}

void FixLayer::paint_range(QPainter& painter, const ChartView& view, const QRect& exposed, std::size_t first,
                           std::size_t end, const Colours& colours) const {
  // Those not used lie below, refused ones on top: they are what the operator has to see.
  for (const int pass : {0, 1, 2})
    for (std::size_t i = first; i < end; ++i) {
      const Mark& mark = marks_[i];
      const int level = !mark.accepted ? 0 : *mark.accepted ? 1 : 2;
      if (level != pass || !mark.drawn) continue;
      if (!covered(view, mark.fix, mark.solution, level == 2).intersects(exposed)) continue;
      const QPointF at = view.to_screen(mark.fix);
      if (level == 0) draw_fix_not_used(painter, at, colours);
      if (level == 1) draw_fix_used(painter, at, colours);
      if (level == 2) draw_fix_refused(painter, at, view.to_screen(mark.solution), colours);
    }
}

void FixLayer::paint(QPainter& painter, const ChartView& view, const QRect& exposed,
                     const Colours& colours) const {
  paint_range(painter, view, exposed, 0, painted_, colours);
}

QRect FixLayer::added(const ChartView& view) const {
  QRectF all;
  for (std::size_t i = painted_; i < shown_; ++i)
    all |= covered(view, marks_[i].fix, marks_[i].solution, marks_[i].accepted == false);
  return all.toAlignedRect();
}

void FixLayer::paint_added(QPainter& painter, const ChartView& view, const Colours& colours) const {
  paint_range(painter, view, added(view), painted_, shown_, colours);
}

void FixLayer::settle() {
  painted_ = shown_;
  pending_ = Change::none;
}

}  // namespace leadline::ui
