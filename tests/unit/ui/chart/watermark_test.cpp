#include "ui/chart/watermark.h"

#include <gtest/gtest.h>

#include "tests/unit/ui/chart/drawn.h"

namespace leadline::ui {
namespace {

QImage marked(QSize size, QRect exposed, const Colours& colours) {
  return test::drawn(size, colours, Role::sea_deep, 1.0,
                     [&](QPainter& p) { draw_replay_watermark(p, exposed, colours); });
}

TEST(Watermark, EveryPartOfAReplayedChartShowsIt) {
  const Colours day(Palette::day);
  const QImage image = marked({1448, 760}, {0, 0, 1448, 760}, day);
  const QImage plain = test::drawn(image.size(), day, Role::sea_deep, 1.0, [](QPainter&) {});
  const int differing = test::differing(image, plain);
  EXPECT_GT(differing, 1448 * 760 / 50);
  EXPECT_LT(differing, 1448 * 760 / 5);
  for (int x = 0; x + 420 <= 1448; x += 257)
    for (int y = 0; y + 210 <= 760; y += 137)
      EXPECT_GT(test::differing(image.copy(x, y, 420, 210), plain.copy(x, y, 420, 210)), 3'000)
          << x << ' ' << y;
}

TEST(Watermark, AStripIsWhatTheWholeShowsThere) {
  const Colours dusk(Palette::dusk);
  const QImage whole = marked({900, 516}, {0, 0, 900, 516}, dusk);
  for (const QRect strip : {QRect(0, 0, 900, 3), QRect(897, 0, 3, 516), QRect(100, 200, 40, 40)})
    EXPECT_EQ(marked({900, 516}, strip, dusk).copy(strip), whole.copy(strip));
}

TEST(Watermark, ItRepeatsEveryFourHundredAndTwentyByTwoHundredAndTen) {
  const Colours night(Palette::night);
  const QImage image = marked({1300, 900}, {0, 0, 1300, 900}, night);
  EXPECT_EQ(test::differing(image.copy(0, 0, 400, 400), image.copy(420, 0, 400, 400)), 0);
  EXPECT_EQ(test::differing(image.copy(0, 0, 400, 200), image.copy(210, 210, 400, 200)), 0);
}

}  // namespace
}  // namespace leadline::ui
