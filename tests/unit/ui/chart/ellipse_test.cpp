#include "ui/chart/ellipse.h"

#include <gtest/gtest.h>

#include <limits>

#include "core/geo/geodesy.h"
#include "tests/unit/ui/chart/drawn.h"

namespace leadline::ui {
namespace {

using test::at_deg;

struct Covariance {
  double north, cross, east;
};
Covariance covariance(double major_m, double minor_m, double azimuth_deg) {
  const double a = azimuth_deg * kRadPerDeg, c = std::cos(a), s = std::sin(a);
  const double big = major_m * major_m, small = minor_m * minor_m;
  return {big * c * c + small * s * s, (big - small) * s * c, big * s * s + small * c * c};
}

TEST(Ellipse, AxesComeBackFromTheirCovariance) {
  for (double azimuth = 0.0; azimuth < 180.0; azimuth += 7.5) {
    const Covariance cov = covariance(60.0, 20.0, azimuth);
    const auto ellipse = sigma_ellipse(cov.north, cov.cross, cov.east);
    ASSERT_TRUE(ellipse);
    EXPECT_NEAR(ellipse->major_m, 60.0, 1e-9);
    EXPECT_NEAR(ellipse->minor_m, 20.0, 1e-9);
    EXPECT_NEAR(std::remainder(ellipse->azimuth.deg() - azimuth, 180.0), 0.0, 1e-9);
    EXPECT_GE(ellipse->azimuth.deg(), 0.0);
    EXPECT_LE(ellipse->azimuth.deg(), 180.0);
  }
  const auto line = sigma_ellipse(4.0, 4.0, 4.0);  // known along 135 deg, not along 045
  ASSERT_TRUE(line);
  EXPECT_NEAR(line->minor_m, 0.0, 1e-6);
  EXPECT_NEAR(line->azimuth.deg(), 45.0, 1e-9);
  EXPECT_FALSE(sigma_ellipse(1.0, 2.0, 1.0));
  EXPECT_FALSE(sigma_ellipse(-1.0, 0.0, -1.0));
  EXPECT_FALSE(sigma_ellipse(std::numeric_limits<double>::quiet_NaN(), 0.0, 1.0));
  EXPECT_FALSE(sigma_ellipse(std::numeric_limits<double>::infinity(), 0.0, 1.0));
}

// 3 : 1 along 030: what lies 45 px off along a true bearing is inside or outside.
void expect_along_030(const ChartView& view, Geodetic at) {
  const Colours day(Palette::day);
  const Covariance cov = covariance(60.0 * view.metres_per_px(), 20.0 * view.metres_per_px(), 30.0);
  const QImage image = test::drawn(view.size(), day, Role::sea_deep, 1.0, [&](QPainter& p) {
    EXPECT_TRUE(
        draw_sigma_ellipse(p, view, at, *sigma_ellipse(cov.north, cov.cross, cov.east), Role::vehicle, day));
  });
  const auto inside = [&](double bearing_deg) {
    const double a = bearing_deg * kRadPerDeg, off_m = 45.0 * view.metres_per_px();
    const QPointF p = view.to_screen(geo::displaced(at, off_m * std::cos(a), off_m * std::sin(a)));
    return !test::is(image, {int(std::floor(p.x())), int(std::floor(p.y()))}, day.of(Role::sea_deep), 6);
  };
  EXPECT_TRUE(inside(30.0));
  EXPECT_TRUE(inside(210.0));
  for (const double bearing : {60.0, 120.0, 240.0, 300.0, 330.0, 0.0})
    EXPECT_FALSE(inside(bearing)) << bearing;
}

TEST(Ellipse, AMajorAxisAt030LiesAlong030) {
  const Geodetic at = at_deg(36.91, 129.905);
  expect_along_030(ChartView(at, {300, 300}, 2.0), at);
  expect_along_030(ChartView(at, {300, 300}, 2.0, Angle::deg(90.0)), at);
  expect_along_030(ChartView(at, {300, 300}, 2.0, Angle::deg(217.0)), at);
  const ChartView polar(at_deg(89.0, 0.0), {300, 300}, 2.0);
  expect_along_030(polar, polar.to_geodetic({150, 150}));
  ChartView far(at_deg(89.0, 0.0), {300, 300}, 2.0);
  far.pan({15'000, 0});
  expect_along_030(far, far.to_geodetic({150, 150}));
}

TEST(Ellipse, ASmallOneIsLeftToItsFigure) {
  const Geodetic at = at_deg(36.91, 129.905);
  const ChartView view(at, {100, 100}, 1.0);
  const Colours day(Palette::day);
  QImage image(100, 100, QImage::Format_RGB32);
  QPainter painter(&image);
  EXPECT_FALSE(draw_sigma_ellipse(painter, view, at, {9.9, 5.0, Angle()}, Role::target, day));
  EXPECT_TRUE(draw_sigma_ellipse(painter, view, at, {10.1, 5.0, Angle()}, Role::target, day));
}

TEST(Ellipse, TheDoubtOfALostBodyHasNoFill) {
  const Colours day(Palette::day);
  const auto middle = [&](SymbolState state) {
    const QImage image = test::drawn({100, 100}, day, Role::sea_deep, 1.0, [&](QPainter& p) {
      draw_doubt(p, {50, 50}, 30.0, state, Role::vehicle, day);
    });
    int rim = 0;
    for (int x = 15; x < 25; ++x) rim += test::is(image, {x, 50}, day.of(Role::sea_deep), 6) ? 0 : 1;
    return std::pair{test::apart(image.pixel(50, 50), day.of(Role::sea_deep)), rim};
  };
  EXPECT_EQ(middle(SymbolState::live), (std::pair{0, 0}));
  EXPECT_GT(middle(SymbolState::stale).first, 20);
  EXPECT_GT(middle(SymbolState::stale).second, 2);
  EXPECT_EQ(middle(SymbolState::lost).first, 0);
  EXPECT_GT(middle(SymbolState::lost).second, 2);
}

}  // namespace
}  // namespace leadline::ui
