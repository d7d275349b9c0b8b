#include "ui/chart/motion_lines.h"

#include <gtest/gtest.h>

#include "tests/unit/ui/chart/drawn.h"

namespace leadline::ui {
namespace {

using test::at_deg;

geo::NorthEast velocity(double speed_mps, double course_deg) {
  const double a = course_deg * kRadPerDeg;
  return {speed_mps * std::cos(a), speed_mps * std::sin(a)};
}

// Heading 071.9, course over ground 078.9: set 7 deg to starboard. Both read off the picture.
void expect_crab(const ChartView& view, Geodetic at, double crab_deg) {
  const Colours day(Palette::day);
  const QPointF place = view.to_screen(at);
  const QLineF heading = heading_line(place, view.screen_angle_deg(Angle::deg(71.9), at), kVehicleTip_px,
                                      kVehicleHeadingLine_px);
  const auto vector = course_vector(view, at, velocity(1.42, 71.9 + crab_deg), 0.01, kVehicleVector_s);
  ASSERT_TRUE(vector.has_value());
  const auto read = [&](const auto& paint) {
    const QImage image = test::drawn(view.size(), day, Role::sea_deep, 1.0, paint);
    return test::furthest(image, place, day.of(Role::vehicle), 160);
  };
  const QLineF seen_heading = read([&](QPainter& p) { draw_heading_line(p, heading, Role::vehicle, day); });
  const QLineF seen_vector = read([&](QPainter& p) { draw_course_vector(p, *vector, Role::vehicle, day); });
  EXPECT_NEAR(seen_heading.length(), 58.0, 1.5);
  EXPECT_NEAR(seen_vector.length(), 1.42 * 60.0 / view.metres_per_px(), 1.5);
  EXPECT_NEAR(test::turn_deg(test::screen_bearing_deg(seen_heading), test::screen_bearing_deg(seen_vector)),
              crab_deg, 1.2);
}

TEST(MotionLines, CourseAndHeadingDifferByTheCrabAngleOnItsSide) {
  for (const double crab : {7.0, -7.0, 25.0}) {
    const Geodetic at = at_deg(36.91, 129.905);
    expect_crab(ChartView(at, {400, 400}, 0.6), at, crab);
    expect_crab(ChartView(at, {400, 400}, 0.6, Angle::deg(90.0)), at, crab);
    const ChartView polar(at_deg(89.0, 0.0), {400, 400}, 0.6);
    expect_crab(polar, polar.to_geodetic({230.0, 150.0}), crab);
    // Half a degree of latitude from the origin of the projection the north of a place is another one.
    ChartView far(at_deg(89.0, 0.0), {400, 400}, 0.6);
    far.pan({40'000, 0});
    expect_crab(far, far.to_geodetic({200.0, 200.0}), crab);
  }
}

TEST(MotionLines, NoVectorThatIsShortOrLostInItsSigma) {
  const Geodetic at = at_deg(36.91, 129.905);
  const ChartView view(at, {400, 400}, 1.0);
  EXPECT_FALSE(course_vector(view, at, velocity(7.9 / 60.0, 10.0), 0.001, 60.0));
  EXPECT_TRUE(course_vector(view, at, velocity(8.1 / 60.0, 10.0), 0.001, 60.0));
  EXPECT_FALSE(course_vector(view, at, velocity(1.0, 10.0), 0.34, 60.0));
  EXPECT_TRUE(course_vector(view, at, velocity(1.0, 10.0), 0.33, 60.0));
  EXPECT_FALSE(course_vector(view, at, velocity(1.0, 10.0), std::nan(""), 60.0));
}

TEST(MotionLines, AHeadingLineMayRunToTheEdge) {
  const QRectF chart(0, 0, 800, 600);
  const QLineF east = heading_line_to_edge({400, 300}, 90.0, 13.0, chart);
  EXPECT_NEAR(east.x1(), 413.0, 1e-9);
  EXPECT_NEAR(east.x2(), 800.0, 1e-9);
  const QLineF south_west = heading_line_to_edge({400, 300}, 225.0, 13.0, chart);
  EXPECT_NEAR(south_west.x2(), 100.0, 1e-6);
  EXPECT_NEAR(south_west.y2(), 600.0, 1e-6);
  EXPECT_TRUE(heading_line_to_edge({900, 300}, 90.0, 13.0, chart).isNull());
  EXPECT_NEAR(heading_line_to_edge({900, 300}, 270.0, 13.0, chart).x2(), 0.0, 1e-6);
}

}  // namespace
}  // namespace leadline::ui
