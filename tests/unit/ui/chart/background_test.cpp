#include "ui/chart/background.h"

#include <gtest/gtest.h>

#include <QCoreApplication>
#include <QElapsedTimer>
#include <QFile>
#include <QImage>
#include <QThread>
#include <cmath>

#include "tests/support/files.h"

namespace leadline::ui {
namespace {

const std::string kCharts = LEADLINE_BINARY_DIR "/charts";

Geodetic at(double lat_deg, double lon_deg) { return {Angle::deg(lat_deg), Angle::deg(lon_deg)}; }
std::string chart_path(const std::string& name) { return test::data_path("map_tiles/" + name); }

// processEvents() with a time does not wait: it would take the workers their processor.
void wait_a_little() {
  QThread::msleep(5);
  QCoreApplication::processEvents();
}

QImage painted(Background& background, const ChartView& view, const Colours& colours) {
  QImage image(view.size(), QImage::Format_RGB32);
  image.fill(0);
  QPainter painter(&image);
  background.paint(painter, view, image.rect(), colours);
  return image;
}

// Painted until nothing is outstanding.
QImage settled(Background& background, const ChartView& view,
               const Colours& colours = Colours(Palette::day)) {
  QElapsedTimer timer;
  timer.start();
  QImage image = painted(background, view, colours);
  while (!background.settled() && timer.elapsed() < 30'000) {
    wait_a_little();
    image = painted(background, view, colours);
  }
  EXPECT_TRUE(background.settled());
  return painted(background, view, colours);
}

QRgb at_place(const QImage& image, const ChartView& view, Geodetic place) {
  const QPoint p = view.to_screen(place).toPoint();
  EXPECT_TRUE(image.rect().contains(p)) << p.x() << " " << p.y();
  return image.pixel(p);
}

// Relative luminance, IEC 61966-2-1.
double luminance(QRgb rgb) {
  const auto linear = [](int byte) {
    const double c = byte / 255.0;
    return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
  };
  return 0.2126 * linear(qRed(rgb)) + 0.7152 * linear(qGreen(rgb)) + 0.0722 * linear(qBlue(rgb));
}

double share_of(const QImage& image, QRgb colour) {
  qint64 count = 0;
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) count += image.pixel(x, y) == colour ? 1 : 0;
  }
  return static_cast<double>(count) / (static_cast<double>(image.width()) * image.height());
}

/// Land is loaded once for all tests; each begins without charts.
class BackgroundWithLand : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    shared_ = new Background;
    shared_->load_coastline(kCharts);
  }
  static void TearDownTestSuite() {
    delete shared_;
    shared_ = nullptr;
  }
  void SetUp() override { background.set_charts({}); }

  Background& background = *shared_;

 private:
  static inline Background* shared_ = nullptr;
};

TEST(Tone, FollowsItsLawOnOpaqueAndTranslucentPixels) {
  const Tone tone{0.47, 0.95, {0.86, 0.99, 1.10}};
  QImage image(2, 1, QImage::Format_ARGB32_Premultiplied);
  image.setPixel(0, 0, qRgba(200, 100, 50, 255));
  image.setPixel(1, 0, qRgba(0, 0, 0, 0));
  apply_tone(tone, image);
  const double y = 0.2126 * 200 + 0.7152 * 100 + 0.0722 * 50;
  const QRgb p = image.pixel(0, 0);
  EXPECT_NEAR(qRed(p), (y + (200 - y) * 0.95) * 0.47 * 0.86, 0.51);
  EXPECT_NEAR(qGreen(p), (y + (100 - y) * 0.95) * 0.47 * 0.99, 0.51);
  EXPECT_NEAR(qBlue(p), (y + (50 - y) * 0.95) * 0.47 * 1.10, 0.51);
  EXPECT_EQ(image.pixel(1, 0), 0u);
}

TEST(Tone, NightKeepsEveryPixelBelowItsLimit) {
  const Tone tone = base_tone(Colours(Palette::night));
  for (const int r : {0, 128, 255}) {
    for (const int g : {0, 128, 255}) {
      for (const int b : {0, 128, 255}) {
        QImage image(1, 1, QImage::Format_ARGB32_Premultiplied);
        image.setPixel(0, 0, qRgba(r, g, b, 255));
        apply_tone(tone, image);
        EXPECT_LE(luminance(image.pixel(0, 0)), 0.03) << r << " " << g << " " << b;
      }
    }
  }
}

