#include "ui/panels/console_window.h"

#include <QAction>
#include <QApplication>
#include <QDialog>
#include <QDialogButtonBox>
#include <QFileDialog>
#include <QHeaderView>
#include <QLabel>
#include <QMenu>
#include <QMessageBox>
#include <QPainter>
#include <QPainterPath>
#include <QTableWidget>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "core/geo/geodesy.h"
#include "ui/look/look.h"
#include "ui/models/link_rows.h"
#include "ui/models/own_data.h"
#include "ui/panels/alert_bar.h"
#include "ui/panels/link_panel.h"
#include "ui/panels/own_data_panel.h"
#include "ui/panels/rail.h"
#include "ui/panels/replay_bar.h"
#include "ui/panels/status_bar.h"
#include "ui/panels/table_panels.h"
#include "ui/panels/top_bar.h"
#include "ui/widgets/tile_strip.h"

namespace leadline::ui {
namespace {

constexpr int kFrame_px = 8;  ///< round the window in replay
constexpr double kStripe_px = 14.0, kStripeGap_px = 6.0;
constexpr int kPanelGap_px = 5;
constexpr double kKeyZoom = 1.5;

Fold fold_for(QSize size) {
  if (size.width() < 1000 || size.height() < 700) return Fold::small;
  return size.width() < 1600 || size.height() < 900 ? Fold::compact : Fold::wide;
}

/// The raw monitor takes two fifths of the window at most and leaves as much to the chart.
int links_height(int window, int room) { return std::min(room - (window * 2 + 4) / 5, window * 2 / 5); }

/// Px of what has one in each fold.
int rail_width(Fold fold) { return fold == Fold::wide ? 52 : 44; }
int side_width(Fold fold) { return fold == Fold::wide ? 420 : 336; }

void paint_stripes(QPainter& painter, const QRect& all, const QRect& inside, const Colours& colours) {
  QPainterPath frame;
  frame.setFillRule(Qt::OddEvenFill);
  frame.addRect(all);
  frame.addRect(inside);
  painter.setClipPath(frame);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(QPen(colours.of(Role::replay), kStripe_px, Qt::SolidLine, Qt::FlatCap));
  const double period = (kStripe_px + kStripeGap_px) * std::sqrt(2.0);
  for (double x = -double(all.height()); x < all.width() + period; x += period)
    painter.drawLine(QPointF(x, all.height() + 1.0), QPointF(x + all.height() + 2.0, -1.0));
}

}  // namespace

ConsoleWindow::ConsoleWindow(QWidget* parent) : QWidget(parent) {
  setObjectName("console");
  setAccessibleName("Leadline console");
  setWindowTitle("Leadline");
  setMinimumSize(800, 600);
  // In the order of reading, which is the order of Tab.
  alert_bar_ = new AlertBar(this);
  top_bar_ = new TopBar(this);
  strip_ = new TileStrip(this);
  rail_ = new Rail(this);
  chart_ = new ChartCanvas(this);
  replay_bar_ = new ReplayBar(this);
  links_ = new LinkPanel(this);
  links_->hide();
  vehicle_ = new OwnDataPanel(OwnDataPanel::Kind::vehicle, {}, this);
  ship_ = new OwnDataPanel(OwnDataPanel::Kind::ship, {}, this);
  ranges_ = new RangePanel(this);
  sources_ = new SourcesPanel(this);
  status_bar_ = new StatusBar(this);

  connect_rail();
  make_actions();
  connect(alert_bar_, &AlertBar::allAlertsRequested, this, &ConsoleWindow::show_alerts);
  connect(chart_, &ChartCanvas::cursorMoved, this, &ConsoleWindow::show_cursor);
  connect(chart_, &ChartCanvas::viewChanged, this, &ConsoleWindow::show_status);
  connect(&Look::current(), &Look::lookChanged, this, qOverload<>(&QWidget::update));
  show_snapshot({});
}

ConsoleWindow::~ConsoleWindow() = default;

void ConsoleWindow::connect_rail() {
  connect(rail_, &Rail::toolChosen, chart_, &ChartCanvas::set_tool);
  connect(rail_, &Rail::followToggled, this, &ConsoleWindow::follow_next);
  connect(rail_, &Rail::orientationChosen, chart_, &ChartCanvas::set_orientation);
  connect(rail_, &Rail::layersRequested, this, &ConsoleWindow::show_layers_menu);
  connect(rail_, &Rail::linksToggled, this, [this] { show_link_panel(!links_shown()); });
  connect(rail_, &Rail::zoomed, this,
          [this](int direction) { chart_->zoom_by(direction > 0 ? kKeyZoom : 1.0 / kKeyZoom); });
  connect(rail_, &Rail::paletteStepped, this, &ConsoleWindow::paletteStepped);
  connect(chart_, &ChartCanvas::toolChanged, this, [this] {
    rail_->set_tool(chart_->tool());
    show_status();
  });
  connect(chart_, &ChartCanvas::followChanged, this,
          [this] { rail_->set_following(chart_->follow().has_value()); });
  connect(chart_, &ChartCanvas::orientationChanged, this,
          [this] { rail_->set_orientation(chart_->orientation()); });
}

QAction* ConsoleWindow::action(const char* name, const QString& text, const QList<QKeySequence>& keys,
                               std::function<void()> run) {
  auto* made = new QAction(text, this);
  made->setObjectName(name);
  made->setShortcuts(keys);
  connect(made, &QAction::triggered, this, std::move(run));
  addAction(made);
  return made;
}

void ConsoleWindow::make_actions() {
  action("open", "Open a session", {QKeySequence::Open}, [this] { emit openRequested(); });
  action("closer", "Closer", {QKeySequence("+"), QKeySequence("Ctrl++"), QKeySequence("=")},
         [this] { chart_->zoom_by(kKeyZoom); });
  action("farther", "Farther", {QKeySequence("-"), QKeySequence("Ctrl+-")},
         [this] { chart_->zoom_by(1.0 / kKeyZoom); });
  action("show_all", "Show all tracks", {QKeySequence("Ctrl+0")}, [this] {
    chart_->set_follow({});
    chart_->show_all();
  });
  action("follow", "Follow the vehicle, the ship, nothing", {QKeySequence("F2")}, [this] { follow_next(); });
  action("north_up", "North up", {QKeySequence("N")},
         [this] { chart_->set_orientation(Orientation::north_up); });
  action("head_up", "Head up", {QKeySequence("H")},
         [this] { chart_->set_orientation(Orientation::head_up); });
  action("course_up", "Course up", {QKeySequence("C")},
         [this] { chart_->set_orientation(Orientation::course_up); });
  action("select", "Select", {QKeySequence("S")}, [this] { chart_->set_tool(Tool::select); });
  action("pan", "Pan", {QKeySequence("P")}, [this] { chart_->set_tool(Tool::pan); });
  action("measure", "Measure", {QKeySequence("M")}, [this] { chart_->set_tool(Tool::measure); });
  action("leave_tool", "Leave the tool", {QKeySequence("Esc")}, [this] { chart_->set_tool(Tool::select); });
  action("palette", "Day, dusk, night", {QKeySequence("F5")}, [this] { emit paletteStepped(); });
  action("dimmer", "Dimmer", {QKeySequence("Ctrl+F5")}, [this] { emit dimmerStepped(); });
  action("position_format", "Position as DM, DD, DMS, UTM", {QKeySequence("F3")}, [this] {
    position_format_ = static_cast<PositionFormat>((static_cast<int>(position_format_) + 1) % 4);
    show_snapshot(snapshot_);
    show_status();
  });
  action("play", "Play, pause", {QKeySequence("Space")}, [this] { emit replay_bar_->playToggled(); });
  action("step_back", "Step back", {QKeySequence("Left")}, [this] { emit replay_bar_->stepped(-1); });
  action("step_forward", "Step forward", {QKeySequence("Right")}, [this] { emit replay_bar_->stepped(1); });
  action("loop", "Loop: A, B, none", {QKeySequence("L")}, [this] { replay_bar_->step_loop(); });
  action("previous_event", "Previous event", {QKeySequence("Ctrl+Left")},
         [this] { replay_bar_->seek_event(-1); });
  action("next_event", "Next event", {QKeySequence("Ctrl+Right")}, [this] { replay_bar_->seek_event(1); });
  action("alerts", "All alerts", {QKeySequence("Ctrl+L")}, [this] { show_alerts(); });
  action("layers", "Layers", {QKeySequence("F4")}, [this] { show_layers_menu(); });
  action("links", "Links and what they say", {QKeySequence("F7")},
         [this] { show_link_panel(!links_shown()); });
  action("regions", "Next region", {QKeySequence("F6")}, [this] {
    // In a small window the side column is a drawer that pushes the chart.
    if (fold_ == Fold::small) {
      drawer_ = !drawer_;
      if (drawer_) links_unfolded_ = false;
      place();
      return;
    }
    const std::vector<QWidget*> regions{chart_, replay_bar_, links_, rail_, alert_bar_};
    const auto here = std::find_if(regions.begin(), regions.end(), [](QWidget* w) {
      return w->hasFocus() || w->isAncestorOf(QApplication::focusWidget());
    });
    const std::size_t next = here == regions.end() ? 0 : static_cast<std::size_t>(here - regions.begin()) + 1;
    for (std::size_t i = 0; i < regions.size(); ++i) {
      QWidget* region = regions[(next + i) % regions.size()];
      if (!region->isVisible()) continue;
      QWidget* first = region->focusPolicy() != Qt::NoFocus ? region : nullptr;
      for (QWidget* child : region->findChildren<QWidget*>())
        if (first == nullptr && child->isEnabled() && child->isVisible() &&
            (child->focusPolicy() & Qt::TabFocus))
          first = child;
      if (first == nullptr) continue;
      first->setFocus(Qt::ShortcutFocusReason);
      return;
    }
  });
  action("full_screen", "Full screen", {QKeySequence("F11")},
         [this] { isFullScreen() ? showNormal() : showFullScreen(); });
  action("quit", "Quit", {QKeySequence::Quit, QKeySequence("Ctrl+Q")}, [this] { emit quitRequested(); });
  action("keys", "Keys", {QKeySequence("F1")}, [this] {
    QString rows;
    for (const QAction* a : actions())
      if (!a->shortcuts().isEmpty())
        rows += QStringLiteral("<tr><td><b>%1</b>&nbsp;&nbsp;</td><td>%2</td></tr>")
                    .arg(a->shortcuts().front().toString(QKeySequence::NativeText).toHtmlEscaped(),
                         a->text().toHtmlEscaped());
    QMessageBox box(QMessageBox::NoIcon, "Keys", "<table>" + rows + "</table>", QMessageBox::Close, this);
    box.setObjectName("keys_dialog");
    box.exec();
  });
}

void ConsoleWindow::set_history(const History* history, EngineId shown) {
  history_ = history;
  shown_ = shown;
  timeline_ = TimelineModel();
  chart_->set_history(history);
}

void ConsoleWindow::show_snapshot(const Snapshot& snapshot) {
  const bool replay_changed = snapshot.replay != snapshot_.replay;
  const bool bodies_changed = snapshot.vehicle.has_value() != snapshot_.vehicle.has_value() ||
                              snapshot.ship.has_value() != snapshot_.ship.has_value() ||
                              snapshot.sources.size() != snapshot_.sources.size();
  snapshot_ = snapshot;
  top_bar_->set(top_bar_text(snapshot_));
  show_alert_bar();
  const OwnDataText vehicle = vehicle_text(snapshot_, position_format_),
                    ship = ship_text(snapshot_, position_format_);
  vehicle_->set(vehicle);
  ship_->set(ship);
  strip_->set(snapshot_.vehicle ? vehicle : ship);
  // A row that had its figures once keeps its place.
  ship_rows_.rose = !snapshot_.vehicle;
  ship_rows_.depth_altitude |= ship.depth || ship.altitude;
  ship_rows_.attitude |= !snapshot_.vehicle && (ship.roll || ship.pitch || ship.current);
  ship_->set_rows(ship_rows_);
  ranges_->set(ranges_text(snapshot_));
  sources_->set(sources_text(snapshot_));
  if (history_ != nullptr) {
    timeline_.update(*history_, shown_);
    replay_bar_->set_data(timeline_.data());
  }
  replay_bar_->set_now(snapshot_.now);
  chart_->set_snapshot(snapshot_);
  if (replay_changed || bodies_changed) {
    place();
    update();
  }
}

void ConsoleWindow::set_notice(const QString& sentence) {
  notice_ = sentence;
  show_alert_bar();
}

void ConsoleWindow::set_links(const std::vector<LinkRow>& rows) {
  const bool any = !rows.empty(), had_any = !links_open_.empty();
  std::string open = any ? links_open(rows) : "";
  open = open.substr(0, open.rfind(' '));  // the status bar says what of
  links_->set(rows);
  if (open == links_open_) return;
  links_open_ = open;
  show_status();
  if (any != had_any) place();
}

bool ConsoleWindow::links_shown() const {
  return links_unfolded_ && !links_open_.empty() && !snapshot_.replay;
}

void ConsoleWindow::show_link_panel(bool shown) {
  links_unfolded_ = shown;
  if (links_shown()) drawer_ = false;  // in a small window there is room for one of them
  place();
}

void ConsoleWindow::show_alert_bar() {
  alert_bar_->set(notice_.isEmpty() ? alert_bar_text(snapshot_) : notice_text());
}

AlertBarText ConsoleWindow::notice_text() const {
  AlertBarText text;
  text.replay = true;  // there is nothing to acknowledge
  AlertBarText::Alert alert;
  alert.priority = Alarm::Priority::caution;
  alert.mark = AlertMark::acknowledged;
  alert.text = notice_.toStdString();
  text.alert = alert;
  text.counts[2] = 1;
  return text;
}

bool ConsoleWindow::settled() const {
  return chart_->settled() && (history_ == nullptr || history_->complete);
}

void ConsoleWindow::freeze() { alert_bar_->freeze(); }

std::vector<QWidget*> ConsoleWindow::side_panels() const {
  std::vector<QWidget*> panels;
  if (snapshot_.vehicle) panels.push_back(vehicle_);
  if (snapshot_.ship) panels.push_back(ship_);
  if (snapshot_.vehicle && (snapshot_.ship || !snapshot_.targets.empty())) panels.push_back(ranges_);
  if (!snapshot_.sources.empty()) panels.push_back(sources_);
  return panels;
}

void ConsoleWindow::resizeEvent(QResizeEvent*) {
  fold(fold_for(size()));
  place();
}

void ConsoleWindow::fold(Fold fold) {
  if (fold != fold_) drawer_ = false;
  fold_ = fold;
  top_bar_->set_fold(fold);
  alert_bar_->set_fold(fold);
  rail_->set_fold(fold);
  replay_bar_->set_fold(fold);
  status_bar_->set_fold(fold);
  vehicle_->set_fold(fold);
  ship_->set_fold(fold);
}

void ConsoleWindow::place() {
  const bool replay = snapshot_.replay, small = fold_ == Fold::small;
  QRect rest = replay ? rect().adjusted(kFrame_px, kFrame_px, -kFrame_px, -kFrame_px) : rect();
  const auto take_top = [&](QWidget* widget, int height) {
    widget->setGeometry(rest.left(), rest.top(), rest.width(), height);
    rest.setTop(rest.top() + height);
  };
  const auto take_bottom = [&](QWidget* widget, int height) {
    widget->setGeometry(rest.left(), rest.bottom() - height + 1, rest.width(), height);
    rest.setBottom(rest.bottom() - height);
  };
  take_top(top_bar_, top_bar_->sizeHint().height());
  take_top(alert_bar_, alert_bar_->sizeHint().height());
  take_bottom(status_bar_, status_bar_->sizeHint().height());
  strip_->setVisible(small);
  if (small) take_top(strip_, strip_->sizeHint().height());

  const bool rail = !small || drawer_;
  rail_->setVisible(rail);
  if (rail) {
    rail_->setGeometry(rest.left(), rest.top(), rail_width(fold_), rest.height());
    rest.setLeft(rest.left() + rail_width(fold_));
  }
  const std::vector<QWidget*> panels = side_panels();
  const bool side = !panels.empty() && (!small || drawer_);
  const int bottom = rest.bottom();
  int y = rest.top() + kPanelGap_px;
  for (QWidget* panel : {static_cast<QWidget*>(vehicle_), static_cast<QWidget*>(ship_),
                         static_cast<QWidget*>(ranges_), static_cast<QWidget*>(sources_)}) {
    const bool wanted = side && std::find(panels.begin(), panels.end(), panel) != panels.end();
    const int height = panel->sizeHint().height();
    const bool fits = wanted && y + height <= bottom + 1;
    panel->setVisible(fits);
    if (!fits) continue;
    panel->setGeometry(rest.right() + 1 - side_width(fold_) + kPanelGap_px, y,
                       side_width(fold_) - 2 * kPanelGap_px, height);
    y += height + kPanelGap_px;
  }
  if (side) rest.setRight(rest.right() - side_width(fold_));
  replay_bar_->setVisible(replay);
  if (replay) take_bottom(replay_bar_, replay_bar_->sizeHint().height());
  rail_->set_links(!links_open_.empty() && !replay, links_shown());
  links_->setVisible(links_shown());
  if (links_shown()) take_bottom(links_, links_height(height(), rest.height()));
  chart_->setGeometry(rest);
}

void ConsoleWindow::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  const Colours& colours = Look::current().colours();
  painter.fillRect(rect(), colours.of(Role::bg_window));
  if (snapshot_.replay)
    paint_stripes(painter, rect(), rect().adjusted(kFrame_px, kFrame_px, -kFrame_px, -kFrame_px), colours);
}

