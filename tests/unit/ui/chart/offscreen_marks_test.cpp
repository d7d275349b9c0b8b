#include "ui/chart/offscreen_marks.h"

#include <gtest/gtest.h>

#include "tests/unit/ui/chart/drawn.h"

namespace leadline::ui {
namespace {

const QSize kChart(800, 600);
const Colours kDay(Palette::day);

TEST(OffscreenMarks, ABodyOutsideIsPointedAtFromTheEdge) {
  for (const QPointF at : {QPointF(1600, 300), QPointF(400, -900), QPointF(-3000, 2600), QPointF(820, 610)}) {
    EXPECT_TRUE(is_offscreen(at, kChart));
    std::vector<QRectF> boxes;
    const QImage image = test::drawn(kChart, kDay, Role::sea_deep, 1.0, [&](QPainter& p) {
      boxes = draw_offscreen_marks(p, kChart, {{Body::vehicle, at, QStringLiteral("1.2 km"), {}}}, {}, kDay);
    });
    ASSERT_EQ(boxes.size(), 1U);
    EXPECT_TRUE(QRectF(QPointF(), kChart).contains(boxes[0]));
    // The arrow's tip is the vehicle-coloured pixel nearest to the body, 12 px or little more inside the
    // edge.
    QPointF tip;
    double nearest = 1e9;
    for (int y = 0; y < image.height(); ++y) {
      for (int x = 0; x < image.width(); ++x) {
        if (!test::is(image, {x, y}, kDay.of(Role::vehicle), 60)) continue;
        const double off = QLineF({x + 0.5, y + 0.5}, at).length();
        if (off < nearest) tip = {x + 0.5, y + 0.5};
        nearest = std::min(nearest, off);
      }
    }
    const double inside = std::min({tip.x(), 800.0 - tip.x(), tip.y(), 600.0 - tip.y()});
    EXPECT_GE(inside, 11.0);
    EXPECT_LE(inside, 27.0);
    const double way = test::screen_bearing_deg(QLineF(QPointF(400, 300), at));
    const double seen = test::screen_bearing_deg(QLineF(QPointF(400, 300), tip));
    EXPECT_NEAR(test::turn_deg(way, seen), 0.0, 4.0);
  }
  EXPECT_FALSE(is_offscreen({400, 300}, kChart));
}

TEST(OffscreenMarks, TheyKeepClearOfFurnitureAndOfOneAnother) {
  const std::vector<QRectF> furniture{{604, 12, 184, 70}, {700, 200, 100, 200}};
  std::vector<OffscreenMark> marks;
  for (const Body body : {Body::ship, Body::vehicle, Body::target})
    marks.push_back({body, {2000, 310}, QStringLiteral("12.4 km"), {}});
  QImage image(kChart, QImage::Format_RGB32);
  QPainter painter(&image);
  const auto boxes = draw_offscreen_marks(painter, kChart, marks, furniture, kDay);
  ASSERT_EQ(boxes.size(), 3U);
  for (std::size_t a = 0; a < 3; ++a) {
    for (const QRectF taken : furniture) EXPECT_FALSE(boxes[a].intersects(taken));
    for (std::size_t b = 0; b < a; ++b) EXPECT_FALSE(boxes[a].intersects(boxes[b]));
  }
}

TEST(OffscreenMarks, NothingIsDrawnOfANowhere) {
  QImage image(kChart, QImage::Format_RGB32);
  QPainter painter(&image);
  const double nan = std::nan("");
  EXPECT_TRUE(
      draw_offscreen_marks(painter, kChart, {{Body::ship, {nan, nan}, QString(), {}}}, {}, kDay).empty());
}

}  // namespace
}  // namespace leadline::ui