TEST(Tone, DayLeavesPixelsAlone) { EXPECT_EQ(base_tone(Colours(Palette::day)), Tone{}); }

TEST(Background, IsWaterBeforeAnythingIsLoaded) {
  Background background;
  const ChartView view(at(36.9, 129.9), {200, 100}, 1000.0);
  const Colours colours(Palette::day);
  EXPECT_DOUBLE_EQ(share_of(painted(background, view, colours), colours.of(Role::sea_deep).rgb()), 1.0);
  EXPECT_TRUE(background.settled());
  EXPECT_TRUE(background.layers().empty());
}

TEST_F(BackgroundWithLand, LandIsLandAndSeaIsSeaInEveryPalette) {
  const ChartView view(at(36.9, 129.9), {800, 600}, 1000.0);
  for (const Palette palette : {Palette::day, Palette::dusk, Palette::night}) {
    const Colours colours(palette);
    const QImage image = settled(background, view, colours);
    EXPECT_EQ(at_place(image, view, at(36.5, 128.0)), colours.of(Role::land).rgb());
    EXPECT_EQ(at_place(image, view, at(35.0, 133.0)), colours.of(Role::land).rgb());
    EXPECT_EQ(at_place(image, view, at(38.0, 131.5)), colours.of(Role::sea_deep).rgb());
    EXPECT_EQ(at_place(image, view, at(37.5, 130.0)), colours.of(Role::sea_deep).rgb());
  }
}

TEST_F(BackgroundWithLand, CoastLineIsDrawnInItsColour) {
  const ChartView view(at(36.9, 129.9), {800, 600}, 500.0);
  const Colours colours(Palette::day);
  const QImage image = settled(background, view, colours);
  const QRgb coast = colours.of(Role::coast).rgb();
  int close = 0;
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) {
      const QRgb p = image.pixel(x, y);
      close += std::abs(qRed(p) - qRed(coast)) + std::abs(qGreen(p) - qGreen(coast)) +
                   std::abs(qBlue(p) - qBlue(coast)) <
               60;
    }
  }
  EXPECT_GT(close, 150);
}

TEST_F(BackgroundWithLand, ThinStripsMakeTheSamePicture) {
  background.set_charts({chart_path("RGB.byte.tif")});
  const ChartView view(at(24.5, -77.8), {640, 480}, 700.0, Angle::deg(30.0));
  const Colours colours(Palette::dusk);
  const QImage whole = settled(background, view, colours);
  QImage strips(view.size(), QImage::Format_RGB32);
  QPainter painter(&strips);
  for (int x = 0; x < 640; x += 16) background.paint(painter, view, QRect(x, 0, 16, 480), colours);
  painter.end();
  int different = 0;
  for (int y = 0; y < 480; ++y) {
    for (int x = 0; x < 640; ++x) {
      const QRgb a = whole.pixel(x, y), b = strips.pixel(x, y);
      different += std::abs(qRed(a) - qRed(b)) > 24 || std::abs(qGreen(a) - qGreen(b)) > 24;
    }
  }
  EXPECT_LT(different, 640 * 480 / 1000);
}

TEST_F(BackgroundWithLand, PaintsNothingOutsideWhatIsExposed) {
  background.set_charts({chart_path("world.rgb.tif")});
  const ChartView view(at(36.9, 129.9), {300, 300}, 2000.0);
  settled(background, view);
  QImage image(300, 300, QImage::Format_RGB32);
  image.fill(0xFF123456);
  QPainter painter(&image);
  background.paint(painter, view, QRect(100, 100, 50, 20), Colours(Palette::day));
  painter.end();
  for (int y = 0; y < 300; ++y) {
    for (int x = 0; x < 300; ++x) {
      if (QRect(100, 100, 50, 20).contains(x, y)) continue;
      ASSERT_EQ(image.pixel(x, y), 0xFF123456) << x << " " << y;
    }
  }
}

