#include "ui/chart/fix_marks.h"

#include <gtest/gtest.h>

#include <functional>

#include "tests/unit/ui/chart/drawn.h"

namespace leadline::ui {
namespace {

const Colours kDay(Palette::day);

QImage on_sea(const std::function<void(QPainter&)>& paint, double times = 4.0) {
  return test::drawn({60, 60}, kDay, Role::sea_mid, times, paint);
}
QPoint px(double x, double y, double times = 4.0) { return (QPointF(x, y) * times).toPoint(); }

TEST(FixMarks, AUsedFixIsARingAndARefusedOneACross) {
  const QImage used = on_sea([](QPainter& p) { draw_fix_used(p, {30, 30}, kDay); }, 1.0);
  EXPECT_TRUE(test::is(used, {30, 30}, kDay.of(Role::halo), 130));     // open in the middle
  EXPECT_LT(qRed(used.pixel(32, 30)), qRed(used.pixel(30, 30)) - 60);  // closed all round
  EXPECT_LT(qRed(used.pixel(27, 30)), qRed(used.pixel(30, 30)) - 60);
  EXPECT_LT(qRed(used.pixel(30, 27)), qRed(used.pixel(30, 30)) - 60);

  const QImage refused = on_sea([](QPainter& p) { draw_fix_refused(p, {30, 30}, {30, 30}, kDay); });
  const QColor brown = kDay.of(Role::fix_refused);
  EXPECT_TRUE(test::is(refused, px(30, 30), brown));
  for (const double x : {-4.0, 4.0})
    for (const double y : {-4.0, 4.0}) EXPECT_TRUE(test::is(refused, px(30 + x, 30 + y), brown)) << x << y;
  EXPECT_TRUE(test::is(refused, px(30, 25.5), kDay.of(Role::sea_mid), 3));
  EXPECT_TRUE(test::is(refused, px(34.5, 30), kDay.of(Role::sea_mid), 3));
}

TEST(FixMarks, ARefusedFixPointsToWhereTheSolutionWas) {
  const QImage image = on_sea([](QPainter& p) { draw_fix_refused(p, {12, 12}, {12, 50}, kDay); });
  int on = 0, changes = 0;
  bool last = false;
  for (int y = 22 * 4; y < 48 * 4; ++y) {
    const bool dot = test::is(image, {12 * 4, y}, kDay.of(Role::fix_refused), 90);
    on += dot ? 1 : 0;
    changes += dot != last ? 1 : 0;
    last = dot;
  }
  EXPECT_NEAR(on / (26.0 * 4.0), 0.4, 0.08);  // 2 on, 3 off
  EXPECT_NEAR(changes, 10, 2);
}

TEST(FixMarks, ARingStandsWithinAQuarterOfAPixel) {
  for (const QPointF at : {QPointF(30, 30), QPointF(30.5, 30.25), QPointF(29.9, 30.7)}) {
    const QImage image = on_sea([&](QPainter& p) { draw_fix_used(p, at, kDay); }, 1.0);
    double sum = 0.0, x_sum = 0.0, y_sum = 0.0;
    for (int y = 0; y < image.height(); ++y) {
      for (int x = 0; x < image.width(); ++x) {
        const double weight = test::apart(image.pixel(x, y), kDay.of(Role::sea_mid));
        sum += weight;
        x_sum += weight * (x + 0.5);
        y_sum += weight * (y + 0.5);
      }
    }
    EXPECT_NEAR(x_sum / sum, at.x(), 0.25);
    EXPECT_NEAR(y_sum / sum, at.y(), 0.25);
  }
}

TEST(FixMarks, TheBeamsLabelStandsBesideItAtSixtyPerCent) {
  for (const QPointF vehicle : {QPointF(40, 60), QPointF(360, 40), QPointF(200, 380), QPointF(390, 200)}) {
    QImage image(400, 400, QImage::Format_RGB32);
    QPainter painter(&image);
    const QPointF ship(200, 200);
    const QRectF box = draw_usbl_beam(painter, ship, vehicle, QStringLiteral("USBL 3 s"), kDay);
    const QLineF line(ship, vehicle);
    const QLineF normal = line.normalVector().unitVector();
    double nearest = 1e9;
    for (const QPointF corner : {box.topLeft(), box.topRight(), box.bottomLeft(), box.bottomRight()}) {
      const QPointF d = corner - ship;
      nearest = std::min(nearest, std::abs(d.x() * normal.dx() + d.y() * normal.dy()));
    }
    EXPECT_GE(nearest, 2.9);
    EXPECT_LE(nearest, 3.1);
    EXPECT_NEAR(QLineF(box.center(), line.pointAt(0.6)).length(), 0.0, box.width() / 2.0 + 4.0);
  }
}

}  // namespace
}  // namespace leadline::ui
