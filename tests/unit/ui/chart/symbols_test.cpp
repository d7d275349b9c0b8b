#include "ui/chart/symbols.h"

#include <gtest/gtest.h>

#include "core/geo/geodesy.h"
#include "tests/unit/ui/chart/drawn.h"
#include "ui/chart/ellipse.h"

namespace leadline::ui {
namespace {

using test::at_deg;

constexpr double kTimes = 4.0;
const QSize kSize(100, 100);
const QPointF kMiddle(50, 50);

QImage vehicle(double angle_deg, SymbolLook look = {}) {
  const Colours day(Palette::day);
  return test::drawn(kSize, day, Role::sea_deep, kTimes,
                     [&](QPainter& p) { draw_vehicle(p, kMiddle, angle_deg, look, day); });
}

double tip_bearing_deg(const QImage& image, Role role) {
  return test::screen_bearing_deg(test::furthest(image, kMiddle * kTimes, Colours(Palette::day).of(role)));
}

// The screen direction of a true bearing the long way: where a step of 5 px ends.
double stepped_bearing_deg(const ChartView& view, Geodetic at, double bearing_deg) {
  const double a = bearing_deg * kRadPerDeg, step_m = 5.0 * view.metres_per_px();
  const Geodetic to = geo::displaced(at, step_m * std::cos(a), step_m * std::sin(a));
  return test::screen_bearing_deg(QLineF(view.to_screen(at), view.to_screen(to)));
}

TEST(Symbols, HeadingSeventyTwoPointsTheArrowEastNorthEast) {
  const Geodetic at = at_deg(36.91, 129.905);
  const ChartView view(at, {800, 600}, 1.0);
  const double bearing = tip_bearing_deg(vehicle(view.screen_angle_deg(Angle::deg(71.9), at)), Role::vehicle);
  EXPECT_NEAR(bearing, 71.9, 1.0);
}

TEST(Symbols, AnArrowTurnsAgainstTheChart) {
  const Geodetic at = at_deg(36.91, 129.905);
  const ChartView view(at, {800, 600}, 1.0, Angle::deg(90.0));
  const double bearing = tip_bearing_deg(vehicle(view.screen_angle_deg(Angle::deg(71.9), at)), Role::vehicle);
  EXPECT_NEAR(bearing, 341.9, 1.0);
}

TEST(Symbols, AtEightyNineNorthNorthIsWhereThePoleIs) {
  const ChartView view(at_deg(89.0, 0.0), {800, 600}, 250.0);
  for (const double lon : {-60.0, -10.0, 35.0, 60.0}) {
    const Geodetic at = at_deg(89.2, lon);
    const double to_pole =
        test::screen_bearing_deg(QLineF(view.to_screen(at), view.to_screen(at_deg(90.0, 0.0))));
    const double north = tip_bearing_deg(vehicle(view.screen_angle_deg(Angle(), at)), Role::vehicle);
    EXPECT_NEAR(test::turn_deg(to_pole, north), 0.0, 1.0) << lon;
    const double heading =
        tip_bearing_deg(vehicle(view.screen_angle_deg(Angle::deg(71.9), at)), Role::vehicle);
    EXPECT_NEAR(test::turn_deg(stepped_bearing_deg(view, at, 71.9), heading), 0.0, 1.0) << lon;
  }
}

TEST(Symbols, TheShipsBowIsHerTip) {
  const Colours day(Palette::day);
  const QImage image = test::drawn(kSize, day, Role::sea_deep, kTimes,
                                   [&](QPainter& p) { draw_ship(p, kMiddle, 308.0, {}, day); });
  // Sides and stern reach 13.04 px, the bow 13: the bow is where the ship ends alone.
  const auto reaches = [&](double bearing_deg, double px) {
    const double a = bearing_deg * kRadPerDeg;
    const QPointF at = (kMiddle + QPointF(std::sin(a), -std::cos(a)) * px) * kTimes;
    return test::is(image, at.toPoint(), day.of(Role::ship));
  };
  EXPECT_TRUE(reaches(308.0, 12.0));
  EXPECT_FALSE(reaches(308.0 + 180.0, 12.0));  // the stern is flat and 11 px off
  EXPECT_TRUE(reaches(308.0 + 180.0, 10.0));
  EXPECT_TRUE(test::is(image, (kMiddle * kTimes).toPoint(), day.of(Role::halo)));  // reference point
}

TEST(Symbols, TheHullIsAsLongAsTheShipAndLiesRoundTheReferencePoint) {
  const Colours day(Palette::day);
  const Hull hull{80.0, 16.0, 24.0};
  const QImage image = test::drawn({300, 300}, day, Role::sea_deep, 2.0, [&](QPainter& p) {
    draw_hull(p, {150, 150}, 90.0, hull, 0.5, {}, day);  // heads east: bow 48 px to the right
  });
  int left = image.width(), right = 0, top = image.height(), bottom = 0;
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) {
      if (!test::is(image, {x, y}, day.of(Role::ship), 40)) continue;
      left = std::min(left, x);
      right = std::max(right, x);
      top = std::min(top, y);
      bottom = std::max(bottom, y);
    }
  }
  EXPECT_NEAR(right / 2.0, 150.0 + 48.0, 4.0);  // the bow's miter reaches a little further
  EXPECT_NEAR(left / 2.0, 150.0 - 112.0, 1.5);
  EXPECT_NEAR((bottom - top) / 2.0, 32.0 + 2.0, 1.0);  // with its edge
}

