#pragma once

#include <QWidget>
#include <functional>
#include <optional>

#include "ui/bridge/snapshot.h"
#include "ui/chart/chart_canvas.h"
#include "ui/models/bar_text.h"
#include "ui/models/figures.h"
#include "ui/models/timeline.h"
#include "ui/panels/own_data_panel.h"
#include "ui/widgets/fold.h"

class QAction;

namespace leadline::ui {

class AlertBar;
class LinkPanel;
struct LinkRow;
class Rail;
class RangePanel;
class ReplayBar;
class SourcesPanel;
class StatusBar;
class TileStrip;
class TopBar;

/// The console: bars, rail, chart, side column and, in replay, the timeline. It shows the snapshot it is
/// given and says what the operator wants; it knows no session and no device. GUI thread.
class ConsoleWindow final : public QWidget {
  Q_OBJECT

 public:
  explicit ConsoleWindow(QWidget* parent = nullptr);
  ~ConsoleWindow() override;

  [[nodiscard]] ChartCanvas& chart() { return *chart_; }
  [[nodiscard]] ReplayBar& replay_bar() { return *replay_bar_; }
  /// The history stays the caller's and outlives the window.
  void set_history(const History* history, EngineId shown);
  void show_snapshot(const Snapshot& snapshot);
  /// A sentence for the operator in the alert bar's place, while nothing is open or what is open cannot be
  /// read.
  void set_notice(const QString& sentence);
  /// The raw monitor is there when there are links: none, and in replay, it is absent.
  void set_links(const std::vector<LinkRow>& rows);
  [[nodiscard]] LinkPanel& link_panel() { return *links_; }
  /// Unfolds it or folds it away, as F7 and the rail do. Folded at first.
  void show_link_panel(bool shown);
  /// Nothing is being loaded and nothing blinks: ready for a picture.
  [[nodiscard]] bool settled() const;
  /// Blinking stands still, for pictures.
  void freeze();

 signals:
  void openRequested();
  void chartFilesChosen(const QStringList& files);
  void paletteStepped();
  void dimmerStepped();
  void quitRequested();

 protected:
  void resizeEvent(QResizeEvent* event) override;
  void paintEvent(QPaintEvent* event) override;

 private:
  void make_actions();
  QAction* action(const char* name, const QString& text, const QList<QKeySequence>& keys,
                  std::function<void()> run);
  void connect_rail();
  void place();
  void fold(Fold fold);
  void show_cursor(std::optional<Geodetic> place);
  void show_status();
  void show_alert_bar();
  void follow_next();
  void show_layers_menu();
  void show_alerts();
  [[nodiscard]] bool links_shown() const;
  [[nodiscard]] std::vector<QWidget*> side_panels() const;
  [[nodiscard]] AlertBarText notice_text() const;

  TopBar* top_bar_;
  AlertBar* alert_bar_;
  TileStrip* strip_;
  Rail* rail_;
  ChartCanvas* chart_;
  OwnDataPanel *vehicle_, *ship_;
  RangePanel* ranges_;
  SourcesPanel* sources_;
  ReplayBar* replay_bar_;
  LinkPanel* links_;
  StatusBar* status_bar_;

  Fold fold_ = Fold::wide;
  bool drawer_ = false;  ///< of a small window: rail and side column are out
  bool links_unfolded_ = false;
  std::string links_open_;  ///< "5 of 6"; empty: there are no links
  OwnDataRows ship_rows_{true, false, false};
  QString notice_;
  PositionFormat position_format_ = PositionFormat::dm;
  Snapshot snapshot_;
  const History* history_ = nullptr;
  EngineId shown_ = 0;
  TimelineModel timeline_;
  std::optional<Geodetic> cursor_;
};

}  // namespace leadline::ui
