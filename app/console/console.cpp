// The console's wiring: a session's player on one side, the window on the other, a clock between.

#include <fmt/format.h>
#include <unistd.h>

#include <QApplication>
#include <QElapsedTimer>
#include <QFileDialog>
#include <QSettings>
#include <QTimer>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <limits>
#include <memory>

#include "app/console/request.h"
#include "ui/bridge/bridge.h"
#include "ui/bridge/raw_tail.h"
#include "ui/chart/background.h"
#include "ui/look/look.h"
#include "ui/models/link_rows.h"
#include "ui/models/session_player.h"
#include "ui/models/shown_runs.h"
#include "ui/panels/console_window.h"
#include "ui/panels/link_panel.h"
#include "ui/panels/replay_bar.h"

namespace leadline::app {
namespace {

constexpr int kDisplay_ms = 50;
constexpr int kFigures_ms = 200;                ///< numbers change five times a second at most
constexpr qint64 kLongestLoading_ms = 120'000;  ///< a picture waits so long for what it shows
constexpr double kMoment_s = 3.0;               ///< until a picture of a live run is taken
constexpr const char* kPalettes[] = {"day", "dusk", "night"};

ui::Palette palette_named(const std::string& name) {
  return name == "night" ? ui::Palette::night : name == "dusk" ? ui::Palette::dusk : ui::Palette::day;
}

ui::Body shown_body(Body body) {
  return body == Body::ship ? ui::Body::ship : body == Body::target ? ui::Body::target : ui::Body::vehicle;
}

/// How long this process has lived.
double age_s() {
  std::ifstream stat("/proc/self/stat"), uptime("/proc/uptime");
  std::string field;
  for (int i = 0; i < 22; ++i) stat >> field;  // 22: start, in clock ticks since the machine's (proc(5))
  double up_s = 0.0;
  uptime >> up_s;
  return up_s - std::strtod(field.c_str(), nullptr) / static_cast<double>(::sysconf(_SC_CLK_TCK));
}

class Console {
 public:
  explicit Console(const ConsoleRequest& request) : request_(request) {
    window_.chart().set_background(&background_);
    background_.load_coastline(request.charts_folder);
    charts_ = request.charts;
    background_.set_charts(charts_);
    connect();
  }

  Result<void> open(const std::string& path) {
    auto session = sessions::Session::open(path, sessions::Access::read);
    if (!session) return session.error();
    auto runs = ui::choose_runs(session.value());
    if (!runs) return runs.error();
    const sessions::Run& run = runs.value().back().run;
    auto sources = session.value().sources(run.id);
    if (!sources) return sources.error();
    ui::SetupNames names;
    if (const auto found = request_.names(path, run.id)) {
      names.vehicle = found.value().vehicle;
      if (found.value().ship_is_navigated && found.value().vehicle != "vehicle")
        names.ship = found.value().vehicle;
      names.engine = found.value().engine;
      names.navigated = found.value().ship_is_navigated ? ui::Body::ship : ui::Body::vehicle;
    } else {
      request_.say(found.error().line());
    }
    auto player = ui::SessionPlayer::open(path, std::move(runs.value()),
                                          ui::setup_of(run, sources.value(), path, names));
    if (!player) return player.error();
    window_.set_history(nullptr, 0);
    player_ = std::move(player.value());
    window_.set_notice({});
    window_.set_history(&player_->history(), player_->setup().shown);
    if (request_.after_s) player_->seek(player_->run().from + duration(*request_.after_s));
    view_is_ours_ = true;
    if (const auto place = somewhere()) window_.chart().set_centre(*place);
    window_.show_snapshot(player_->snapshot());
    return {};
  }

  /// Shows a live run from now on.
  void open_live(const ConsoleLive& live) {
    live_ = &live;
    ui::ConsoleSetup setup;
    setup.vehicle = live.names.vehicle;
    setup.navigated = live.names.ship_is_navigated ? ui::Body::ship : ui::Body::vehicle;
    if (live.names.ship_is_navigated && live.names.vehicle != "vehicle") setup.ship = live.names.vehicle;
    setup.engines = live.engines;
    for (std::size_t i = 0; i < live.sources.size(); ++i)
      setup.sources.push_back({live.sources[i].name, live.decoders[i], shown_body(live.sources[i].body)});
    const std::filesystem::path file(live.session);
    setup.dive = live.session.empty() ? "not recorded" : file.stem().string();
    setup.file = file.filename().string();
    bridge_ = std::make_unique<ui::Bridge>(setup);
    window_.set_notice({});
    window_.set_history(&bridge_->history(), setup.shown);
    QObject::connect(bridge_.get(), &ui::Bridge::looked, [this] { show_live(); });
    tail_ = std::make_unique<ui::RawTail>(live.sources.size());
    window_.link_panel().set_tail(tail_.get());
    live.start({bridge_.get(), tail_.get()});
    bridge_->start();
  }

