#pragma once

#include <QWidget>
#include <vector>

#include "ui/models/table_rows.h"

namespace leadline::ui {

/// Row height of tables, header included.
inline constexpr int kTableRow = 19;

/// Check or alert icon, name, rate, age, latency, one quality figure. Columns stand still.
class SourcesTable final : public QWidget {
  Q_OBJECT

 public:
  explicit SourcesTable(QWidget* parent = nullptr);

  void set(const std::vector<SourceRow>& rows);
  [[nodiscard]] QSize sizeHint() const override;

 protected:
  bool event(QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;

 private:
  std::vector<SourceRow> rows_;
};

/// From, to, horizontal range, true bearing, slant range.
class RangeBearingTable final : public QWidget {
  Q_OBJECT

 public:
  explicit RangeBearingTable(QWidget* parent = nullptr);

  void set(const std::vector<RangeRow>& rows);
  [[nodiscard]] QSize sizeHint() const override;

 protected:
  bool event(QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;

 private:
  std::vector<RangeRow> rows_;
};

}  // namespace leadline::ui
