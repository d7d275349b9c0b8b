#pragma once

#include <QWidget>
#include <array>
#include <vector>

#include "ui/models/chart_choice.h"
#include "ui/widgets/fold.h"

namespace leadline::ui {

class ToolButton;

/// The tools of the chart, one below the other. It shows what it was told; a press only asks.
class Rail final : public QWidget {
  Q_OBJECT

 public:
  explicit Rail(QWidget* parent = nullptr);

  void set_tool(Tool tool);
  void set_following(bool following);
  void set_orientation(Orientation orientation);
  void set_fold(Fold fold);  ///< 52 or 44 px wide
  /// Whether there are links to look at, and whether they are in sight.
  void set_links(bool any, bool shown);
  [[nodiscard]] QSize sizeHint() const override;

 signals:
  void toolChosen(leadline::ui::Tool tool);
  void followToggled();
  void orientationChosen(leadline::ui::Orientation orientation);
  void layersRequested();
  void linksToggled();
  void zoomed(int direction);  ///< +1 closer, -1 farther
  void paletteStepped();

 protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  [[nodiscard]] std::vector<std::vector<ToolButton*>> groups() const;
  void place();

  std::array<ToolButton*, 3> tools_{}, orientations_{};
  ToolButton *follow_, *layers_, *links_, *closer_, *farther_, *palette_;
  std::vector<int> rules_;  ///< y of the lines between groups
  Fold fold_ = Fold::wide;
};

}  // namespace leadline::ui
