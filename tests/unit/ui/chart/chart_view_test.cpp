#include "ui/chart/chart_view.h"

#include <gtest/gtest.h>

#include <random>

#include "core/geo/geodesy.h"

namespace leadline::ui {
namespace {

const Geodetic kSurvey{Angle::deg(36.91), Angle::deg(129.905)};

TEST(ChartView, NorthIsUpAndEastIsRight) {
  const ChartView view(kSurvey, {1000, 800}, 2.0);
  EXPECT_NEAR(view.to_screen(kSurvey).x(), 500.0, 1e-6);
  EXPECT_NEAR(view.to_screen(kSurvey).y(), 400.0, 1e-6);
  const QPointF north = view.to_screen(geo::displaced(kSurvey, 200.0, 0.0));
  const QPointF east = view.to_screen(geo::displaced(kSurvey, 0.0, 200.0));
  EXPECT_NEAR(north.x(), 500.0, 0.01);
  EXPECT_NEAR(north.y(), 300.0, 0.01);
  EXPECT_NEAR(east.x(), 600.0, 0.01);
  EXPECT_NEAR(east.y(), 400.0, 0.01);
}

TEST(ChartView, TheBearingThatIsUpPointsToTheTop) {
  const ChartView view(kSurvey, {1000, 800}, 2.0, Angle::deg(90.0));
  const QPointF east = view.to_screen(geo::displaced(kSurvey, 0.0, 200.0));
  const QPointF north = view.to_screen(geo::displaced(kSurvey, 200.0, 0.0));
  EXPECT_NEAR(east.x(), 500.0, 0.01);
  EXPECT_NEAR(east.y(), 300.0, 0.01);
  EXPECT_NEAR(north.x(), 400.0, 0.01);
  EXPECT_NEAR(view.screen_angle_deg(Angle::deg(71.9), kSurvey), 341.9, 1e-9);
  EXPECT_NEAR(view.screen_angle_deg(Angle::deg(90.0), kSurvey), 0.0, 1e-9);
}

TEST(ChartView, ScreenAndPlaceRoundTripAtEveryTurnAndScale) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> turn(0.0, 360.0), zoom(-2.0, 3.0), x(0.0, 1000.0), lat(-88.0, 88.0),
      lon(-180.0, 179.9);
  for (int i = 0; i < 500; ++i) {
    const ChartView view({Angle::deg(lat(random)), Angle::deg(lon(random))}, {1000, 800},
                         std::pow(10.0, zoom(random)), Angle::deg(turn(random)));
    const QPointF screen(x(random), x(random));
    const QPointF back = view.to_screen(view.to_geodetic(screen));
    EXPECT_NEAR(back.x(), screen.x(), 1e-3);
    EXPECT_NEAR(back.y(), screen.y(), 1e-3);
    const maps::PlanePoint p = view.to_plane(screen);
    const QPointF mapped = view.plane_to_screen().map(QPointF(p.east_m, p.north_m));
    EXPECT_NEAR(mapped.x(), screen.x(), 1e-6);
    EXPECT_NEAR(mapped.y(), screen.y(), 1e-6);
  }
}

TEST(ChartView, ABearingOnTheScreenIsTheBearingOnTheGroundEvenNearThePole) {
  for (const double lat : {0.0, -45.0, 89.0}) {
    ChartView view({Angle::deg(lat), Angle::deg(179.99)}, {1000, 800}, 20.0, Angle::deg(30.0));
    // A place away from the centre, where true north is not the chart's.
    const Geodetic at = view.to_geodetic({900.0, 100.0});
    for (const double bearing : {0.0, 71.9, 200.0}) {
      const Geodetic ahead =
          geo::displaced(at, 1000.0 * cos(Angle::deg(bearing)), 1000.0 * sin(Angle::deg(bearing)));
      const QPointF step = view.to_screen(ahead) - view.to_screen(at);
      const double drawn = Angle::rad(std::atan2(step.x(), -step.y())).wrapped_2pi().deg();
      EXPECT_NEAR(std::remainder(drawn - view.screen_angle_deg(Angle::deg(bearing), at), 360.0), 0.0, 0.35)
          << lat;
    }
  }
}

TEST(ChartView, ZoomKeepsWhatIsUnderTheCursor) {
  ChartView view(kSurvey, {1000, 800}, 2.0, Angle::deg(40.0));
  const QPointF cursor(137.0, 655.0);
  for (const double factor : {1.25, 1.25, 0.5, 8.0, 0.01}) {
    const Geodetic before = view.to_geodetic(cursor);
    view.zoom(factor, cursor);
    const QPointF after = view.to_screen(before);
    EXPECT_NEAR(after.x(), cursor.x(), 0.51);  // the origin stays on whole pixels
    EXPECT_NEAR(after.y(), cursor.y(), 0.51);
  }
  view.zoom(1e9, cursor);
  EXPECT_DOUBLE_EQ(view.metres_per_px(), ChartView::kClosest);
  view.zoom(1e-12, cursor);
  EXPECT_DOUBLE_EQ(view.metres_per_px(), ChartView::kFarthest);
}

TEST(ChartView, IsRecentredOnlyWhenItIsFar) {
  ChartView view(kSurvey, {1000, 800}, 2.0);
  view.centre_on(geo::displaced(kSurvey, 20'000.0, 0.0));
  EXPECT_EQ(view.projection().origin(), kSurvey);
  const Geodetic far = geo::displaced(kSurvey, 60'000.0, 0.0);
  view.centre_on(far);
  EXPECT_EQ(view.projection().origin(), far);
  EXPECT_NEAR(geo::geodesic(view.centre(), far).distance_m, 0.0, 2.0);
  // Near the pole a few kilometres east turn north by degrees.
  const Geodetic arctic{Angle::deg(89.0), Angle::deg(10.0)};
  view.centre_on(arctic);
  view.centre_on(geo::displaced(arctic, 0.0, 5'000.0));
  EXPECT_NE(view.projection().origin(), arctic);
}

TEST(ChartView, ScaleIsThatOfAScreenOf96Dpi) { EXPECT_NEAR(scale_denominator(1.0583333333), 4000.0, 1e-3); }

}  // namespace
}  // namespace leadline::ui
