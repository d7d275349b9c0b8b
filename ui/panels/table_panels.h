#pragma once

#include "ui/models/table_rows.h"
#include "ui/widgets/panel.h"

namespace leadline::ui {

class RangeBearingTable;
class SourcesTable;

/// SOURCES: every link with rate, age, latency and one figure of quality.
class SourcesPanel final : public Panel {
  Q_OBJECT

 public:
  explicit SourcesPanel(QWidget* parent = nullptr);

  void set(const SourcesText& text);
  [[nodiscard]] QSize sizeHint() const override;
  [[nodiscard]] QSize minimumSizeHint() const override { return {320, sizeHint().height()}; }

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  SourcesTable* table_;
};

/// RANGE AND BEARING between any two bodies.
class RangePanel final : public Panel {
  Q_OBJECT

 public:
  explicit RangePanel(QWidget* parent = nullptr);

  void set(const RangesText& text);
  [[nodiscard]] QSize sizeHint() const override;
  [[nodiscard]] QSize minimumSizeHint() const override { return {320, sizeHint().height()}; }

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  RangeBearingTable* table_;
};

}  // namespace leadline::ui
