#include "ui/chart/scale_bar.h"

#include <gtest/gtest.h>

#include "core/geo/geodesy.h"
#include "tests/unit/ui/chart/drawn.h"

namespace leadline::ui {
namespace {

using test::at_deg;

TEST(ScaleBar, ItIsARoundLengthOfFittingSize) {
  for (double metres_per_px = 0.005; metres_per_px < 5'000.0; metres_per_px *= 1.11) {
    const ScaleBar bar = scale_bar(ChartView(at_deg(54.0, 10.0), {1448, 760}, metres_per_px));
    EXPECT_GE(bar.length_px, 103.0) << metres_per_px;
    EXPECT_LE(bar.length_px, 261.0) << metres_per_px;
    const double leading = bar.length_m / std::pow(10.0, std::floor(std::log10(bar.length_m) + 1e-9));
    EXPECT_TRUE(std::abs(leading - 1) < 1e-9 || std::abs(leading - 2) < 1e-9 || std::abs(leading - 5) < 1e-9);
  }
}

// The ink's ends in the picture, against the ellipsoid across the middle of the view.
TEST(ScaleBar, WhatIsDrawnIsWithinAPixelOfAGeodesic) {
  const Colours day(Palette::day);
  for (const double lat : {0.0, 36.9, 75.0, 89.0}) {
    for (const double metres_per_px : {0.02, 1.058, 31.0, 800.0, 5'000.0}) {
      const ChartView view(at_deg(lat, 129.9), {1000, 400}, metres_per_px, Angle::deg(20.0));
      const ScaleBar bar = scale_bar(view);
      const QImage image = test::drawn(view.size(), day, Role::sea_deep, 1.0,
                                       [&](QPainter& p) { draw_scale_bar(p, view, day); });
      const int row = 400 - 28;  // its lower edge, ink from end to end
      int left = 1000, right = 0;
      for (int x = 0; x < 1000; ++x) {
        if (!test::is(image, {x, row - 1}, day.of(Role::ink), 200)) continue;
        left = std::min(left, x);
        right = std::max(right, x);
      }
      const double drawn_px = right - left;  // centre to centre of its edges
      const QPointF middle(500, 200), half(drawn_px / 2.0, 0);
      const double true_m =
          geo::geodesic(view.to_geodetic(middle - half), view.to_geodetic(middle + half)).distance_m;
      EXPECT_NEAR(true_m / bar.length_m * drawn_px, drawn_px, 1.3) << lat << ' ' << metres_per_px;
    }
  }
}

TEST(ScaleBar, ItsRectangleHoldsAllItDraws) {
  const Colours day(Palette::day);
  for (const double metres_per_px : {0.02, 0.1, 1.058, 31.0, 5'000.0}) {
    const ChartView view(at_deg(36.9, 129.9), {600, 300}, metres_per_px);
    QRectF box;
    QImage image = test::drawn(view.size(), day, Role::sea_deep, 1.0,
                               [&](QPainter& p) { box = draw_scale_bar(p, view, day); });
    EXPECT_TRUE(QRectF(0, 0, 600, 300).contains(box));
    QPainter(&image).fillRect(box.toAlignedRect(), day.of(Role::sea_deep));
    EXPECT_EQ(test::differing(image, test::drawn(view.size(), day, Role::sea_deep, 1.0, [](QPainter&) {})),
              0);
  }
}

}  // namespace
}  // namespace leadline::ui