  /// Ends the live run; its failure.
  Result<void> close_live() {
    if (!live_) return {};
    bridge_->stop();
    auto ended = live_->stop();
    window_.link_panel().set_tail(nullptr);
    return ended;
  }

  void run() {
    if (!player_ && !live_) window_.set_notice("No session is open: Ctrl+O opens one");
    show_first();
    window_.chart().setFocus();
    clock_.start();
    timer_.start(kDisplay_ms);
  }

  /// Waits until everything that belongs into the picture is there.
  Result<void> picture(const std::string& file) {
    show_first();
    QElapsedTimer waited;
    waited.start();
    if (live_) {
      const double wanted_s = request_.after_s.value_or(kMoment_s);
      while (static_cast<double>(waited.elapsed()) * 1e-3 < wanted_s && !live_->over())
        QApplication::processEvents(QEventLoop::AllEvents | QEventLoop::WaitForMoreEvents, kDisplay_ms);
      window_.show_snapshot(bridge_->snapshot());
      waited.start();
    }
    QPixmap picture;
    // What is painted asks for what is missing: the picture is taken again until nothing is.
    do {
      do {
        if (waited.elapsed() > kLongestLoading_ms)
          return Error{"was not loaded within two minutes", request_.session, "is the disk slow?"};
        QApplication::processEvents(QEventLoop::AllEvents, kDisplay_ms);
        tick();
      } while (!loaded());
      window_.setFocus();  // no ring in a picture
      window_.freeze();
      picture = window_.grab();
    } while (!loaded());
    request_.detail(fmt::format("everything in the picture after {:.2f} s", age_s()));
    if (picture.save(QString::fromStdString(file), "PNG")) return {};
    return Error{"cannot be written", file, "is there such a folder, and room on the disk?"};
  }

 private:
  void show_first() {
    window_.resize(request_.width, request_.height);
    window_.show();
    window_.repaint();
    request_.detail(fmt::format("first picture {:.2f} s after the start of the program", age_s()));
  }

  void show_live() {
    const ui::Snapshot& snapshot = bridge_->snapshot();
    // The chart goes where the first position is, until the operator looks at something of his own.
    if (view_is_ours_ && (snapshot.vehicle || snapshot.ship)) {
      window_.chart().set_centre((snapshot.vehicle ? snapshot.vehicle : snapshot.ship)->solution.position);
      view_is_ours_ = false;
    }
    if (figures_.isValid() && figures_.elapsed() < kFigures_ms) return window_.chart().set_snapshot(snapshot);
    figures_.start();
    window_.show_snapshot(snapshot);
    std::vector<ui::LinkState> links;
    for (const ConsoleLink& link : live_->links())
      links.push_back({link.address, link.sources, link.open, link.last_error, link.heard_bytes,
                       link.heard_frames, link.kernel_drops});
    window_.set_links(ui::link_rows(links, snapshot));
  }

  void connect() {
    using ui::ConsoleWindow;
    using ui::ReplayBar;
    QObject::connect(&timer_, &QTimer::timeout, [this] { tick(); });
    ReplayBar& bar = window_.replay_bar();
    QObject::connect(&bar, &ReplayBar::playToggled, [this] {
      if (player_) player_->playing() ? player_->pause() : player_->play();
      show();
    });
    QObject::connect(&bar, &ReplayBar::stepped, [this](int direction) {
      if (player_) direction > 0 ? player_->step_forward() : player_->step_back();
      show();
    });
    QObject::connect(&bar, &ReplayBar::speedChosen, [this](double speed) {
      if (player_) player_->set_speed(std::isfinite(speed) ? std::optional(speed) : std::nullopt);
      show();
    });
    QObject::connect(&bar, &ReplayBar::sought, [this](Time time) {
      if (player_) player_->seek(time);
      show();
    });
    QObject::connect(&bar, &ReplayBar::loopSet, [this](std::optional<ui::TimeSpan> loop) {
      if (player_) player_->set_loop(loop);
      show();
    });
    QObject::connect(&window_, &ConsoleWindow::openRequested, [this] { ask_for_session(); });
    QObject::connect(&window_, &ConsoleWindow::chartFilesChosen, [this](const QStringList& files) {
      for (const QString& file : files) charts_.push_back(file.toStdString());
      background_.set_charts(charts_);
    });
    QObject::connect(&window_, &ConsoleWindow::paletteStepped, [] {
      ui::Look& look = ui::Look::current();
      const int next = (static_cast<int>(look.colours().palette()) + 1) % 3;
      look.set(static_cast<ui::Palette>(next), look.dimmer_step());
      QSettings().setValue("palette", kPalettes[next]);
    });
    QObject::connect(&window_, &ConsoleWindow::dimmerStepped, [] {
      ui::Look& look = ui::Look::current();
      look.set(look.colours().palette(), (look.dimmer_step() + 1) % 5);
    });
    QObject::connect(&window_, &ConsoleWindow::quitRequested, [this] { window_.close(); });
    QObject::connect(&window_.chart(), &ui::ChartCanvas::viewTaken, [this] { view_is_ours_ = false; });
  }

