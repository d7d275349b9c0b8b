// Controls by mouse and keyboard.

#include <gtest/gtest.h>

#include <QApplication>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QWheelEvent>
#include <cmath>

#include "tests/unit/ui/widgets/sample_texts.h"
#include "ui/look/look.h"
#include "ui/widgets/button.h"
#include "ui/widgets/clock_text.h"
#include "ui/widgets/segmented.h"
#include "ui/widgets/table.h"
#include "ui/widgets/timeline.h"
#include "ui/widgets/timeline_painter.h"
#include "ui/widgets/tool_button.h"

namespace leadline::ui {
namespace {

void press_key(QWidget& widget, int key, Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
  QKeyEvent press(QEvent::KeyPress, key, modifiers);
  QApplication::sendEvent(&widget, &press);
}

void mouse(QWidget& widget, QEvent::Type type, QPointF at) {
  QMouseEvent event(type, at, Qt::LeftButton,
                    type == QEvent::MouseButtonRelease ? Qt::NoButton : Qt::LeftButton, Qt::NoModifier);
  QApplication::sendEvent(&widget, &event);
}

struct TimelineTest : testing::Test {
  TimelineTest() {
    Look::current().set(Palette::day);
    line.resize(1032, kTimelineHeight);  // 1000 px of time
    line.set_data(data);
    line.set_now(test::at(14, 0));
    QObject::connect(&line, &Timeline::sought, &line, [this](Time t) { sought.push_back(t); });
  }
  TimelineData data = test::timeline();
  Timeline line;
  std::vector<Time> sought;
};

TEST_F(TimelineTest, ShowsTheWholeRunUntilItIsZoomed) {
  EXPECT_EQ(line.span(), data.run);
  data.run.until = test::at(16, 0);
  line.set_data(data);
  EXPECT_EQ(line.span(), data.run);
  const TimeSpan hour{test::at(13, 0), test::at(14, 0)};
  line.set_span(hour);
  data.run.until = test::at(17, 0);
  line.set_data(data);
  EXPECT_EQ(line.span(), hour);
}

TEST_F(TimelineTest, PressAndDragSeekWhereThePointerIs) {
  mouse(line, QEvent::MouseButtonPress, {16 + 500, 40});
  mouse(line, QEvent::MouseMove, {16 + 750, 40});
  mouse(line, QEvent::MouseMove, {5000, 40});
  mouse(line, QEvent::MouseButtonRelease, {5000, 40});
  ASSERT_EQ(sought.size(), 3u);
  const double run_s = seconds(data.run.until - data.run.from);
  EXPECT_NEAR(seconds(sought[0] - data.run.from), 0.50 * run_s, 1.0);
  EXPECT_NEAR(seconds(sought[1] - data.run.from), 0.75 * run_s, 1.0);
  EXPECT_EQ(sought[2], data.run.until);
  mouse(line, QEvent::MouseMove, {16 + 100, 40});
  EXPECT_EQ(sought.size(), 3u) << "released";
}

TEST_F(TimelineTest, KeysMoveByASecondTenAMinuteATenthAndToTheEnds) {
  using std::chrono::seconds;
  press_key(line, Qt::Key_Right);
  press_key(line, Qt::Key_Left, Qt::ShiftModifier);
  press_key(line, Qt::Key_Right, Qt::ControlModifier);
  press_key(line, Qt::Key_PageUp);
  press_key(line, Qt::Key_Home);
  press_key(line, Qt::Key_Left);
  press_key(line, Qt::Key_End);
  ASSERT_EQ(sought.size(), 7u);
  EXPECT_EQ(sought[0], test::at(14, 0, 1));
  EXPECT_EQ(sought[1], test::at(13, 59, 51));
  EXPECT_EQ(sought[2], test::at(14, 0, 51));
  EXPECT_EQ(sought[3], test::at(13, 35, 51));
  EXPECT_EQ(sought[4], data.run.from);
  EXPECT_EQ(sought[5], data.run.from) << "never before the run";
  EXPECT_EQ(sought[6], data.run.until);
}

TEST_F(TimelineTest, TheWheelZoomsAboutThePointerAndNeverBelowTenSeconds) {
  const Time under = TimeScale(line.span(), line.rect()).at(400);
  const auto roll = [&](int delta) {
    QWheelEvent wheel({400, 40}, {400, 40}, {}, {0, delta}, Qt::NoButton, Qt::NoModifier, Qt::NoScrollPhase,
                      false);
    QApplication::sendEvent(&line, &wheel);
  };
  roll(120);
  EXPECT_LT(seconds(line.span().until - line.span().from), 0.81 * seconds(data.run.until - data.run.from));
  EXPECT_NEAR(TimeScale(line.span(), line.rect()).x(under), 400, 0.5);
  for (int i = 0; i < 80; ++i) roll(120);
  EXPECT_NEAR(seconds(line.span().until - line.span().from), 10.0, 1e-6);
  for (int i = 0; i < 80; ++i) roll(-120);
  EXPECT_EQ(line.span(), data.run);
}

TEST_F(TimelineTest, ThePlayHeadStandsAtItsTimeAndNothingElseMoves) {
  const QImage before = line.grab().toImage();
  line.set_now(test::at(12, 30));
  const QImage after = line.grab().toImage();
  const TimeScale scale(line.span(), line.rect());
  const QColor ink = Look::current().colours().of(Role::text);
  const int x = static_cast<int>(std::round(scale.x(test::at(12, 30))));
  EXPECT_EQ(after.pixelColor(x, 60).name(), ink.name());
  EXPECT_NE(before.pixelColor(x, 60).name(), ink.name());
  const int old = static_cast<int>(std::round(scale.x(test::at(14, 0))));
  for (int y = 0; y < after.height(); ++y)
    for (int px = 0; px < after.width(); ++px) {
      if (std::abs(px - x) < 10 || std::abs(px - old) < 10) continue;
      ASSERT_EQ(before.pixel(px, y), after.pixel(px, y)) << px << "," << y;
    }
}

TEST_F(TimelineTest, DegradedTimesAreMarkedInTheBand) {
  const QImage picture = line.grab().toImage();
  const TimeScale scale(line.span(), line.rect());
  const Colours& colours = Look::current().colours();
  const auto pixel = [&](Time t, int y) {
    return picture.pixelColor(static_cast<int>(scale.x(t)), y).name();
  };
  EXPECT_EQ(pixel(test::at(11, 30), 47), colours.of(Role::caution_icon).name());
  EXPECT_EQ(pixel(test::at(12, 58), 35), colours.of(Role::warning).name());
  EXPECT_NE(pixel(test::at(12, 30), 47), colours.of(Role::caution_icon).name());
}

TEST_F(TimelineTest, AnEmptyRunDrawsAndSeeksNothingOdd) {
  Timeline empty;
  empty.resize(400, kTimelineHeight);
  press_key(empty, Qt::Key_Right);
  mouse(empty, QEvent::MouseButtonPress, {200, 40});
  EXPECT_FALSE(empty.grab().isNull());
}

TEST(Controls, ASegmentIsChosenByMouseAndKeysAndToldOnce) {
  Segmented speeds("speed", QStringLiteral("Speed"),
                   {QStringLiteral("1×"), QStringLiteral("4×"), QStringLiteral("max")});
  speeds.resize(speeds.sizeHint());
  std::vector<int> chosen;
  QObject::connect(&speeds, &Segmented::chosen, &speeds, [&](int i) { chosen.push_back(i); });
  speeds.set_current(0);
  EXPECT_TRUE(chosen.empty());
  press_key(speeds, Qt::Key_Right);
  press_key(speeds, Qt::Key_End);
  press_key(speeds, Qt::Key_Right);
  mouse(speeds, QEvent::MouseButtonPress, {5, 10});
  mouse(speeds, QEvent::MouseButtonPress, {5, 10});
  EXPECT_EQ(chosen, (std::vector<int>{1, 2, 0}));
  EXPECT_EQ(speeds.accessibleName(), QStringLiteral("Speed, 1×"));
}

TEST(Controls, AButtonKeepsItsNameWhenItsWordsFoldAway) {
  Button button("silence", QStringLiteral("speaker-off"), QStringLiteral("Silence 30 s"),
                QStringLiteral("Silence  (Ctrl+S)"));
  const int wide = button.sizeHint().width();
  button.set_icon_only(true);
  EXPECT_LT(button.sizeHint().width(), wide);
  EXPECT_GE(button.sizeHint().width(), 28);
  EXPECT_EQ(button.accessibleName(), QStringLiteral("Silence 30 s"));
}

TEST(Controls, AToolInHandIsFilledAndBarred) {
  Look::current().set(Palette::day);
  ToolButton tool("toolPan", QStringLiteral("pan"), QStringLiteral("Pan"), QStringLiteral("P"));
  tool.setCheckable(true);
  tool.resize(tool.sizeHint());
  EXPECT_EQ(tool.size(), QSize(40, 40));
  EXPECT_EQ(tool.toolTip(), QStringLiteral("Pan  (P)"));
  tool.setChecked(true);
  const QImage held = tool.grab().toImage();
  EXPECT_EQ(held.pixelColor(1, 20).name(), Look::current().colours().of(Role::text).name());
  EXPECT_EQ(held.pixelColor(36, 20).name(), Look::current().colours().of(Role::select).name());
}

TEST(Controls, TablesSayTheirRowsAndGrowByThem) {
  SourcesTable sources;
  sources.set(test::sources().rows);
  EXPECT_EQ(sources.sizeHint().height(), 7 * kTableRow);
  EXPECT_TRUE(sources.accessibleDescription().contains(QStringLiteral("GNSS ship stale, age 14 s")));
  RangeBearingTable ranges;
  ranges.set(test::ranges().rows);
  EXPECT_TRUE(
      ranges.accessibleDescription().startsWith(QStringLiteral("Ship to MDV-1: 420 m, bearing 308.0° T")));
}

TEST(ClockText, CutsAsAClockDoes) {
  const Time t = *from_civil({2026, 9, 14, 14, 2, 37, 290'000'000});
  EXPECT_EQ(clock_text(t).toStdString(), "14:02:37 Z");
  EXPECT_EQ(clock_text(t, 1).toStdString(), "14:02:37.2 Z");
  EXPECT_EQ(clock_text(t, 3).toStdString(), "14:02:37.290 Z");
  EXPECT_EQ(hour_text(t).toStdString(), "14:02 Z");
  EXPECT_EQ(duration_words(std::chrono::minutes(161)).toStdString(), "2 h 41 min");
  EXPECT_EQ(duration_words(std::chrono::seconds(252)).toStdString(), "4 min 12 s");
}

}  // namespace
}  // namespace leadline::ui
