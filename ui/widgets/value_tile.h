#pragma once

#include <QWidget>
#include <optional>

#include "ui/models/tile_text.h"
#include "ui/widgets/tile_painter.h"

namespace leadline::ui {

/// One figure; without a text its place stays empty. Repainted only when what it says changes.
class ValueTile final : public QWidget {
  Q_OBJECT

 public:
  explicit ValueTile(TileStyle style = {}, QWidget* parent = nullptr);

  void set(const std::optional<TileText>& text);
  [[nodiscard]] const std::optional<TileText>& text() const { return text_; }
  [[nodiscard]] QSize sizeHint() const override;

 protected:
  bool event(QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;

 private:
  TileStyle style_;
  std::optional<TileText> text_;
};

}  // namespace leadline::ui
