// The panels together, at one moment of one dive.

#include <gtest/gtest.h>

#include <QApplication>
#include <QElapsedTimer>
#include <QImage>
#include <QKeyEvent>
#include <QPainter>
#include <cmath>
#include <limits>

#include "tests/support/picture.h"
#include "tests/unit/ui/widgets/sample_texts.h"
#include "ui/look/look.h"
#include "ui/panels/alert_bar.h"
#include "ui/panels/own_data_panel.h"
#include "ui/panels/rail.h"
#include "ui/panels/replay_bar.h"
#include "ui/panels/status_bar.h"
#include "ui/panels/table_panels.h"
#include "ui/panels/top_bar.h"
#include "ui/widgets/button.h"
#include "ui/widgets/tile_strip.h"
#include "ui/widgets/value_tile.h"

namespace leadline::ui {
namespace {

/// All panels where a window would put them, the chart left out.
class Console final : public QWidget {
 public:
  explicit Console(bool replay, QSize size = {1920, 1080}, Fold fold = Fold::wide) {
    resize(size);
    setAutoFillBackground(true);
    top = new TopBar(this);
    alerts = new AlertBar(this);
    rail = new Rail(this);
    vehicle = new OwnDataPanel(OwnDataPanel::Kind::vehicle, {}, this);
    ship = new OwnDataPanel(OwnDataPanel::Kind::ship, {true, false, false}, this);
    ranges = new RangePanel(this);
    sources = new SourcesPanel(this);
    bar = new ReplayBar(this);
    status = new StatusBar(this);
    for (Button* b : findChildren<Button*>()) buttons.push_back(b);
    top->set_fold(fold);
    alerts->set_fold(fold);
    alerts->freeze();
    rail->set_fold(fold);
    vehicle->set_fold(fold);
    ship->set_fold(fold);
    bar->set_fold(fold);
    status->set_fold(fold);
    top->set(test::top_bar(replay ? Operation::replay : Operation::live));
    alerts->set(test::alert_bar(Alarm::Priority::warning, replay));
    vehicle->set(test::vehicle(replay));
    ship->set(test::ship(replay));
    ranges->set(test::ranges());
    sources->set(test::sources(replay));
    status->set(test::status_bar(replay));
    bar->set_data(test::timeline());
    bar->set_now(test::at(14, 2, 37));
    bar->set_speed(4);
    bar->set_playing(true);
    bar->set_loop(TimeSpan{test::at(13, 49, 37), test::at(14, 11, 37)});
    place();
    show();
    activateWindow();
    QApplication::processEvents();
  }

  void place() {
    const int w = width(), h = height();
    top->setGeometry(0, 0, w, top->sizeHint().height());
    int y = top->height();
    alerts->setGeometry(0, y, w, alerts->sizeHint().height());
    y += alerts->height();
    status->setGeometry(0, h - status->sizeHint().height(), w, status->sizeHint().height());
    rail->setGeometry(0, y, rail->sizeHint().width(), status->y() - y);
    const int side = w >= 1600 ? 408 : 332;
    bar->setGeometry(rail->width(), status->y() - 132, w - rail->width() - side - 10, 132);
    y += 5;
    for (QWidget* panel : std::initializer_list<QWidget*>{vehicle, ship, ranges, sources}) {
      panel->setGeometry(w - side - 5, y, side, panel->sizeHint().height());
      y += panel->height() + 5;
    }
  }
  [[nodiscard]] QImage picture() {
    if (QWidget* w = QApplication::focusWidget()) w->clearFocus();
    QApplication::processEvents();
    return grab().toImage().convertToFormat(QImage::Format_RGB32);
  }

  TopBar* top;
  AlertBar* alerts;
  Rail* rail;
  OwnDataPanel *vehicle, *ship;
  RangePanel* ranges;
  SourcesPanel* sources;
  ReplayBar* bar;
  StatusBar* status;
  std::vector<Button*> buttons;

