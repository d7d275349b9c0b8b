#pragma once

#include <QWidget>
#include <array>

#include "ui/models/tile_text.h"

namespace leadline::ui {

class ValueTile;

/// What never folds away at 800 x 600: position, heading, depth, altitude, 56 px high.
class TileStrip final : public QWidget {
  Q_OBJECT

 public:
  explicit TileStrip(QWidget* parent = nullptr);

  void set(const OwnDataText& text);
  [[nodiscard]] QSize sizeHint() const override { return {800, 56}; }

 protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  std::array<ValueTile*, 4> tiles_{};
};

}  // namespace leadline::ui