TEST_F(BackgroundWithLand, CoastLineHidesWhereItIsTooCoarse) {
  const Colours colours(Palette::day);
  const ChartView close(at(36.5, 128.0), {200, 200}, Background::kFinestCoastline_m_per_px * 0.99);
  EXPECT_DOUBLE_EQ(share_of(settled(background, close, colours), colours.of(Role::sea_deep).rgb()), 1.0);
  ASSERT_EQ(background.layers().size(), 1u);
  EXPECT_EQ(background.layers()[0].name, "Coastline 1:50 000 000");
  EXPECT_EQ(background.layers()[0].state, LayerLine::State::hidden);
  EXPECT_EQ(background.layers()[0].detail, "hidden, too coarse at this scale");
  const ChartView wide(at(36.5, 128.0), {200, 200}, Background::kFinestCoastline_m_per_px);
  EXPECT_GT(share_of(settled(background, wide, colours), colours.of(Role::land).rgb()), 0.9);
  EXPECT_EQ(background.layers()[0].state, LayerLine::State::ok);
}

TEST_F(BackgroundWithLand, AntipodeDoesNotFloodTheSea) {
  const Colours colours(Palette::day);
  const ChartView spain(at(40.5, -4.5), {1000, 800}, 5000.0);  // New Zealand is at its antipode
  const QImage image = settled(background, spain, colours);
  EXPECT_EQ(at_place(image, spain, at(40.5, -4.0)), colours.of(Role::land).rgb());
  EXPECT_EQ(at_place(image, spain, at(45.0, -8.0)), colours.of(Role::sea_deep).rgb());
  EXPECT_EQ(at_place(image, spain, at(40.0, -25.0)), colours.of(Role::sea_deep).rgb());
  EXPECT_EQ(at_place(image, spain, at(24.0, 5.0)), colours.of(Role::land).rgb());
  const double sea = share_of(image, colours.of(Role::sea_deep).rgb());
  EXPECT_GT(sea, 0.35);
  EXPECT_LT(sea, 0.7);
}

TEST_F(BackgroundWithLand, FijiLiesWholeOnTheDateLine) {
  const Colours colours(Palette::day);
  for (const double lon : {179.9, -179.9}) {
    const ChartView view(at(-17.3, lon), {800, 600}, 800.0);
    const QImage image = settled(background, view, colours);
    EXPECT_EQ(at_place(image, view, at(-17.8, 178.0)), colours.of(Role::land).rgb());  // Viti Levu
    EXPECT_EQ(at_place(image, view, at(-16.6, 179.2)), colours.of(Role::land).rgb());  // Vanua Levu
    EXPECT_EQ(at_place(image, view, at(-18.5, 180.0)), colours.of(Role::sea_deep).rgb());
    EXPECT_EQ(at_place(image, view, at(-17.5, -179.5)), colours.of(Role::sea_deep).rgb());
    // The line itself crosses open water without a trace.
    for (double lat = -19.0; lat < -17.2; lat += 0.05) {
      EXPECT_EQ(at_place(image, view, at(lat, 180.0)), colours.of(Role::sea_deep).rgb()) << lat;
    }
  }
}

TEST_F(BackgroundWithLand, DrawsAt89North) {
  background.set_charts({chart_path("world.rgb.tif")});
  const Colours colours(Palette::day);
  const ChartView view(at(89.0, 30.0), {600, 600}, 4000.0);
  settled(background, view, colours);
  background.show_chart(chart_path("world.rgb.tif"), false);
  const QImage land = settled(background, view, colours);
  EXPECT_EQ(at_place(land, view, at(90.0, 0.0)), colours.of(Role::sea_deep).rgb());
  EXPECT_EQ(at_place(land, view, at(81.5, -40.0)), colours.of(Role::land).rgb());  // Greenland
  background.show_chart(chart_path("world.rgb.tif"), true);
  const QImage both = settled(background, view, colours);
  EXPECT_LT(share_of(both, colours.of(Role::sea_deep).rgb()), 1e-4);  // the raster covers the pole too
}

TEST(Background, RasterCoversTheSeaWithItsOwnPixels) {
  Background background;
  background.set_charts({chart_path("RGB.byte.tif")});
  const Colours colours(Palette::day);
  const ChartView view(at(24.5, -77.75), {400, 400}, 256.0);
  const QImage image = settled(background, view, colours);
  EXPECT_LT(share_of(image, colours.of(Role::sea_deep).rgb()), 0.01);
  // The same place read by hand at the same resolution.
  const auto chart = maps::RasterChart::open(chart_path("RGB.byte.tif")).value();
  for (const QPoint p : {QPoint(200, 200), QPoint(120, 300), QPoint(333, 41)}) {
    const maps::PlanePoint corner = view.to_plane(p);
    const maps::PlaneBox box{corner.east_m, corner.north_m - 256.0, corner.east_m + 256.0, corner.north_m};
    const QRgb expected = chart.read(box, view.projection().definition(), 1, 1).value().argb[0];
    const QRgb actual = image.pixel(p);
    EXPECT_NEAR(qRed(actual), qRed(expected), 3);
    EXPECT_NEAR(qGreen(actual), qGreen(expected), 3);
    EXPECT_NEAR(qBlue(actual), qBlue(expected), 3);
  }
}