 protected:
  void paintEvent(QPaintEvent* /*event*/) override {
    QPainter(this).fillRect(rect(), Look::current().colours().of(Role::bg_window));
  }
};

struct Panels : testing::Test {
  Panels() { Look::current().set(Palette::day); }
};

TEST_F(Panels, LookAsTheyDidWhenLookedAt) {
  const char* const names[]{"day", "dusk", "night"};
  for (const Palette palette : {Palette::day, Palette::dusk, Palette::night}) {
    Look::current().set(palette);
    const std::string name = names[static_cast<int>(palette)];
    leadline::test::expect_picture(Console(false).picture(), "panels_live_" + name);
    leadline::test::expect_picture(Console(true).picture(), "panels_replay_" + name);
  }
  Look::current().set(Palette::day);
  leadline::test::expect_picture(Console(true, {1280, 800}, Fold::compact).picture(), "panels_1280_day");
}

TEST_F(Panels, FoldAsTheSmallestWindowWantsThem) {
  QImage sheet(800, 5 * 48 + 60, QImage::Format_RGB32);
  sheet.fill(Look::current().colours().of(Role::bg_window));
  TopBar top;
  top.set_fold(Fold::small);
  top.set(test::top_bar(Operation::replay));
  AlertBar alerts;
  alerts.freeze();
  alerts.set_fold(Fold::small);
  alerts.set(test::alert_bar());
  TileStrip strip;
  strip.set(test::vehicle(true));
  StatusBar status;
  status.set_fold(Fold::small);
  status.set(test::status_bar());
  EXPECT_EQ(top.height(), 40);
  EXPECT_EQ(alerts.height(), 36);
  EXPECT_EQ(strip.height(), 56);
  EXPECT_EQ(status.height(), 22);
  int y = 0;
  for (QWidget* w : std::initializer_list<QWidget*>{&top, &alerts, &strip, &status}) {
    w->resize(800, w->height());
    w->render(&sheet, QPoint(0, y));
    y += w->height() + 4;
  }
  for (const Alarm::Priority priority :
       {Alarm::Priority::caution, Alarm::Priority::alarm, Alarm::Priority::emergency}) {
    AlertBar bar;
    bar.freeze();
    bar.resize(800, 40);
    bar.set(test::alert_bar(priority));
    bar.render(&sheet, QPoint(0, y));
    y += 44;
  }
  leadline::test::expect_picture(sheet, "panels_800_day");
}

TEST_F(Panels, AtNightNothingIsBrightAndTheMeanIsLow) {
  Look::current().set(Palette::night);
  for (const bool replay : {false, true}) {
    const QImage picture = Console(replay).picture();
    const auto linear = [](int v) {
      const double c = v / 255.0;
      return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
    };
    double greatest = 0, sum = 0;
    for (int y = 0; y < picture.height(); ++y)
      for (int x = 0; x < picture.width(); ++x) {
        const QRgb p = picture.pixel(x, y);
        const double light =
            0.2126 * linear(qRed(p)) + 0.7152 * linear(qGreen(p)) + 0.0722 * linear(qBlue(p));
        greatest = std::max(greatest, light);
        sum += light;
      }
    const double mean = sum / (picture.width() * picture.height());
    std::cout << "night" << (replay ? ", replay" : "") << ": greatest " << greatest << ", mean " << mean
              << "\n";
    EXPECT_LE(greatest, 0.305);
    EXPECT_LE(mean, 0.020);
  }
}

TEST_F(Panels, EveryFocusableWidgetHasANameAndShowsItsRing) {
  Console console(false);
  const QColor focus = Look::current().colours().of(Role::focus);
  int ringed = 0;
  std::vector<QWidget*> focusable;  // first, as the ring itself comes and goes
  for (QWidget* w : console.findChildren<QWidget*>())
    if (w->focusPolicy() != Qt::NoFocus && w->isVisible() && w->isEnabled()) focusable.push_back(w);
  for (QWidget* w : focusable) {
    EXPECT_FALSE(w->objectName().isEmpty()) << w->metaObject()->className();
    EXPECT_FALSE(w->accessibleName().isEmpty()) << w->objectName().toStdString();
    w->setFocus();
    QApplication::processEvents();
    const QImage picture = console.grab().toImage();
    const QRect r(w->mapTo(&console, QPoint()), w->size());
    int seen = 0;
    for (const QPoint at : {QPoint(r.center().x(), r.top() - 3), QPoint(r.center().x(), r.bottom() + 3),
                            QPoint(r.left() - 3, r.center().y()), QPoint(r.right() + 3, r.center().y())})
      seen += picture.rect().contains(at) && picture.pixelColor(at).name() == focus.name();
    EXPECT_GE(seen, 3) << w->objectName().toStdString();
    ++ringed;
  }
  EXPECT_GE(ringed, 20);
}

TEST_F(Panels, EveryButtonNamesItsKeyAndIsLargeEnoughToHit) {
  Console console(false);
  for (QAbstractButton* b : console.findChildren<QAbstractButton*>()) {
    EXPECT_TRUE(b->toolTip().contains(QLatin1Char('('))) << b->objectName().toStdString();
    EXPECT_GE(b->width(), 28) << b->objectName().toStdString();
    EXPECT_GE(b->height(), 28) << b->objectName().toStdString();
  }
}

TEST_F(Panels, TheWidestTextsMoveNothing) {
  Console console(false);
  const auto places = [&] {
    std::vector<std::pair<QWidget*, QRect>> found;
    for (QWidget* w : console.findChildren<QWidget*>()) found.emplace_back(w, w->geometry());
    return found;
  };
  const auto before = places();
  TopBarText top = test::top_bar(Operation::live);
  top.dive = std::string(200, 'W');
  top.file = std::string(200, 'W');
  top.mode = Mode::E0;
  top.mode_words = "nothing, the last position is held since a very long time";
  console.top->set(top);
  AlertBarText alert = test::alert_bar();
  alert.alert->text = std::string(200, 'W');
  alert.alert->cause = std::string(200, 'W');
  alert.counts = {12345, 12345, 12345};
  console.alerts->set(alert);
  OwnDataText own = test::vehicle();
  for (auto* t : {&own.position, &own.heading, &own.speed, &own.depth, &own.altitude, &own.roll, &own.pitch,
                  &own.current}) {
    (*t)->value = "−99999.99";
    (*t)->sigma = "99999.9 m";
    (*t)->source = "a source with a very long name";
    (*t)->state = ValueState::stale;
    (*t)->age = "99:59:59";
  }
  console.vehicle->set(own);
  SourcesText sources = test::sources();
  for (auto& row : sources.rows) row.name = row.quality = row.rate = std::string(60, 'W');
  console.sources->set(sources);
  QApplication::processEvents();
  EXPECT_EQ(places(), before);
  for (Button* b : console.buttons) {
    if (b->parentWidget() == console.alerts) {
      EXPECT_GE(b->x(), 0);
    }
  }
}

TEST_F(Panels, AFigureWithoutFeedIsAbsentAndTheOthersStay) {
  Console console(false);
  const auto* depth = console.findChild<ValueTile*>(QStringLiteral("vehicleDepth"));
  const auto* altitude = console.findChild<ValueTile*>(QStringLiteral("vehicleAltitude"));
  const QRect before = altitude->geometry();
  OwnDataText own = test::vehicle();
  own.depth.reset();
  console.vehicle->set(own);
  QApplication::processEvents();
  EXPECT_FALSE(depth->text().has_value());
  EXPECT_EQ(altitude->geometry(), before);
  EXPECT_EQ(altitude->text()->value, "18.6");
}

TEST_F(Panels, APanelWithoutSubjectStaysAndSaysWhy) {
  Console console(false);
  const QRect before = console.vehicle->geometry();
  OwnDataText none;
  none.absent = "no vehicle in this file";
  console.vehicle->set(none);
  EXPECT_EQ(console.vehicle->geometry(), before);
  EXPECT_EQ(console.vehicle->accessibleDescription(), QStringLiteral("no vehicle in this file"));
  EXPECT_FALSE(console.findChild<ValueTile*>(QStringLiteral("vehiclePosition"))->text().has_value());
}

TEST_F(Panels, OnlyALiveAlertCanBeAcknowledged) {
  AlertBar bar;
  const auto enabled = [&](const char* name) {
    return bar.findChild<Button*>(QString::fromLatin1(name))->isEnabled();
  };
  EXPECT_FALSE(enabled("acknowledge"));
  EXPECT_EQ(bar.accessibleName(), QStringLiteral("No alerts"));
  bar.set(test::alert_bar());
  EXPECT_TRUE(enabled("acknowledge") && enabled("silence"));
  bar.set(test::alert_bar(Alarm::Priority::caution));
  EXPECT_FALSE(enabled("acknowledge")) << "a caution needs none";
  bar.set(test::alert_bar(Alarm::Priority::alarm, true));
  EXPECT_FALSE(enabled("acknowledge") || enabled("silence"));
  EXPECT_TRUE(bar.accessibleName().startsWith(QStringLiteral("Recorded alarm: USBL")));
}

TEST_F(Panels, AnUnansweredAlertBlinksAndItsTextStandsStill) {
  AlertBar bar;
  bar.resize(1200, 40);
  bar.set(test::alert_bar(Alarm::Priority::alarm));
  bar.show();
  bar.activateWindow();
  QApplication::processEvents();  // the first button takes the keyboard, with its ring
  const QImage lit = bar.grab().toImage();
  QElapsedTimer waited;
  waited.start();
  QImage other = lit;
  while (other == lit && waited.elapsed() < 3000) {
    QApplication::processEvents(QEventLoop::WaitForMoreEvents | QEventLoop::AllEvents, 50);
    other = bar.grab().toImage();
  }
  ASSERT_NE(other, lit);
  for (int y = 0; y < lit.height(); ++y)
    for (int x = 144; x < lit.width(); ++x) ASSERT_EQ(lit.pixel(x, y), other.pixel(x, y)) << x << "," << y;
}

TEST_F(Panels, TheReplayBarSaysWhatTheOperatorWants) {
  ReplayBar bar;
  bar.resize(1300, 132);
  bar.set_data(test::timeline());
  bar.set_now(test::at(14, 0));
  int played = 0;
  std::vector<int> steps;
  std::vector<Time> sought;
  std::vector<double> speeds;
  std::vector<std::optional<TimeSpan>> loops;
  QObject::connect(&bar, &ReplayBar::playToggled, &bar, [&] { ++played; });
  QObject::connect(&bar, &ReplayBar::stepped, &bar, [&](int d) { steps.push_back(d); });
  QObject::connect(&bar, &ReplayBar::sought, &bar, [&](Time t) { sought.push_back(t); });
  QObject::connect(&bar, &ReplayBar::speedChosen, &bar, [&](double s) { speeds.push_back(s); });
  QObject::connect(&bar, &ReplayBar::loopSet, &bar, [&](std::optional<TimeSpan> l) { loops.push_back(l); });
  const auto click = [&](const char* name) { bar.findChild<Button*>(QString::fromLatin1(name))->click(); };
  click("play");
  click("stepBack");
  click("stepForward");
  EXPECT_EQ(played, 1);
  EXPECT_EQ(steps, (std::vector<int>{-1, 1}));
  click("nextEvent");
  click("nextEvent");
  click("previousEvent");
  EXPECT_EQ(sought, (std::vector<Time>{test::at(14, 2, 26), test::at(14, 17), test::at(14, 2, 26)}));
  auto* speed = bar.findChild<QWidget*>(QStringLiteral("speed"));
  bar.set_speed(60);
  EXPECT_TRUE(speeds.empty());
  QKeyEvent right(QEvent::KeyPress, Qt::Key_Right, Qt::NoModifier);
  QApplication::sendEvent(speed, &right);
  ASSERT_EQ(speeds.size(), 1u);
  EXPECT_TRUE(std::isinf(speeds[0]));
  click("loop");
  bar.set_now(test::at(13, 50));
  EXPECT_TRUE(loops.empty());
  click("loop");
  click("loop");
  ASSERT_EQ(loops.size(), 2u);
  EXPECT_EQ(loops[0], (TimeSpan{test::at(13, 50), test::at(14, 2, 26)}));
  EXPECT_EQ(loops[1], std::nullopt);
  EXPECT_EQ(bar.findChild<Button*>(QStringLiteral("play"))->accessibleName(), QStringLiteral("Play"));
  bar.set_playing(true);
  EXPECT_EQ(bar.findChild<Button*>(QStringLiteral("play"))->accessibleName(), QStringLiteral("Pause"));
}

TEST_F(Panels, TheRailAsksAndShowsOnlyWhatItIsTold) {
  Rail rail;
  rail.resize(52, 700);
  std::vector<Tool> tools;
  std::vector<int> zooms;
  int palettes = 0, follows = 0;
  QObject::connect(&rail, &Rail::toolChosen, &rail, [&](Tool t) { tools.push_back(t); });
  QObject::connect(&rail, &Rail::zoomed, &rail, [&](int d) { zooms.push_back(d); });
  QObject::connect(&rail, &Rail::paletteStepped, &rail, [&] { ++palettes; });
  QObject::connect(&rail, &Rail::followToggled, &rail, [&] { ++follows; });
  const auto button = [&](const char* name) {
    return rail.findChild<QAbstractButton*>(QString::fromLatin1(name));
  };
  button("toolMeasure")->click();
  EXPECT_FALSE(button("toolMeasure")->isChecked());
  EXPECT_TRUE(button("toolSelect")->isChecked());
  rail.set_tool(Tool::measure);
  EXPECT_TRUE(button("toolMeasure")->isChecked());
  EXPECT_FALSE(button("toolSelect")->isChecked());
  button("follow")->click();
  EXPECT_FALSE(button("follow")->isChecked());
  button("zoomIn")->click();
  button("zoomOut")->click();
  button("palette")->click();
  EXPECT_EQ(tools, (std::vector<Tool>{Tool::measure}));
  EXPECT_EQ(zooms, (std::vector<int>{1, -1}));
  EXPECT_EQ(palettes + follows, 2);
}

TEST_F(Panels, TheRailKeepsItsButtonsApartWhereHeightIsShort) {
  for (const bool links : {false, true})
    for (const int height : {446, 468, 560, 960}) {
      Rail rail;
      rail.resize(44, height);
      rail.set_links(links, false);
      rail.show();  // or it is not told its size
      auto buttons = rail.findChildren<QAbstractButton*>();
      if (!links) buttons.removeOne(rail.findChild<QAbstractButton*>(QStringLiteral("links")));
      for (const auto* a : buttons) {
        EXPECT_TRUE(rail.rect().contains(a->geometry())) << height << " " << a->objectName().toStdString();
        EXPECT_GE(a->height(), 28);
        for (const auto* b : buttons) EXPECT_TRUE(a == b || !a->geometry().intersects(b->geometry()));
      }
    }
}

}  // namespace
}  // namespace leadline::ui
