#pragma once

#include <QPainter>
#include <optional>
#include <unordered_set>
#include <vector>

#include "ui/bridge/snapshot.h"
#include "ui/chart/chart_view.h"
#include "ui/look/colours.h"

namespace leadline::ui {

/// The position fixes of a history on a chart's plane: used, refused, not used. Of used ones that would lie
/// on top of each other at a scale the first is drawn; a refused one always is. GUI thread.
class FixLayer {
 public:
  enum class Change : std::uint8_t { none, grown, anew };
  /// What has happened since settle(); shows what was valid at or before `now`, at this view's scale.
  Change sync(const History& history, const ChartView& view, Time now);

  /// Fixes within `exposed` (screen px) that have been settled.
  void paint(QPainter& painter, const ChartView& view, const QRect& exposed, const Colours& colours) const;
  [[nodiscard]] QRect added(const ChartView& view) const;
  void paint_added(QPainter& painter, const ChartView& view, const Colours& colours) const;
  void settle();

  struct Kinds {
    bool used = false, refused = false, not_used = false;
  };
  [[nodiscard]] Kinds kinds() const { return kinds_; }

 private:
  struct Mark {
    maps::PlanePoint fix, solution;
    std::optional<bool> accepted;
    bool drawn = true;
  };
  void paint_range(QPainter& painter, const ChartView& view, const QRect& exposed, std::size_t first,
                   std::size_t end, const Colours& colours) const;
  void thin(std::size_t first, double metres_per_px);

  const History* history_ = nullptr;
  std::optional<Geodetic> origin_;
  double metres_per_px_ = 0.0;
  std::vector<Mark> marks_;
  std::unordered_set<std::uint64_t> taken_;
  std::size_t painted_ = 0, shown_ = 0;
  Kinds kinds_;
  Change pending_ = Change::none;
};

}  // namespace leadline::ui
