#pragma once

#include <QPixmap>
#include <QWidget>
#include <optional>

#include "ui/models/timeline_data.h"

namespace leadline::ui {

/// The run on one line. Press or drag to seek; Left and Right move 1 s (Shift 10 s, Ctrl 1 min), Page Up and
/// Down a tenth of what is shown, Home and End to its ends; the wheel zooms about the pointer.
class Timeline final : public QWidget {
  Q_OBJECT

 public:
  explicit Timeline(QWidget* parent = nullptr);

  /// Shows the whole run, unless the operator has zoomed.
  void set_data(const TimelineData& newer);
  void set_now(Time now);
  void set_loop(std::optional<TimeSpan> loop);
  /// Clamped to the run; at least 10 s long.
  void set_span(TimeSpan span);
  [[nodiscard]] TimeSpan span() const { return span_; }
  [[nodiscard]] QSize sizeHint() const override;

 signals:
  void sought(Time time);

 protected:
  bool event(QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void changeEvent(QEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  void seek(Time time);
  void redraw();  ///< also what stands still
  [[nodiscard]] QString words_at(double x) const;

  TimelineData data_;
  TimeSpan span_;
  Time now_;
  std::optional<Time> scrubbed_;  ///< while the mouse holds the play head
  std::optional<TimeSpan> loop_;
  QPixmap still_;
};

}  // namespace leadline::ui
