#pragma once

#include <QTimer>
#include <QWidget>

#include "ui/models/bar_text.h"
#include "ui/widgets/fold.h"

namespace leadline::ui {

class Button;

/// Always there. What nobody has answered blinks in its lead block (alarm 1 Hz, warning 0.5 Hz); text stands
/// still. In replay it speaks of what was recorded, does not blink and has nothing to acknowledge.
class AlertBar final : public QWidget {
  Q_OBJECT

 public:
  explicit AlertBar(QWidget* parent = nullptr);

  void set(const AlertBarText& text);
  void set_fold(Fold fold);  ///< 40 px high, 36 when folded: then the cause is in the tool tip
  /// Blinking stands "on", for pictures.
  void freeze();
  [[nodiscard]] QSize sizeHint() const override;

 signals:
  void acknowledged();
  void silenced();
  void allAlertsRequested();

 protected:
  bool event(QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  [[nodiscard]] int lead_width() const;
  [[nodiscard]] int counts_left() const;
  void paint_message(QPainter& painter) const;
  void paint_counts(QPainter& painter) const;
  void place();

  AlertBarText text_;
  Fold fold_ = Fold::wide;
  Button *acknowledge_, *silence_, *all_;
  QTimer blink_;
  bool lit_ = true, frozen_ = false;
};

}  // namespace leadline::ui
