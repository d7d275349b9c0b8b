// Signs in pixels: a chart that turned a heading, swapped an ellipse's axes or put a course on the wrong side
// would be believed.

#include <gtest/gtest.h>

#include "tests/ui/shown.h"

namespace leadline::ui {
namespace {

constexpr double kScale_m_px = 1.0;
const QSize kSize(900, 700);
const QPointF kMiddle(450.0, 350.0);

/// How much of a role's colour lies round a place, 0..1: the best match within 2 px.
double likeness(const QImage& picture, QPointF at, Role role, Palette palette) {
  const QColor wanted = Colours(palette).of(role);
  double best = 0.0;
  for (int dy = -2; dy <= 2; ++dy)
    for (int dx = -2; dx <= 2; ++dx) {
      const QPoint p = at.toPoint() + QPoint(dx, dy);
      if (!picture.rect().contains(p)) continue;
      const QColor c = picture.pixelColor(p);
      const double apart = std::abs(c.red() - wanted.red()) + std::abs(c.green() - wanted.green()) +
                           std::abs(c.blue() - wanted.blue());
      best = std::max(best, 1.0 - apart / 160.0);
    }
  return best;
}

QPointF along(double bearing_deg, double px) {
  const double b = bearing_deg * kRadPerDeg;
  return kMiddle + QPointF(px * std::sin(b), -px * std::cos(b));
}

/// The bearing, of those looked at, along which a role's colour lies for the whole stretch.
std::vector<double> bearings_of(const QImage& picture, Role role, double from_px, double to_px,
                                double share) {
  std::vector<double> found;
  for (double bearing = 0.0; bearing < 360.0; bearing += 1.0) {
    int hit = 0, looked = 0;
    for (double px = from_px; px <= to_px; px += 2.0, ++looked) {
      const QPoint p = along(bearing, px).toPoint();
      const QColor c = picture.pixelColor(p), wanted = Colours(Palette::day).of(role);
      hit += std::abs(c.red() - wanted.red()) < 60 && std::abs(c.green() - wanted.green()) < 60 &&
             std::abs(c.blue() - wanted.blue()) < 60;
    }
    if (hit >= share * looked) found.push_back(bearing);
  }
  return found;
}

/// A moment with the vehicle and nothing else.
test::HandMade alone(double heading_deg, double course_deg, double speed_mps) {
  test::HandMade made = test::hand_made(test::kEastSea);
  made.history = {};
  made.snapshot.ship.reset();
  made.snapshot.targets.clear();
  made.snapshot.beam.reset();
  Solution& s = made.snapshot.vehicle->solution;
  s.heading = Angle::deg(heading_deg);
  s.vel_north_mps = speed_mps * cos(Angle::deg(course_deg));
  s.vel_east_mps = speed_mps * sin(Angle::deg(course_deg));
  s.var_north_m2 = s.var_east_m2 = 0.01;
  s.cov_north_east_m2 = 0.0;
  return made;
}

TEST(ChartSigns, TheHeadingLinePointsEastNorthEast) {
  const QImage picture =
      test::chart_picture(alone(test::kHeading_deg, 0.0, 0.0), kSize, kScale_m_px, Palette::day);
  const auto bearings = bearings_of(picture, Role::vehicle, 20.0, 54.0, 0.5);
  ASSERT_FALSE(bearings.empty());
  for (const double bearing : bearings) EXPECT_NEAR(bearing, test::kHeading_deg, 3.0);
}

TEST(ChartSigns, TheCourseVectorLiesToStarboardOfTheHeadingByTheCrab) {
  // Ten times the crab, so that the two lines stand apart.
  const QImage picture = test::chart_picture(alone(71.9, 71.9 + 30.0, 1.5), kSize, kScale_m_px, Palette::day);
  const auto bearings = bearings_of(picture, Role::vehicle, 30.0, 54.0, 0.45);
  bool heading = false, course = false;
  for (const double bearing : bearings) {
    heading |= std::abs(bearing - 71.9) < 3.0;
    course |= std::abs(bearing - 101.9) < 3.0;
    EXPECT_GT(bearing, 65.0) << "a line to port of the heading";
  }
  EXPECT_TRUE(heading);
  EXPECT_TRUE(course);
}

TEST(ChartSigns, TheEllipseLiesAlongThirtyDegrees) {
  test::HandMade made = alone(210.0, 0.0, 0.0);
  test::HandMade whole = test::hand_made(test::kEastSea);
  for (double Solution::*v : {&Solution::var_north_m2, &Solution::cov_north_east_m2, &Solution::var_east_m2})
    made.snapshot.vehicle->solution.*v = 16.0 * (whole.snapshot.vehicle->solution.*v);  // 120 m by 40 m
  const QImage picture = test::chart_picture(made, kSize, kScale_m_px, Palette::day);
  const QRgb sea = Colours(Palette::day).of(Role::sea_deep).rgb();
  const auto inside = [&](double bearing, double px) {
    // The graticule is lighter than a filled ellipse: look at a few neighbours.
    int tinted = 0;
    for (const double b : {bearing - 1.5, bearing, bearing + 1.5})
      tinted += qRed(picture.pixel(along(b, px).toPoint())) < qRed(sea) - 8;
    return tinted >= 2;
  };
  EXPECT_TRUE(inside(30.0, 105.0));
  EXPECT_TRUE(inside(30.0, 70.0));
  EXPECT_FALSE(inside(30.0, 135.0));
  EXPECT_FALSE(inside(330.0, 105.0)) << "mirrored";
  EXPECT_FALSE(inside(300.0, 70.0)) << "the axes are swapped";
  EXPECT_FALSE(inside(120.0, 70.0)) << "the axes are swapped";
  EXPECT_TRUE(inside(300.0, 30.0));
}

TEST(ChartSigns, RefusedFixesLookRefusedAndUsedOnesUsed) {
  test::HandMade made = test::hand_made(test::kEastSea);
  const QImage picture = test::chart_picture(made, {1200, 900}, 0.7, Palette::day);
  const ChartView view = [&] {
    ChartView v(test::kEastSea, {1200, 900}, 0.7);
    return v;
  }();
  int used = 0, refused = 0;
  for (const FixMark& fix : made.history.fixes) {
    const QPointF at = view.to_screen(fix.position);
    const bool crossed = likeness(picture, at, Role::fix_refused, Palette::day) > 0.8;
    EXPECT_EQ(crossed, fix.accepted == false);
    if (*fix.accepted) {
      // A ring: its own colour round a middle of halo.
      EXPECT_GT(likeness(picture, at + QPointF(2.8, 0), Role::fix, Palette::day), 0.5);
      ++used;
    } else {
      for (const QPointF arm : {QPointF(-4, -4), QPointF(4, -4), QPointF(-4, 4), QPointF(4, 4)})
        EXPECT_GT(likeness(picture, at + arm, Role::fix_refused, Palette::day), 0.6);
      ++refused;
    }
  }
  EXPECT_EQ(used, 12);
  EXPECT_EQ(refused, 3);
}

TEST(ChartSigns, HeadUpTurnsTheChartAndNotTheShip) {
  test::HandMade made = alone(120.0, 0.0, 0.0);
  Look::current().set(Palette::day);
  ChartCanvas chart;
  chart.resize(kSize);
  chart.set_metres_per_px(kScale_m_px);
  chart.set_snapshot(made.snapshot);
  chart.set_follow(Body::vehicle);
  chart.set_orientation(Orientation::head_up);
  const QImage picture = test::picture_of(chart, chart);
  const auto bearings = bearings_of(picture, Role::vehicle, 20.0, 54.0, 0.5);
  ASSERT_FALSE(bearings.empty());
  for (const double bearing : bearings) EXPECT_LT(std::abs(std::remainder(bearing, 360.0)), 3.0);
  const QPointF north = chart.view().to_screen(geo::displaced(test::kEastSea, 100.0, 0.0)) - kMiddle;
  EXPECT_NEAR(std::atan2(north.x(), -north.y()) * kDegPerRad, -120.0, 1.0);
}

}  // namespace
}  // namespace leadline::ui
