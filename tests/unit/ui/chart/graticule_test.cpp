#include "ui/chart/graticule.h"

#include <gtest/gtest.h>

#include <set>

#include "core/geo/geodesy.h"
#include "tests/unit/ui/chart/drawn.h"

namespace leadline::ui {
namespace {

using test::at_deg;

const QSize kChart(1448, 760);

TEST(Graticule, LinesAreAHundredAndTenToTwoHundredAndSixtyPixelsApart) {
  // 0.08 m/px (0.01' is 232 px) to 5000 m/px (10 deg is 222 px), in sixty steps.
  double closest = 1e9, furthest = 0.0;
  for (const double lat : {0.0, 45.0, 75.0}) {
    for (int i = 0; i < 60; ++i) {
      const double metres_per_px = 0.08 * std::pow(2'000.0 / 0.08, i / 59.0);
      const ChartView view(at_deg(lat, 20.0), kChart, metres_per_px);
      const GraticuleStep step = graticule_step(view);
      const Geodetic centre = view.centre();
      const double to_north = geo::geodesic(centre, at_deg(lat + 0.01, 20.0)).distance_m / 0.6;
      const double to_east = geo::geodesic(centre, at_deg(lat, 20.01)).distance_m / 0.6;
      const double down = to_north * step.lat_min / metres_per_px,
                   across = to_east * step.lon_min / metres_per_px;
      EXPECT_GE(down, 109.0) << lat << ' ' << metres_per_px;
      EXPECT_LE(down, 261.0) << lat << ' ' << metres_per_px;
      // At 75 N a minute of longitude is 0.26 of one of latitude: 0.01' is closer than 110 px below 4.3 cm.
      EXPECT_GE(across, 109.0) << lat << ' ' << metres_per_px;
      EXPECT_LE(across, 261.0) << lat << ' ' << metres_per_px;
      closest = std::min({closest, down, across});
      furthest = std::max({furthest, down, across});
    }
  }
  RecordProperty("closest_px", std::to_string(closest));
  RecordProperty("furthest_px", std::to_string(furthest));
}

// Every vertex, and the middle of every piece, lies on its meridian or parallel.
void expect_on_their_lines(const ChartView& view) {
  const auto lines = graticule_lines(view, graticule_step(view));
  EXPECT_GE(lines.size(), 4U);
  for (const GraticuleLine& line : lines) {
    for (int i = 1; i < line.points.size(); ++i) {
      for (const QPointF p : {line.points[i], (line.points[i] + line.points[i - 1]) / 2.0}) {
        const Geodetic at = view.to_geodetic(p);
        const Geodetic on = line.meridian ? Geodetic{at.lat, Angle::deg(line.value_min / 60.0)}
                                          : Geodetic{Angle::deg(line.value_min / 60.0), at.lon};
        const double off = QLineF(p, view.to_screen(on)).length();
        ASSERT_LT(off, 0.3) << (line.meridian ? "meridian " : "parallel ") << line.value_min << " piece "
                            << i;
      }
    }
  }
}

TEST(Graticule, LinesLieWhereTheyAreNamed) {
  expect_on_their_lines(ChartView(at_deg(36.91, 129.905), kChart, 1.058));
  expect_on_their_lines(ChartView(at_deg(36.91, 129.905), kChart, 1.058, Angle::deg(90.0)));
  expect_on_their_lines(ChartView(at_deg(75.0, -20.0), kChart, 500.0, Angle::deg(33.0)));
  expect_on_their_lines(ChartView(at_deg(-54.0, 20.0), kChart, 3'000.0));
  expect_on_their_lines(ChartView(at_deg(0.0, 0.0), kChart, 5'000.0));
  expect_on_their_lines(ChartView(at_deg(89.0, 10.0), kChart, 20.0));
  expect_on_their_lines(ChartView(at_deg(89.0, 10.0), kChart, 300.0));
  expect_on_their_lines(ChartView(at_deg(-89.99, 10.0), kChart, 100.0));
}

TEST(Graticule, AtEightyNineNorthMeridiansFanOutOfThePole) {
  const ChartView view(at_deg(89.0, 10.0), kChart, 400.0);  // the pole is 279 px above the middle
  const auto lines = graticule_lines(view, graticule_step(view));
  const QPointF pole = view.to_screen(at_deg(90.0, 0.0));
  ASSERT_TRUE(QRectF(QPointF(), kChart).contains(pole));
  std::set<double> at_pole, meridians;
  for (const GraticuleLine& line : lines) {
    if (!line.meridian) continue;
    EXPECT_TRUE(meridians.insert(line.value_min).second) << line.value_min << " twice";
    // Straight through the pole: its ends and the pole are in one line.
    const QLineF whole(line.points.front(), line.points.back());
    const QLineF normal = whole.normalVector().unitVector();
    const QPointF d = pole - whole.p1();
    EXPECT_NEAR(d.x() * normal.dx() + d.y() * normal.dy(), 0.0, 0.5) << line.value_min;
    const double gap = std::min(QLineF(whole.p1(), pole).length(), QLineF(whole.p2(), pole).length());
    if (gap < 0.5)
      at_pole.insert(line.value_min);
    else
      EXPECT_GT(gap, 20.0);  // clear of the knot
  }
  EXPECT_EQ(at_pole, (std::set<double>{-10'800.0, -5'400.0, 0.0, 5'400.0}));
  EXPECT_GE(meridians.size(), 12U);
}

TEST(Graticule, FiguresWrapAtTheDateLine) {
  const ChartView view(at_deg(-17.0, 179.999), kChart, 10.0);
  const GraticuleStep step = graticule_step(view);
  std::set<std::string> east, west;
  double last = -1e9;
  for (const GraticuleLine& line : graticule_lines(view, step)) {
    if (!line.meridian) continue;
    EXPECT_GT(line.points.front().x(), last);  // from west to east without a jump
    last = line.points.front().x();
    const std::string figure = graticule_figure(line, step).toStdString();
    (figure.back() == 'E' ? east : west).insert(figure);
  }
  EXPECT_EQ(step.lon_min, 1.0);
  EXPECT_TRUE(east.count("179°59′ E"));
  EXPECT_TRUE(west.count("179°59′ W"));
  EXPECT_TRUE(west.count("180°00′"));
}

TEST(Graticule, FiguresHaveTheDecimalsOfTheirStep) {
  const auto figure = [](bool meridian, double value, double step) {
    return graticule_figure({meridian, value, {}}, {step, step}).toStdString();
  };
  EXPECT_EQ(figure(false, 36 * 60 + 54.7, 0.1), "36°54.7′ N");
  EXPECT_EQ(figure(false, -(36 * 60 + 4.7), 0.1), "36°04.7′ S");
  EXPECT_EQ(figure(true, -(9 * 60 + 0.05), 0.05), "9°00.05′ W");
  EXPECT_EQ(figure(true, 129 * 60 + 54.025, 0.025), "129°54.025′ E");
  EXPECT_EQ(figure(false, 59.9999999999, 1.0), "1°00′ N");
  EXPECT_EQ(figure(false, 0.0, 10.0), "0°00′");
  EXPECT_EQ(figure(true, 120.0, 60.0), "2° E");
  EXPECT_EQ(figure(true, -10'800.0, 600.0), "180°");
}

TEST(Graticule, AStripIsWhatTheWholeShowsThere) {
  const Colours day(Palette::day);
  for (const double up : {0.0, 33.0}) {
    const ChartView view(at_deg(36.91, 129.905), {600, 400}, 1.058, Angle::deg(up));
    const auto paint = [&](QRect exposed) {
      return test::drawn(view.size(), day, Role::sea_deep, 1.0,
                         [&](QPainter& p) { draw_graticule(p, view, graticule_step(view), exposed, day); });
    };
    const QImage whole = paint({QPoint(), view.size()});
    for (const QRect strip : {QRect(0, 0, 600, 3), QRect(597, 0, 3, 400), QRect(0, 200, 600, 1)}) {
      EXPECT_EQ(paint(strip).copy(strip), whole.copy(strip));
      QImage rest = paint(strip);
      QPainter(&rest).fillRect(strip, day.of(Role::sea_deep));
      EXPECT_EQ(test::differing(rest, paint({})), 0);
    }
  }
}

TEST(Graticule, NoFigureUnderFurniture) {
  const Colours day(Palette::day);
  const ChartView view(at_deg(36.91, 129.905), {900, 516}, 1.058);
  const std::vector<QRectF> furniture{{0, 200, 200, 316}};
  const auto paint = [&](const std::vector<QRectF>& taken) {
    return test::drawn(view.size(), day, Role::sea_deep, 1.0, [&](QPainter& p) {
      draw_graticule_figures(p, view, graticule_step(view), taken, day);
    });
  };
  const QImage plain = test::drawn(view.size(), day, Role::sea_deep, 1.0, [](QPainter&) {});
  const QRect covered = furniture.front().toRect();
  EXPECT_EQ(test::differing(paint(furniture).copy(covered), plain.copy(covered)), 0);
  EXPECT_GT(test::differing(paint({}).copy(covered), plain.copy(covered)), 200);
  EXPECT_GT(test::differing(paint(furniture), plain), 200);  // the others stand
}

}  // namespace
}  // namespace leadline::ui