  void ask_for_session() {
    const QString path =
        QFileDialog::getOpenFileName(&window_, "Open a session", {}, "Sessions (*.leadline);;All files (*)",
                                     nullptr, QFileDialog::DontUseNativeDialog);
    if (path.isEmpty()) return;
    request_.after_s.reset();
    if (const auto opened = open(path.toStdString()); !opened)
      window_.set_notice(QString::fromStdString(opened.error().line()));
  }

  /// Where the chart begins: the body at the play head, or where the first track begins.
  [[nodiscard]] std::optional<Geodetic> somewhere() const {
    const ui::Snapshot& s = player_->snapshot();
    if (s.vehicle) return s.vehicle->solution.position;
    if (s.ship) return s.ship->solution.position;
    for (const ui::Track& track : player_->history().tracks)
      if (!track.points.empty()) return track.points.front().position;
    return std::nullopt;
  }

  [[nodiscard]] bool window_is_for_picture() const { return !request_.screenshot.empty(); }

  [[nodiscard]] bool loaded() {
    if (player_ && !player_->history().complete && !player_->failure()) return false;
    return !view_is_ours_ && window_.settled() && window_.isVisible();
  }

  void tick() {
    if (live_ && live_->over()) window_.close();
    if (!player_) {
      if (!live_ || window_is_for_picture()) view_is_ours_ = false;
      return;
    }
    const auto passed = std::chrono::milliseconds(clock_.isValid() ? clock_.restart() : 0);
    const bool grown = player_->take_loaded();
    const bool moved = player_->advance(passed);
    // The whole way is in sight until the operator looks at something of his own.
    if (view_is_ours_ && player_->history().complete) {
      window_.chart().set_snapshot(player_->snapshot());
      window_.chart().show_all();
      view_is_ours_ = false;
    }
    if (player_->failure()) window_.set_notice(QString::fromStdString(player_->failure()->line()));
    if (grown || moved) show();
  }

  void show() {
    if (!player_) return;
    ui::ReplayBar& bar = window_.replay_bar();
    bar.set_playing(player_->playing());
    bar.set_speed(player_->speed().value_or(std::numeric_limits<double>::infinity()));
    const bool figures = !player_->playing() || !figures_.isValid() || figures_.elapsed() >= kFigures_ms;
    if (figures) figures_.start();
    if (figures)
      window_.show_snapshot(player_->snapshot());
    else
      window_.chart().set_snapshot(player_->snapshot());
  }

  ConsoleRequest request_;
  std::vector<std::string> charts_;
  ui::Background background_;
  std::unique_ptr<ui::SessionPlayer> player_;
  const ConsoleLive* live_ = nullptr;
  std::unique_ptr<ui::Bridge> bridge_;
  std::unique_ptr<ui::RawTail> tail_;
  ui::ConsoleWindow window_;  // shows the player's history: it goes first
  QTimer timer_;
  QElapsedTimer clock_, figures_;
  bool view_is_ours_ = true;
};

/// Who is told what Qt says; lives as long as leadline_console().
const ConsoleRequest* listener = nullptr;

/// Qt ends the program where it finds no display, after saying so in its own words.
void hear_qt(QtMsgType type, const QMessageLogContext& /*context*/, const QString& text) {
  if (type != QtFatalMsg) return listener->detail("Qt: " + text.toStdString());
  listener->say("there is no display to open (" + text.simplified().toStdString() +
                "): log in at a screen, or make a picture with --screenshot and QT_QPA_PLATFORM=offscreen");
  std::_Exit(1);
}

}  // namespace

extern "C" int leadline_console(const ConsoleRequest& request) {
  listener = &request;
  qInstallMessageHandler(hear_qt);
  static int argc = 1;
  static char name[] = "leadline";
  static char* argv[] = {name, nullptr};
  // Only the platform plugins of the Qt that this was built with.
  qunsetenv("QT_PLUGIN_PATH");
  QCoreApplication::setOrganizationName("leadline");
  QCoreApplication::setApplicationName("leadline");
  // Never deleted: the platform plugins of Qt 5 lose memory then that they free at no other time either.
  static auto* const application = new QApplication(argc, argv);
  const bool picture = !request.screenshot.empty();
  std::string palette = request.palette;
  if (palette.empty() && !picture) palette = QSettings().value("palette").toString().toStdString();
  ui::Look::current().set(palette_named(palette));

  Console console(request);
  if (request.live != nullptr) console.open_live(*request.live);
  if (!request.session.empty()) {
    if (const auto opened = console.open(request.session); !opened) {
      request.say(opened.error().line());
      return 1;
    }
  }
  int status = 0;
  if (picture) {
    const auto made = console.picture(request.screenshot);
    if (!made) request.say(made.error().line());
    status = made ? 0 : 1;
  } else {
    console.run();
    status = application->exec();
  }
  if (const auto ended = console.close_live(); !ended) {
    request.say(ended.error().line());
    status = 1;
  }
  return status;
}

}  // namespace leadline::app
