#pragma once

#include <QPainter>
#include <QString>
#include <cstdint>
#include <optional>
#include <vector>

#include "ui/chart/chart_view.h"
#include "ui/look/colours.h"

namespace leadline::ui {

/// One layer in force, as the badge tells it.
struct BadgeLine {
  enum class Doubt : std::uint8_t { none, accuracy_unknown, broken };
  QString name;                      ///< "Bathymetry 5 m"
  QString detail;                    ///< "2025-08 · ± 8 m · shift 3.2 m at 041°"; what is broken and why
  Doubt doubt = Doubt::none;         ///< with the caution icon
  std::optional<double> accuracy_m;  ///< for the folded badge
};

/// What one line says of the lot when the badge is folded: broken before unknown accuracy before the largest.
[[nodiscard]] BadgeLine worst_of(const std::vector<BadgeLine>& lines);

/// Top left. Returns its rectangle; null without lines. A click on it folds: the caller's.
QRectF draw_layer_badge(QPainter& painter, const ChartView& view, const std::vector<BadgeLine>& lines,
                        bool folded, const Colours& colours);
[[nodiscard]] QRectF layer_badge_box(const ChartView& view, const std::vector<BadgeLine>& lines, bool folded);

}  // namespace leadline::ui
