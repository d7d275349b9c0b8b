#pragma once

#include <QPainter>
#include <QWidget>
#include <optional>

#include "ui/look/colours.h"
#include "ui/models/tile_text.h"

namespace leadline::ui {

/// North-up rose of 144 px about `centre`: own arrow and line at the heading, dashed line at the course,
/// double-shaft arrow with the current (toward), bug outside the ring at the set heading. own: `vehicle` or
/// `ship`. A stale heading is an outline, a lost one is not drawn.
void draw_compass_rose(QPainter& painter, QPointF centre, const RoseAngles& angles, Role own,
                       const Colours& colours);

class CompassRose final : public QWidget {
  Q_OBJECT

 public:
  explicit CompassRose(Role own, QWidget* parent = nullptr);

  void set(const std::optional<RoseAngles>& angles);
  [[nodiscard]] QSize sizeHint() const override { return {158, 151}; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  Role own_;
  std::optional<RoseAngles> angles_;
};

}  // namespace leadline::ui
