#pragma once

#include <QWidget>

#include "ui/models/bar_text.h"
#include "ui/widgets/fold.h"

namespace leadline::ui {

class AvailabilityBoxes;

/// Name, mode, dive and file, availability, outputs, UTC. Every part has its place; what is too long is cut
/// with an ellipsis and said by the tool tip.
class TopBar final : public QWidget {
  Q_OBJECT

 public:
  explicit TopBar(QWidget* parent = nullptr);

  void set(const TopBarText& text);
  void set_fold(Fold fold);  ///< 48, 44 or 40 px high
  [[nodiscard]] QSize sizeHint() const override;

 protected:
  bool event(QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  /// Left edges of the parts, px; a part that is folded away has no width.
  struct Places {
    int mode = 0, dive = 0, availability = 0, free = 0, outputs = 0, clock = 0;
  };
  [[nodiscard]] Places places() const;
  void paint_mode(QPainter& painter, const Places& at) const;
  void paint_dive(QPainter& painter, const Places& at) const;
  void paint_availability(QPainter& painter, const Places& at) const;
  void paint_outputs(QPainter& painter, const Places& at) const;
  void paint_clock(QPainter& painter, const Places& at) const;
  void place_boxes();

  TopBarText text_;
  Fold fold_ = Fold::wide;
  AvailabilityBoxes* boxes_;
};

}  // namespace leadline::ui
