#pragma once

#include <QWidget>

#include "ui/models/bar_text.h"
#include "ui/widgets/fold.h"

namespace leadline::ui {

/// The cursor's read-out at the left, the machine's at the right; 28, 24 or 22 px.
class StatusBar final : public QWidget {
  Q_OBJECT

 public:
  explicit StatusBar(QWidget* parent = nullptr);

  void set(const StatusBarText& text);
  void set_fold(Fold fold);  ///< small: the cursor only
  [[nodiscard]] QSize sizeHint() const override;

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  StatusBarText text_;
  Fold fold_ = Fold::wide;
};

}  // namespace leadline::ui
