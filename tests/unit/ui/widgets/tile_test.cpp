// Every state of a value, seen: pictures of all, and for each the mark that tells it from the others.

#include <gtest/gtest.h>

#include <QImage>
#include <QPainter>
#include <cmath>
#include <set>

#include "tests/support/picture.h"
#include "tests/unit/ui/widgets/sample_texts.h"
#include "ui/look/look.h"
#include "ui/widgets/paint_text.h"
#include "ui/widgets/spoken.h"
#include "ui/widgets/tile_painter.h"
#include "ui/widgets/value_tile.h"

namespace leadline::ui {
namespace {

using test::depth;

TileText in_state(ValueState state) {
  TileText text = depth();
  text.state = state;
  switch (state) {
    case ValueState::ageing:
      text.age = "1.1 s";
      break;
    case ValueState::stale:
      text.age = "14 s";
      text.sigma = "3.9";
      break;
    case ValueState::lost:
      text.age = "2:41";
      text.note = "last 1512.4 m at 13:59:56 Z";
      break;
    case ValueState::pending:
      text = test::tile("Set depth", "1512.0", "m", "", "", "0.6 s");
      text.state = state;
      break;
    case ValueState::disagree:
      text = test::tile("Set depth", "1512.0", "m", "", "", "0.6 s");
      text.state = state;
      text.note = "vehicle reports 1508.0 m";
      break;
    case ValueState::alert:
      text = test::tile("Altitude", "3.1", "m", "0.1", "DVL", "0.2 s");
      text.state = state;
      text.limit = "LOW, limit 5.0";
      break;
    case ValueState::live:
      break;
  }
  return text;
}

constexpr ValueState kStates[]{ValueState::live,    ValueState::ageing,   ValueState::stale, ValueState::lost,
                               ValueState::pending, ValueState::disagree, ValueState::alert};

QImage picture_of(const TileText& text, const Colours& colours, QSize size = {242, kTileHeight},
                  TileStyle style = {}) {
  QImage image(size, QImage::Format_RGB32);
  image.fill(colours.of(Role::bg_panel));
  QPainter painter(&image);
  draw_tile(painter, image.rect(), text, colours, style);
  return image;
}

int count(const QImage& image, const QColor& colour, QRect in = {}) {
  if (in.isNull()) in = image.rect();
  int found = 0;
  for (int y = in.top(); y <= in.bottom(); ++y)
    for (int x = in.left(); x <= in.right(); ++x) found += image.pixelColor(x, y).rgb() == colour.rgb();
  return found;
}

struct Tiles : testing::Test {
  Tiles() { Look::current().set(Palette::day); }
  const Colours colours{Palette::day};
};

TEST_F(Tiles, StatesLookAsTheyDidWhenLookedAt) {
  for (const Palette palette : {Palette::day, Palette::dusk, Palette::night}) {
    const Colours c(palette);
    QImage sheet(4 * 250 + 8, 8 * 69 + 8, QImage::Format_RGB32);
    sheet.fill(c.of(Role::bg_panel));
    QPainter painter(&sheet);
    int row = 0;
    for (const ValueState state : kStates) {
      for (int column = 0; column < 4; ++column) {
        TileText text = in_state(state);
        text.simulated = column == 1;
        text.replay = column == 2;
        text.manual = column == 3;
        draw_tile(painter, QRect(8 + column * 250, 8 + row * 69, 242, kTileHeight), text, c, {28, true});
      }
      ++row;
    }
    TileText changed = depth();
    changed.source = "USBL";
    changed.was_source = "GNSS";
    draw_tile(painter, QRect(8, 8 + row * 69, 242, kTileHeight), changed, c);
    draw_tile(painter, QRect(258, 8 + row * 69, 116, kSmallTileHeight), *test::vehicle().pitch, c,
              {18, false});
    TileText stale = *test::vehicle().roll;
    stale.state = ValueState::stale;
    stale.age = "14 s";
    draw_tile(painter, QRect(382, 8 + row * 69, 116, kSmallTileHeight), stale, c, {18, false});
    TileText unknown = depth();
    unknown.value.clear();
    unknown.sigma.clear();
    draw_tile(painter, QRect(508, 8 + row * 69, 242, kTileHeight), unknown, c);
    TileText caution = in_state(ValueState::alert);
    caution.priority = Alarm::Priority::caution;
    caution.simulated = true;
    draw_tile(painter, QRect(758, 8 + row * 69, 242, kTileHeight), caution, c);
    painter.end();
    const char* const names[]{"day", "dusk", "night"};
    leadline::test::expect_picture(sheet, std::string("states_tiles_") + names[static_cast<int>(palette)]);
  }
}

TEST_F(Tiles, NoTwoStatesLookAlikeInGrey) {
  std::vector<QImage> greys;
  for (const ValueState state : kStates) {
    TileText text = depth();  // the same words, so that only the state differs
    text.state = state;
    greys.push_back(picture_of(text, colours).convertToFormat(QImage::Format_Grayscale8));
  }
  TileText simulated = depth(), replayed = depth(), manual = depth();
  simulated.simulated = replayed.replay = manual.manual = true;
  for (const auto& text : {simulated, replayed, manual})
    greys.push_back(picture_of(text, colours).convertToFormat(QImage::Format_Grayscale8));
  for (std::size_t a = 0; a < greys.size(); ++a)
    for (std::size_t b = a + 1; b < greys.size(); ++b) {
      int apart = 0;
      for (int y = 0; y < greys[a].height(); ++y)
        for (int x = 0; x < greys[a].width(); ++x)
          apart += std::abs(qGray(greys[a].pixel(x, y)) - qGray(greys[b].pixel(x, y))) > 24;
      EXPECT_GT(apart, 40) << a << " and " << b;
    }
}

TEST_F(Tiles, AStaleTileIsHatchedAndInHalfTone) {
  const QImage live = picture_of(in_state(ValueState::live), colours);
  const QImage stale = picture_of(in_state(ValueState::stale), colours);
  EXPECT_EQ(count(live, colours.of(Role::stale)), 0);
  EXPECT_GT(count(stale, colours.of(Role::stale)), 200);
  // Along a free line stripes of panel alternate with the tile.
  int changes = 0;
  for (int x = 1; x < stale.width(); ++x)
    changes += (stale.pixelColor(x, 57).lightness() < 245) != (stale.pixelColor(x - 1, 57).lightness() < 245);
  EXPECT_GT(changes, 20);
  EXPECT_EQ(count(live, colours.of(Role::bg_panel)), 0);
}

TEST_F(Tiles, ALostTileIsDashedAndHasNoValue) {
  const QImage lost = picture_of(in_state(ValueState::lost), colours);
  const QRgb edge = colours.of(Role::line_strong).rgb();
  int on = 0, changes = 0;
  for (int x = 1; x < lost.width(); ++x) {
    const bool dark = lost.pixel(x, 0) == edge;
    on += dark;
    changes += dark != (lost.pixel(x - 1, 0) == edge);
  }
  EXPECT_GT(on, 80);
  EXPECT_LT(on, 200);
  EXPECT_GT(changes, 40);
  TileText other = in_state(ValueState::lost);
  other.value = "9999.9";
  EXPECT_EQ(picture_of(other, colours), lost);
}

TEST_F(Tiles, AnAlertHasTwoPixelsOfEdgeAndItsValueInItsColour) {
  const QImage alert = picture_of(in_state(ValueState::alert), colours);
  const QColor mark = colours.of(Role::alarm_mark);
  for (const int y : {0, 1, 59, 60}) EXPECT_EQ(alert.pixelColor(120, y).name(), mark.name()) << y;
  EXPECT_NE(alert.pixelColor(120, 2).name(), mark.name());
  EXPECT_GT(count(alert, mark, QRect(10, 24, 60, 26)), 100);
}

TEST_F(Tiles, ADisagreeingTileHasFourPixelsOfCautionAtItsLeft) {
  const QImage tile = picture_of(in_state(ValueState::disagree), colours);
  for (const int x : {0, 1, 2, 3})
    EXPECT_EQ(tile.pixelColor(x, 30).name(), colours.of(Role::caution_icon).name());
  EXPECT_EQ(tile.pixelColor(120, 0).name(), colours.of(Role::caution_mark).name());
}

TEST_F(Tiles, SimulatedAndRecordedShowOnTopOfEveryState) {
  for (const ValueState state : kStates) {
    TileText text = in_state(state);
    text.simulated = true;
    EXPECT_GT(count(picture_of(text, colours), colours.of(Role::sim)), 200) << static_cast<int>(state);
    text = in_state(state);
    text.replay = true;
    const QImage tile = picture_of(text, colours);
    EXPECT_EQ(count(tile, colours.of(Role::replay), QRect(0, 0, 3, kTileHeight)), 3 * kTileHeight)
        << static_cast<int>(state);
  }
}

// The parts of a tile keep to themselves: with the widest texts no two of them touch.
TEST_F(Tiles, TheWidestTextsDoNotOverlap) {
  for (const int width : {116, 158, 192, 234}) {
    const bool small = width < 170;
    const QSize size(width, small ? kSmallTileHeight : kTileHeight);
    TileText widest = depth();
    widest.value = small ? "−179.9" : "11034.2";
    widest.sigma = small ? "9.9" : "99.9";
    const TileStyle style{small ? 18 : 28, false};
    TileText without = widest, alone = widest;
    without.sigma.clear();
    alone.value.clear();
    // Ink of the value and unit ends before the ink of sigma begins.
    const QImage both = picture_of(widest, colours, size, style);
    int value_end = 0, sigma_begin = width;
    const QImage no_sigma = picture_of(without, colours, size, style);
    for (int x = 0; x < width; ++x)
      for (int y = 20; y < size.height(); ++y)
        if (both.pixel(x, y) != no_sigma.pixel(x, y)) sigma_begin = std::min(sigma_begin, x);
    widest.value = small ? "−179.9" : "11034.2";
    for (int x = 0; x < sigma_begin; ++x)
      for (int y = 24; y < size.height() - 4; ++y)
        if (both.pixelColor(x, y).lightness() < 180) value_end = x;
    EXPECT_LT(value_end + 4, sigma_begin) << width;
    EXPECT_LT(sigma_begin, width - 20) << width;
  }
}

TEST_F(Tiles, TheSignHasItsOwnPlaceSoThatDigitsStandStill) {
  TileText plus = *test::vehicle().roll, minus = plus;
  plus.value = "+8.8";
  minus.value = "−8.8";
  const QSize size(116, kSmallTileHeight);
  const QImage a = picture_of(plus, colours, size, {18, false}),
               b = picture_of(minus, colours, size, {18, false});
  const int digits = static_cast<int>(std::ceil(10 + 0.65 * 18));
  for (int y = 0; y < size.height(); ++y)
    for (int x = digits; x < size.width(); ++x) ASSERT_EQ(a.pixel(x, y), b.pixel(x, y)) << x << "," << y;
}

TEST_F(Tiles, AreReadAloudInWords) {
  EXPECT_EQ(spoken(depth()).toStdString(), "Depth 1512.4 metres, sigma 0.3, age 0.2 s, live");
  TileText lost = in_state(ValueState::lost);
  lost.replay = true;
  EXPECT_EQ(spoken(lost).toStdString(),
            "Depth unknown, age 2:41, lost, recorded, last 1512.4 m at 13:59:56 Z");
  TileText pitch = *test::vehicle().pitch;
  EXPECT_EQ(spoken(pitch).toStdString(), "Pitch minus 1.6 degrees, sigma 0.1, age 0.1 s, live");
  ValueTile widget;
  widget.set(depth());
  EXPECT_EQ(widget.accessibleName(), spoken(depth()));
  EXPECT_TRUE(explained(depth()).contains(QStringLiteral("from press")));
}

}  // namespace
}  // namespace leadline::ui
