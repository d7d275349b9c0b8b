#pragma once

#include "ui/models/table_rows.h"
#include "ui/widgets/panel.h"

namespace leadline::ui {

class RangeBearingTable;
class SourcesTable;

/// A panel around one table; without its subject it keeps the room of one row, for the reason.
class TablePanel : public Panel {
 public:
  [[nodiscard]] QSize sizeHint() const override;
  [[nodiscard]] QSize minimumSizeHint() const override { return {320, sizeHint().height()}; }

 protected:
  TablePanel(const char* object_name, const QString& name, QWidget* table, QWidget* parent);
  /// After the table has its rows. absent: why it has none; empty: it has some.
  void arrange(const std::string& fact, const std::string& absent);
  void resizeEvent(QResizeEvent* event) override;

 private:
  QWidget* table_;
  int height_ = 0;
};

/// SOURCES: every link with rate, age, latency and one figure of quality.
class SourcesPanel final : public TablePanel {
  Q_OBJECT

 public:
  explicit SourcesPanel(QWidget* parent = nullptr);
  void set(const SourcesText& text);

 private:
  explicit SourcesPanel(SourcesTable* table, QWidget* parent);
  SourcesTable* table_;
};

/// RANGE AND BEARING between any two bodies.
class RangePanel final : public TablePanel {
  Q_OBJECT

 public:
  explicit RangePanel(QWidget* parent = nullptr);
  void set(const RangesText& text);

 private:
  explicit RangePanel(RangeBearingTable* table, QWidget* parent);
  RangeBearingTable* table_;
};

}  // namespace leadline::ui