void ConsoleWindow::show_cursor(std::optional<Geodetic> place) {
  cursor_ = place;
  show_status();
}

void ConsoleWindow::show_status() {
  StatusBarText text;
  const auto& body = snapshot_.vehicle ? snapshot_.vehicle : snapshot_.ship;
  if (cursor_) {
    text.cursor = position_line(*cursor_, position_format_);
    if (body) {
      const geo::GeodesicLine line = geo::geodesic(body->solution.position, *cursor_);
      text.from = body->name;
      text.range = distance_text(line.distance_m) + "  " + heading_text(line.azimuth) + "° T";
    }
  }
  const std::string utm = position_text(chart_->view().centre(), PositionFormat::utm).first;
  const auto zone = utm.substr(0, utm.find(' '));
  text.datum = "WGS 84" + (zone.find("°") == std::string::npos ? " · UTM " + zone : std::string());
  if (chart_->tool() == Tool::measure) text.tool = "Measure", text.tool_key = "M";
  text.screen = "20 Hz  newest wins";
  text.links = snapshot_.replay ? "closed in replay" : links_open_.empty() ? "none" : links_open_;
  status_bar_->set(text);
}

void ConsoleWindow::follow_next() {
  std::vector<std::optional<Body>> choices;
  if (snapshot_.vehicle) choices.emplace_back(Body::vehicle);
  if (snapshot_.ship) choices.emplace_back(Body::ship);
  choices.emplace_back(std::nullopt);
  const auto here = std::find(choices.begin(), choices.end(), chart_->follow());
  const std::size_t next = here == choices.end() ? 0 : static_cast<std::size_t>(here - choices.begin()) + 1;
  chart_->set_follow(choices[next % choices.size()]);
}

