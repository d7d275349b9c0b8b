#pragma once

#include <QWidget>
#include <optional>

#include "ui/bridge/snapshot.h"
#include "ui/chart/background.h"
#include "ui/chart/chart_view.h"
#include "ui/chart/fix_layer.h"
#include "ui/chart/ground.h"
#include "ui/chart/layer_badge.h"
#include "ui/chart/legend.h"
#include "ui/chart/live_layer.h"
#include "ui/chart/orientation_box.h"
#include "ui/chart/overview.h"
#include "ui/chart/track_layer.h"

namespace leadline::ui {

/// The one chart. What stands (sea, rasters, graticule, tracks, fixes) is kept as a picture that scrolls;
/// what moves (symbols, labels, furniture) is painted over it each time. GUI thread.
class ChartCanvas final : public QWidget {
  Q_OBJECT

 public:
  explicit ChartCanvas(QWidget* parent = nullptr);

  /// Charts and coast line; stays the caller's and outlives the canvas. Null: plain water.
  void set_background(Background* background);
  /// The tracks and fixes that snapshots are shown with; stays the caller's. Null: none.
  void set_history(const History* history);
  /// The newest state; the one before is forgotten. Repaints.
  void set_snapshot(const Snapshot& snapshot);

  [[nodiscard]] const ChartView& view() const { return view_; }
  void set_centre(Geodetic centre);
  void set_metres_per_px(double metres_per_px);
  void zoom_by(double factor);
  /// All of the shown tracks, with some room around them.
  void show_all();
  [[nodiscard]] Orientation orientation() const { return orientation_; }
  void set_orientation(Orientation orientation);
  /// Keeps a body in the middle; empty: the chart stays where it is put.
  void set_follow(std::optional<Body> body);
  [[nodiscard]] std::optional<Body> follow() const { return follow_; }
  [[nodiscard]] Tool tool() const { return tool_; }
  void set_tool(Tool tool);

  /// Nothing is being loaded for what is shown now.
  [[nodiscard]] bool settled() const;

 signals:
  void viewChanged();
  /// The operator has chosen what he looks at.
  void viewTaken();
  void followChanged();
  void orientationChanged();
  void toolChanged();
  /// Empty: the cursor has left the chart.
  void cursorMoved(std::optional<leadline::Geodetic> place);

 protected:
  void paintEvent(QPaintEvent*) override;
  void resizeEvent(QResizeEvent*) override;
  void mousePressEvent(QMouseEvent*) override;
  void mouseMoveEvent(QMouseEvent*) override;
  void mouseReleaseEvent(QMouseEvent*) override;
  void mouseDoubleClickEvent(QMouseEvent*) override;
  void wheelEvent(QWheelEvent*) override;
  void keyPressEvent(QKeyEvent*) override;
  void leaveEvent(QEvent*) override;

 private:
  [[nodiscard]] const BodyState* followed() const;
  void keep_followed();
  void turn_to(Angle true_bearing, Geodetic at);
  void moved();
  void anew();
  void paint_ground(QPainter& painter, const QRect& exposed);
  void bring_ground_up_to_date();
  /// What the furniture says and where it stands in this frame.
  struct Furniture {
    OrientationFacts facts;
    std::vector<BadgeLine> badge;
    std::vector<LegendRow> legend;
    std::optional<QPoint> overview;  ///< its upper left corner; empty: no room
    std::vector<QRectF> taken;
  };
  [[nodiscard]] Furniture furniture() const;
  void paint_furniture(QPainter& painter, const Furniture& furniture);
  void paint_measured(QPainter& painter) const;
  void paint_cursor(QPainter& painter) const;

  ChartView view_;
  Orientation orientation_ = Orientation::north_up;
  std::optional<Body> follow_;
  Tool tool_ = Tool::select;

  Background* background_ = nullptr;
  const History* history_ = nullptr;
  Snapshot snapshot_;
  Ground ground_;
  TrackLayer tracks_;
  FixLayer fixes_;
  LiveLayer live_;
  Overview overview_;

  bool badge_folded_ = false;
  QRectF badge_box_;
  std::optional<QPoint> cursor_, dragged_from_;
  std::optional<Geodetic> measured_from_, measured_to_;
};

}  // namespace leadline::ui