TEST(Background, TurnedChartShowsTheSamePlaceUnderTheSameSymbol) {
  Background background;
  background.set_charts({chart_path("world.rgb.tif")});
  const Colours colours(Palette::day);
  const ChartView north_up(at(30.0, 0.0), {600, 600}, 5000.0);
  const ChartView turned(at(30.0, 0.0), {600, 600}, 5000.0, Angle::deg(70.0));
  const QImage a = settled(background, north_up, colours), b = settled(background, turned, colours);
  for (const Geodetic place : {at(23.0, 5.0), at(40.0, -3.5), at(31.0, -12.0), at(35.0, 6.0)}) {
    const QRgb p = at_place(a, north_up, place), q = at_place(b, turned, place);
    EXPECT_NEAR(qRed(p), qRed(q), 20) << place.lat.deg();
    EXPECT_NEAR(qGreen(p), qGreen(q), 20) << place.lat.deg();
    EXPECT_NEAR(qBlue(p), qBlue(q), 20) << place.lat.deg();
  }
}

TEST(Background, NightDimsRastersBelowTheLimitAtOnce) {
  Background background;
  background.set_charts({chart_path("RGB.byte.tif")});
  const ChartView view(at(24.5, -77.75), {300, 300}, 512.0);
  settled(background, view, Colours(Palette::day));
  const Colours night(Palette::night);
  const auto brightest = [](const QImage& image) {
    double most = 0.0;
    for (int y = 0; y < image.height(); ++y) {
      for (int x = 0; x < image.width(); ++x) most = std::max(most, luminance(image.pixel(x, y)));
    }
    return most;
  };
  EXPECT_LE(brightest(painted(background, view, night)), 0.03);  // not one picture in day's colours
  const QImage image = settled(background, view, night);
  EXPECT_LE(brightest(image), 0.03);
  EXPECT_LT(share_of(image, night.of(Role::sea_deep).rgb()), 0.5);
}

TEST(Background, TilesThatArriveAreTold) {
  Background background;
  background.set_charts({chart_path("RGB.byte.tif")});
  const ChartView view(at(24.5, -77.75), {300, 300}, 512.0);
  int parts = 0, layers = 0;
  QObject::connect(&background, &Background::changed, [&](QRectF box) { parts += box.isNull() ? 0 : 1; });
  QObject::connect(&background, &Background::layersChanged, [&] { ++layers; });
  settled(background, view);
  EXPECT_GE(parts, 2);
  EXPECT_GE(layers, 1);
}

TEST_F(BackgroundWithLand, NewPlaneIsFilledFromTheOneBeforeUntilItsTilesAreThere) {
  background.set_charts({chart_path("world.rgb.tif")});
  const Colours colours(Palette::day);
  ChartView view(at(30.0, 0.0), {400, 400}, 5000.0);
  settled(background, view, colours);
  const Geodetic place = at(27.0, 4.0);
  const QRgb before = at_place(painted(background, view, colours), view, place);
  view.centre_on(at(30.6, 0.5));
  ASSERT_NE(view.projection().origin(), at(30.0, 0.0));
  const QImage first = painted(background, view, colours);
  const QRgb stand_in = at_place(first, view, place);
  EXPECT_NEAR(qRed(before), qRed(stand_in), 16);
  EXPECT_NEAR(qGreen(before), qGreen(stand_in), 16);
  const QRgb after = at_place(settled(background, view, colours), view, place);
  EXPECT_NEAR(qRed(before), qRed(after), 16);
}

TEST(Background, CoarserTilesStandInWhileFinerOnesLoad) {
  Background background;
  background.set_charts({chart_path("RGB.byte.tif")});
  const Colours colours(Palette::day);
  settled(background, ChartView(at(24.5, -77.75), {300, 300}, 1024.0), colours);
  const ChartView finer(at(24.5, -77.75), {300, 300}, 256.0);
  const QImage first = painted(background, finer, colours);
  EXPECT_FALSE(background.settled());
  EXPECT_LT(share_of(first, colours.of(Role::sea_deep).rgb()), 0.05);
}