void ConsoleWindow::show_alerts() {
  QDialog dialog(this);
  dialog.setObjectName("alerts_dialog");
  dialog.setWindowTitle("All alerts");
  dialog.resize(760, 420);
  auto* list = new QTableWidget(&dialog);
  list->setObjectName("alerts_list");
  list->setAccessibleName("Alerts, newest first");
  list->setEditTriggers(QAbstractItemView::NoEditTriggers);
  list->setSelectionBehavior(QAbstractItemView::SelectRows);
  list->setColumnCount(4);
  list->setHorizontalHeaderLabels({"Time", "Priority", "What", "Source"});
  list->verticalHeader()->hide();
  list->horizontalHeader()->setSectionResizeMode(2, QHeaderView::Stretch);
  static constexpr const char* kWords[] = {"caution", "warning", "alarm", "emergency"};
  for (const AlertState& alert : snapshot_.alerts) {
    const int row = list->rowCount();
    list->insertRow(row);
    const QString cells[] = {QString::fromStdString(time_text(alert.raised)),
                             kWords[static_cast<std::size_t>(alert.priority)],
                             QString::fromStdString(alert.text), QString::fromStdString(alert.source)};
    for (int column = 0; column < 4; ++column)
      list->setItem(row, column, new QTableWidgetItem(cells[column]));
  }
  auto* rows = new QVBoxLayout(&dialog);
  if (snapshot_.alerts.empty()) rows->addWidget(new QLabel("No alerts up to this time", &dialog));
  rows->addWidget(list);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, &dialog);
  connect(buttons, &QDialogButtonBox::rejected, &dialog, &QDialog::reject);
  rows->addWidget(buttons);
  dialog.exec();
}

void ConsoleWindow::show_layers_menu() {
  QMenu menu(this);
  menu.setObjectName("layers_menu");
  menu.addAction("Add a chart…", this, [this] {
    const QStringList files = QFileDialog::getOpenFileNames(this, "Charts: GeoTIFF or MBTiles", {},
                                                            "Charts (*.tif *.tiff *.mbtiles);;All files (*)",
                                                            nullptr, QFileDialog::DontUseNativeDialog);
    if (!files.isEmpty()) emit chartFilesChosen(files);
  });
  menu.exec(rail_->mapToGlobal(QPoint(rail_->width(), rail_->height() / 2)));
}

}  // namespace leadline::ui
