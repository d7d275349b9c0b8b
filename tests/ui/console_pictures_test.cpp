// Golden pictures of the whole console, and what the palettes promise of them.

#include <gtest/gtest.h>

#include "tests/support/picture.h"
#include "tests/ui/shown.h"

namespace leadline::ui {
namespace {

/// Inside the raster of the tests: east of Nassau.
const Geodetic kBahamas{Angle::deg(25.1), Angle::deg(-77.2)};

struct Case {
  const char* name;
  Palette palette;
  QSize size;
  bool replay, raster;
};

QImage console_picture(const Case& c, Colours* colours = nullptr) {
  Look::current().set(c.palette);
  if (colours != nullptr) *colours = Look::current().colours();
  test::HandMade made = test::hand_made(c.raster ? kBahamas : test::kEastSea);
  made.snapshot.replay = c.replay;
  Background background;
  background.load_coastline(LEADLINE_CHARTS);
  if (c.raster) background.set_charts({LEADLINE_TEST_DATA "/map_tiles/RGB.byte.tif"});
  ConsoleWindow window;
  window.resize(c.size);
  window.chart().set_background(&background);
  window.set_history(&made.history, 0);
  window.chart().set_metres_per_px(c.raster ? 60.0 : 0.7);
  window.chart().set_centre(made.snapshot.vehicle->solution.position);
  window.show_snapshot(made.snapshot);
  window.freeze();
  window.show();
  window.setFocus();
  return test::picture_of(window, window.chart());
}

class ConsolePicture : public testing::TestWithParam<Case> {};

TEST_P(ConsolePicture, IsTheGoldenOne) { test::expect_picture(console_picture(GetParam()), GetParam().name); }

INSTANTIATE_TEST_SUITE_P(
    All, ConsolePicture,
    testing::Values(Case{"console_day", Palette::day, {1920, 1080}, false, false},
                    Case{"console_dusk", Palette::dusk, {1920, 1080}, false, false},
                    Case{"console_night", Palette::night, {1920, 1080}, false, false},
                    Case{"console_replay_dusk", Palette::dusk, {1920, 1080}, true, false},
                    Case{"console_raster_day", Palette::day, {1280, 800}, false, true},
                    Case{"console_raster_night", Palette::night, {1280, 800}, false, true},
                    Case{"console_replay_night", Palette::night, {1280, 800}, true, false},
                    Case{"console_small_day", Palette::day, {800, 600}, false, false},
                    Case{"console_small_dusk", Palette::dusk, {800, 600}, true, false},
                    Case{"console_small_night", Palette::night, {800, 600}, true, false}),
    [](const auto& made) { return std::string(made.param.name); });

TEST(ConsolePalette, NightKeepsItsLimits) {
  for (const bool raster : {false, true}) {
    const QImage picture = console_picture({"", Palette::night, {1920, 1080}, false, raster});
    double mean = 0.0, most = 0.0;
    for (int y = 0; y < picture.height(); ++y)
      for (int x = 0; x < picture.width(); ++x) {
        const double l = test::luminance(picture.pixel(x, y));
        mean += l;
        most = std::max(most, l);
      }
    mean /= static_cast<double>(picture.width()) * picture.height();
    std::printf("night%s: mean luminance %.4f, highest %.3f\n", raster ? " over a raster" : "", mean, most);
    EXPECT_LE(mean, 0.020);
    EXPECT_LE(most, 0.305);
  }
}

TEST(ConsolePalette, AReplayCannotPassForLive) {
  const QImage live = console_picture({"", Palette::day, {1920, 1080}, false, false});
  const QImage replay = console_picture({"", Palette::day, {1920, 1080}, true, false});
  EXPECT_GE(test::compare(live, replay).different_share, 0.02);
  const auto edge_differs = [&](const QRect& edge) {
    return test::compare(live.copy(edge), replay.copy(edge)).different_share > 0.3;
  };
  EXPECT_TRUE(edge_differs({0, 0, 1920, 8}));
  EXPECT_TRUE(edge_differs({0, 1072, 1920, 8}));
  EXPECT_TRUE(edge_differs({0, 0, 8, 1080}));
  EXPECT_TRUE(edge_differs({1912, 0, 8, 1080}));
}

TEST(ConsolePalette, TheDimmerDimsEverything) {
  const QImage full = console_picture({"", Palette::dusk, {1280, 800}, false, false});
  Look::current().set(Palette::dusk, 4);
  test::HandMade made = test::hand_made(test::kEastSea);
  ConsoleWindow window;
  window.resize(1280, 800);
  window.set_history(&made.history, 0);
  window.chart().set_metres_per_px(0.7);
  window.chart().set_centre(test::kEastSea);
  window.show_snapshot(made.snapshot);
  window.show();
  const QImage dim = test::picture_of(window, window.chart());
  Look::current().set(Palette::dusk);
  double before = 0.0, after = 0.0;
  for (int y = 0; y < 800; ++y)
    for (int x = 0; x < 1280; ++x)
      before += test::luminance(full.pixel(x, y)), after += test::luminance(dim.pixel(x, y));
  EXPECT_LT(after, 0.45 * before);
}

}  // namespace
}  // namespace leadline::ui
