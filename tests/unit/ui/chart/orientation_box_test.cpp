#include "ui/chart/orientation_box.h"

#include <gtest/gtest.h>

#include "tests/unit/ui/chart/drawn.h"

namespace leadline::ui {
namespace {

using test::at_deg;

// Where the filled half of the arrow has its middle, as seen from the arrow's: to its right.
double right_half_deg(const ChartView& view) {
  const Colours day(Palette::day);
  QRectF box;
  const QImage image = test::drawn(view.size(), day, Role::sea_deep, 1.0,
                                   [&](QPainter& p) { box = draw_orientation_box(p, view, {}, day); });
  // The ink within the left part, except the upright N on the tail side.
  const double north = view.screen_angle_deg(Angle(), view.centre()) * kRadPerDeg;
  const QPointF way(std::sin(north), -std::cos(north)), middle = box.topLeft() + QPointF(33, 35) + way * 7.0;
  QPointF sum;
  int count = 0;
  for (int y = static_cast<int>(box.top()); y < box.bottom(); ++y) {
    for (int x = static_cast<int>(box.left()); x < box.left() + 66; ++x) {
      const QPointF off = QPointF(x + 0.5, y + 0.5) - middle;
      const double along = off.x() * way.x() + off.y() * way.y();
      if (std::abs(along) > 16.0 || !test::is(image, {x, y}, day.of(Role::ink), 90)) continue;
      sum += off - way * along;
      ++count;
    }
  }
  EXPECT_GT(count, 60);
  return test::screen_bearing_deg(QLineF(QPointF(), sum));
}

TEST(OrientationBox, TheArrowPointsToTrueNorthAtTheViewsCentre) {
  const Geodetic sea = at_deg(36.91, 129.905);
  for (const double up : {0.0, 90.0, 217.0, 300.0}) {
    const ChartView view(sea, {800, 600}, 1.0, Angle::deg(up));
    EXPECT_NEAR(test::turn_deg(right_half_deg(view), -up + 90.0), 0.0, 4.0) << up;
  }
  ChartView polar(at_deg(89.0, 0.0), {800, 600}, 1.0);
  polar.pan({-40'000, 0});  // 40 km east of the projection's origin north has turned
  const double north =
      test::screen_bearing_deg(QLineF(polar.to_screen(polar.centre()), polar.to_screen(at_deg(90.0, 0.0))));
  EXPECT_LT(test::turn_deg(0.0, north), -10.0);
  EXPECT_NEAR(test::turn_deg(right_half_deg(polar), north + 90.0), 0.0, 4.0);
}

TEST(OrientationBox, ItStaysOnTheSmallestChart) {
  const ChartView view(at_deg(36.91, 129.905), {300, 200}, 1.0);
  const QRectF box = orientation_box(view, {Orientation::course_up, Motion::relative,
                                            QStringLiteral("a vessel with a very long name indeed")});
  EXPECT_TRUE(QRectF(0, 0, 300, 200).contains(box));
  EXPECT_DOUBLE_EQ(box.right(), 288.0);
}

}  // namespace
}  // namespace leadline::ui
