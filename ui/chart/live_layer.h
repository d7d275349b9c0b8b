#pragma once

#include <QPainter>
#include <optional>
#include <vector>

#include "ui/bridge/snapshot.h"
#include "ui/chart/chart_view.h"
#include "ui/chart/labels.h"
#include "ui/chart/symbols.h"

namespace leadline::ui {

/// What moves over the chart: symbols with their lines, ellipses, labels, and marks at the edge for what lies
/// outside. Keeps only where labels stood, so that they stand still. GUI thread.
class LiveLayer {
 public:
  /// taken: rectangles of the furniture. follow: the body ranges at the edge are told from; empty: the
  /// middle.
  void paint(QPainter& painter, const ChartView& view, const Snapshot& snapshot, std::optional<Body> follow,
             const std::vector<QRectF>& taken, const Colours& colours);

 private:
  LabelPlaces places_;
};

/// How old the symbol of a body looks.
[[nodiscard]] SymbolState symbol_state(const Snapshot& snapshot, const BodyState& body);

}  // namespace leadline::ui