TEST(Background, BrokenChartIsALayerWithItsSentence) {
  Background background;
  background.set_charts(
      {chart_path("world.rgb.tif"), chart_path("corrupt.mbtiles"), chart_path("world_cities.mbtiles")});
  const ChartView view(at(30.0, 0.0), {200, 200}, 5000.0);
  ASSERT_EQ(background.layers().size(), 3u);
  EXPECT_EQ(background.layers()[0].state, LayerLine::State::loading);
  const QImage image = settled(background, view);
  const auto lines = background.layers();
  ASSERT_EQ(lines.size(), 3u);
  EXPECT_EQ(lines[0].name, "world_cities.mbtiles");
  EXPECT_EQ(lines[0].state, LayerLine::State::broken);
  EXPECT_NE(lines[0].detail.find("vector"), std::string::npos);
  EXPECT_EQ(lines[1].state, LayerLine::State::broken);
  EXPECT_NE(lines[1].detail.find("damaged"), std::string::npos);
  EXPECT_FALSE(lines[1].remedy.empty());
  EXPECT_EQ(lines[2].state, LayerLine::State::ok);
  EXPECT_EQ(lines[2].detail, "78 km · accuracy unknown");
  EXPECT_FALSE(lines[2].accuracy_known);
  EXPECT_LT(share_of(image, Colours(Palette::day).of(Role::sea_deep).rgb()), 0.01);  // the good one is drawn
}

TEST(Background, MissingCoastLineIsALayerWithItsSentence) {
  Background background;
  background.load_coastline("/nowhere");
  settled(background, ChartView(at(30.0, 0.0), {100, 100}, 5000.0));
  ASSERT_EQ(background.layers().size(), 1u);
  EXPECT_EQ(background.layers()[0].state, LayerLine::State::broken);
  EXPECT_EQ(background.layers()[0].detail, "there is no coast line");
  EXPECT_FALSE(background.layers()[0].remedy.empty());
}

TEST(Background, GoesAwayWhileItLoads) {
  for (int i = 0; i < 5; ++i) {
    Background background;
    background.load_coastline(kCharts);
    background.set_charts({chart_path("RGB.byte.tif"), chart_path("plain_1.mbtiles")});
    painted(background, ChartView(at(24.5, -77.75), {800, 800}, 300.0), Colours(Palette::day));
    QCoreApplication::processEvents(QEventLoop::AllEvents, 10 * i);
    painted(background, ChartView(at(24.5, -77.75), {800, 800}, 300.0), Colours(Palette::day));
  }
  QCoreApplication::processEvents();
}

TEST_F(BackgroundWithLand, OverviewShowsTheCoastWithCrossHairAndFrame) {
  const Colours colours(Palette::day);
  settled(background, ChartView(at(36.9, 129.9), {100, 100}, 1000.0));
  QImage image(220, 156, QImage::Format_RGB32);
  const auto paint = [&] {
    QPainter painter(&image);
    background.paint_overview(painter, image.rect(), at(36.9, 129.9), 10e6 * 0.0254 / 96.0, colours);
  };
  int told = 0;
  QObject::connect(&background, &Background::overviewChanged, [&] { ++told; });
  paint();
  QElapsedTimer timer;
  timer.start();
  while (told == 0 && timer.elapsed() < 30'000) wait_a_little();
  ASSERT_EQ(told, 1);
  paint();
  EXPECT_EQ(image.pixel(0, 0), colours.of(Role::ship).rgb());
  EXPECT_EQ(image.pixel(219, 155), colours.of(Role::ship).rgb());
  EXPECT_EQ(image.pixel(30, 78), colours.of(Role::ship).rgb());
  EXPECT_EQ(image.pixel(110, 30), colours.of(Role::ship).rgb());
  EXPECT_EQ(image.pixel(110 - 40, 78 - 10), colours.of(Role::land).rgb());  // 105 km west, 26 km north
  EXPECT_EQ(image.pixel(110 + 40, 78 - 10), colours.of(Role::sea_mid).rgb());
}

}  // namespace
}  // namespace leadline::ui
