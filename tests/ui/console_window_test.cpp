// The console as a window: places, names, keys.

#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QAction>
#include <QKeyEvent>
#include <set>

#include "tests/ui/shown.h"
#include "ui/panels/replay_bar.h"

namespace leadline::ui {
namespace {

class ConsoleWindowTest : public testing::Test {
 protected:
  void show(QSize size, bool replay) {
    Look::current().set(Palette::day);
    made_.snapshot.replay = replay;
    window_.resize(size);
    window_.set_history(&made_.history, 0);
    window_.show_snapshot(made_.snapshot);
    window_.show();
    QApplication::processEvents();
  }
  void key(int key, Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
    for (QAction* action : window_.actions())
      for (const QKeySequence& sequence : action->shortcuts())
        if (sequence == QKeySequence(key | static_cast<int>(modifiers))) return action->trigger();
    ADD_FAILURE() << "no action has key " << key;
  }
  /// The window's visible children that paint something of their own.
  std::vector<QWidget*> parts() {
    std::vector<QWidget*> found;
    for (QObject* child : window_.children())
      if (auto* widget = qobject_cast<QWidget*>(child);
          widget != nullptr && widget->isVisible() && widget->objectName() != "focusRing")
        found.push_back(widget);
    return found;
  }

  test::HandMade made_ = test::hand_made(test::kEastSea);
  ConsoleWindow window_;
};

TEST_F(ConsoleWindowTest, NothingOverlapsAtAnySize) {
  for (const bool replay : {false, true})
    for (const QSize size : {QSize(800, 600), QSize(1024, 768), QSize(1280, 800), QSize(1600, 900),
                             QSize(1920, 1080), QSize(3840, 2160)}) {
      show(size, replay);
      const auto found = parts();
      EXPECT_GE(found.size(), 4U);
      for (QWidget* a : found) {
        EXPECT_TRUE(window_.rect().contains(a->geometry()))
            << a->objectName().toStdString() << " at " << size.width();
        EXPECT_FALSE(a->geometry().isEmpty()) << a->objectName().toStdString();
        for (QWidget* b : found) {
          if (a == b) continue;
          EXPECT_FALSE(a->geometry().intersects(b->geometry()))
              << a->objectName().toStdString() << " over " << b->objectName().toStdString() << " at "
              << size.width();
        }
      }
      EXPECT_GE(window_.chart().width(), size.width() / 2);
      EXPECT_GE(window_.chart().height(), size.height() * 2 / 5);
    }
}

TEST_F(ConsoleWindowTest, EveryWidgetThatActsHasItsNamesAndIsReachedByKeyboard) {
  show({1920, 1080}, true);
  std::set<QWidget*> reached;
  for (QWidget* at = window_.nextInFocusChain(); at != &window_ && reached.insert(at).second;
       at = at->nextInFocusChain()) {
  }
  int acting = 0;
  for (QWidget* widget : window_.findChildren<QWidget*>()) {
    if (!widget->isVisible()) continue;
    const bool acts =
        qobject_cast<QAbstractButton*>(widget) != nullptr || widget->focusPolicy() != Qt::NoFocus;
    if (!acts) continue;
    ++acting;
    EXPECT_FALSE(widget->objectName().isEmpty()) << widget->metaObject()->className();
    EXPECT_FALSE(widget->accessibleName().isEmpty()) << widget->objectName().toStdString();
    EXPECT_TRUE(widget->focusPolicy() & Qt::TabFocus) << widget->objectName().toStdString();
    EXPECT_TRUE(reached.count(widget)) << widget->objectName().toStdString();
  }
  EXPECT_GE(acting, 20);
  for (QAction* action : window_.actions()) {
    EXPECT_FALSE(action->objectName().isEmpty());
    EXPECT_FALSE(action->text().isEmpty());
    EXPECT_FALSE(action->shortcuts().isEmpty()) << action->objectName().toStdString();
  }
}

TEST_F(ConsoleWindowTest, TheKeysDoWhatTheySay) {
  show({1280, 800}, true);
  ChartCanvas& chart = window_.chart();
  const double scale = chart.view().metres_per_px();
  key(Qt::Key_Plus);
  EXPECT_LT(chart.view().metres_per_px(), scale);
  key(Qt::Key_Minus);
  EXPECT_NEAR(chart.view().metres_per_px(), scale, 1e-9);
  key(Qt::Key_F2);
  EXPECT_EQ(chart.follow(), Body::vehicle);
  EXPECT_NEAR(geo::geodesic(chart.view().centre(), test::kEastSea).distance_m, 0.0,
              2.0 * chart.view().metres_per_px());
  key(Qt::Key_F2);
  EXPECT_EQ(chart.follow(), Body::ship);
  key(Qt::Key_F2);
  EXPECT_EQ(chart.follow(), std::nullopt);
  key(Qt::Key_H);
  EXPECT_EQ(chart.orientation(), Orientation::head_up);
  key(Qt::Key_N);
  EXPECT_EQ(chart.orientation(), Orientation::north_up);
  key(Qt::Key_M);
  EXPECT_EQ(chart.tool(), Tool::measure);
  key(Qt::Key_Escape);
  EXPECT_EQ(chart.tool(), Tool::select);
  int played = 0, stepped = 0, palettes = 0;
  QObject::connect(&window_.replay_bar(), &ReplayBar::playToggled, [&] { ++played; });
  QObject::connect(&window_.replay_bar(), &ReplayBar::stepped, [&](int direction) { stepped += direction; });
  QObject::connect(&window_, &ConsoleWindow::paletteStepped, [&] { ++palettes; });
  key(Qt::Key_Space);
  key(Qt::Key_Right);
  key(Qt::Key_Right);
  key(Qt::Key_Left);
  key(Qt::Key_F5);
  EXPECT_EQ(played, 1);
  EXPECT_EQ(stepped, 1);
  EXPECT_EQ(palettes, 1);
}

TEST_F(ConsoleWindowTest, WiderFiguresMoveNothing) {
  show({1920, 1080}, false);
  std::vector<QRect> before;
  for (QWidget* part : window_.findChildren<QWidget*>()) before.push_back(part->geometry());
  Solution& s = made_.snapshot.vehicle->solution;
  s.position = {Angle::deg(-89.999999), Angle::deg(-179.999999)};
  s.depth = Depth{10'999.9};
  s.heading = Angle::deg(359.94);
  s.roll = Angle::deg(-179.9);
  s.pitch = Angle::deg(-89.9);
  s.vel_north_mps = -99.99;
  made_.snapshot.dive = std::string(200, 'W');
  made_.snapshot.availability.reason = std::string(90, 'M');
  window_.show_snapshot(made_.snapshot);
  QApplication::processEvents();
  std::size_t i = 0;
  for (QWidget* part : window_.findChildren<QWidget*>())
    EXPECT_EQ(part->geometry(), before[i++]) << part->objectName().toStdString();
}

TEST_F(ConsoleWindowTest, MovingTheMouseTellsThePlaceUnderIt) {
  show({1280, 800}, false);
  ChartCanvas& chart = window_.chart();
  std::optional<Geodetic> told;
  QObject::connect(&chart, &ChartCanvas::cursorMoved, [&](std::optional<Geodetic> place) { told = place; });
  const QPointF at(200, 150);
  QMouseEvent move(QEvent::MouseMove, at, Qt::NoButton, Qt::NoButton, Qt::NoModifier);
  QApplication::sendEvent(&chart, &move);
  ASSERT_TRUE(told);
  EXPECT_LT(geo::geodesic(*told, chart.view().to_geodetic(at)).distance_m, 0.01);
}

}  // namespace
}  // namespace leadline::ui