TEST(Symbols, TrueScaleComesAtFortyAndGoesBelowThirtyFour) {
  const Hull hull{40.0, 8.0, 20.0};
  EXPECT_FALSE(shows_true_scale(hull, 40.0 / 39.9, false));
  EXPECT_TRUE(shows_true_scale(hull, 40.0 / 40.1, false));
  EXPECT_TRUE(shows_true_scale(hull, 40.0 / 34.1, true));
  EXPECT_FALSE(shows_true_scale(hull, 40.0 / 33.9, true));
  EXPECT_FALSE(shows_true_scale({40.0, 5.9, 20.0}, 1.0, false));  // too slender
}

// A simulated body that is lost looks like one that is there but for the words, which always stand by.
TEST(Symbols, EveryStateLooksDifferentWithoutColour) {
  const std::vector<SymbolLook> looks{{SymbolState::live, false}, {SymbolState::stale, false},
                                      {SymbolState::lost, false}, {SymbolState::live, true},
                                      {SymbolState::stale, true}, {SymbolState::lost, true}};
  for (const Palette palette : {Palette::day, Palette::dusk, Palette::night}) {
    const Colours colours(palette);
    std::vector<QImage> ship, arrow, circle;
    for (const SymbolLook look : looks) {
      const auto grey = [&](const auto& paint) {
        const auto with_age = [&](QPainter& p) {
          paint(p);
          if (look.state == SymbolState::stale) draw_age(p, {24, 24}, 0.0, QStringLiteral("14 s"), colours);
          if (look.state == SymbolState::lost) draw_age(p, {24, 24}, 0.0, QStringLiteral("last"), colours);
        };
        return test::drawn({80, 48}, colours, Role::sea_deep, 1.0, with_age)
            .convertToFormat(QImage::Format_Grayscale8);
      };
      ship.push_back(grey([&](QPainter& p) { draw_ship(p, {24, 24}, 20.0, look, colours); }));
      arrow.push_back(grey([&](QPainter& p) { draw_vehicle(p, {24, 24}, 20.0, look, colours); }));
      circle.push_back(grey([&](QPainter& p) { draw_target(p, {24, 24}, look, colours); }));
    }
    for (std::size_t a = 0; a < looks.size(); ++a) {
      for (std::size_t b = 0; b < a; ++b) {
        EXPECT_GT(test::differing(ship[a], ship[b]), 30) << a << b;
        EXPECT_GT(test::differing(arrow[a], arrow[b]), 30) << a << b;
        EXPECT_GT(test::differing(circle[a], circle[b]), 30) << a << b;
      }
    }
  }
}

TEST(Symbols, StaleLetsTheChartThroughAndLostIsEmpty) {
  const Colours day(Palette::day);
  const QPoint inside = (QPointF(50, 53.2) * kTimes).toPoint();  // where the halo of the edge does not reach
  const QColor solid = day.of(Role::vehicle);
  EXPECT_TRUE(test::is(vehicle(0.0), inside, solid, 3));
  EXPECT_GT(test::apart(vehicle(0.0, {SymbolState::stale, false}).pixel(inside), solid), 60);
  const QRgb lost = vehicle(0.0, {SymbolState::lost, false}).pixel(inside);
  EXPECT_GT(qRed(lost), 180);
  EXPECT_GT(test::apart(lost, solid), 250);
}

TEST(Symbols, BracketsLeaveWhatTheyHoldAlone) {
  const Colours day(Palette::day);
  const QImage image = test::drawn(kSize, day, Role::sea_deep, kTimes,
                                   [&](QPainter& p) { draw_brackets(p, kMiddle, Role::ink, day); });
  EXPECT_TRUE(test::is(image, (QPointF(34, 36) * kTimes).toPoint(), day.of(Role::ink)));
  EXPECT_TRUE(test::is(image, (QPointF(66, 64) * kTimes).toPoint(), day.of(Role::ink)));
  EXPECT_TRUE(test::is(image, (QPointF(34, 50) * kTimes).toPoint(), day.of(Role::sea_deep), 3));
  EXPECT_TRUE(test::is(image, (kMiddle * kTimes).toPoint(), day.of(Role::sea_deep), 3));
}

}  // namespace
}  // namespace leadline::ui
