#pragma once

#include <QAbstractScrollArea>
#include <vector>

#include "ui/models/link_rows.h"

namespace leadline::ui {

/// A row a link under a header that stays; one row is selected. Up, Down, Home and End move. Columns stand
/// still; what is too long for its column is in the tool tip.
class LinkTable final : public QAbstractScrollArea {
  Q_OBJECT

 public:
  explicit LinkTable(QWidget* parent = nullptr);

  void set(const std::vector<LinkRow>& rows);
  /// Emits nothing. -1: none.
  void select(int row);
  [[nodiscard]] int selected() const { return selected_; }
  /// With room for all rows.
  [[nodiscard]] QSize sizeHint() const override;

 signals:
  void chosen(int row);

 protected:
  bool viewportEvent(QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  void choose(int row);
  void set_range();
  /// -1: none.
  [[nodiscard]] int row_at(int y) const;

  std::vector<LinkRow> rows_;
  int selected_ = -1;
};

}  // namespace leadline::ui
