#include "maps/charts/coastline.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <filesystem>
#include <fstream>

#include "core/geo/geodesy.h"

namespace leadline::maps {
namespace {

const std::string kFolder = LEADLINE_BINARY_DIR "/charts";

const Coastline& coastline() {
  static const Coastline loaded = load_coastline(kFolder).value();
  return loaded;
}

TEST(Coastline, LoadsAllOfTheLandWithinItsTime) {
  const auto start = std::chrono::steady_clock::now();
  const auto loaded = load_coastline(kFolder);
  const double ms =
      std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
  RecordProperty("load_ms", std::to_string(ms));
  ASSERT_TRUE(loaded) << loaded.error().line();
  std::size_t points = 0, lakes = 0;
  for (const ShoreRing& ring : loaded.value().rings) {
    points += ring.points.size();
    lakes += ring.water ? 1 : 0;
  }
  EXPECT_GT(loaded.value().rings.size(), 1'400u);
  EXPECT_GT(points, 58'000u);
  EXPECT_EQ(lakes, 1u);  // the Caspian Sea
}

TEST(Coastline, HasNoSeamAlongTheDateLineNorAroundThePole) {
  for (const ShoreRing& ring : coastline().rings) {
    const std::size_t n = ring.points.size();
    for (std::size_t i = 0; i < n; ++i) {
      const Geodetic a = ring.points[i], b = ring.points[(i + 1) % n];
      // The longest edge of the data is 650 km; a seam would be a jump of up to a half Earth.
      EXPECT_LT(geo::geodesic(a, b).distance_m, 700'000.0) << a.lat.deg() << " " << a.lon.deg();
      EXPECT_GT(a.lat.deg(), -86.0) << "Antarctica's closing edge";
      const bool along = a.lon.deg() == -180.0 && b.lon.deg() == -180.0;
      // What is left are ends of Fijian islands that the file does not carry over the date line.
      if (along) {
        EXPECT_LT(geo::geodesic(a, b).distance_m, 10'000.0) << a.lat.deg();
      }
    }
  }
}

TEST(Coastline, AntarcticaGoesOnceAroundThePole) {
  int around = 0;
  for (const ShoreRing& ring : coastline().rings) {
    double turn = 0.0;
    const std::size_t n = ring.points.size();
    for (std::size_t i = 0; i < n; ++i) {
      turn += (ring.points[(i + 1) % n].lon - ring.points[i].lon).wrapped_pi().deg();
    }
    if (std::abs(turn) > 180.0) {
      ++around;
      EXPECT_NEAR(turn, 360.0, 1e-6);  // eastward: the land on the right
      EXPECT_LT(ring.middle.lat.deg(), -75.0);
    }
  }
  EXPECT_EQ(around, 1);
}

TEST(Coastline, RingsComeByFallingReachAndReachTheirPoints) {
  double last = 10.0;
  for (const ShoreRing& ring : coastline().rings) {
    EXPECT_LE(ring.reach.rad(), last);
    last = ring.reach.rad();
  }
}

TEST(Coastline, MissingAndBrokenFilesAreRefusedInASentence) {
  const auto missing = load_coastline("/nowhere");
  ASSERT_FALSE(missing);
  EXPECT_EQ(missing.error().where, "/nowhere/ne_50m_land.json.gz");
  EXPECT_FALSE(missing.error().remedy.empty());

  const std::string folder = testing::TempDir() + "broken_coastline";
  std::filesystem::create_directories(folder);
  std::filesystem::copy_file(kFolder + "/ne_50m_land.json.gz", folder + "/ne_50m_land.json.gz",
                             std::filesystem::copy_options::overwrite_existing);
  std::filesystem::permissions(folder + "/ne_50m_land.json.gz", std::filesystem::perms::owner_all);
  std::filesystem::resize_file(folder + "/ne_50m_land.json.gz", 200'000);
  EXPECT_FALSE(load_coastline(folder));
  std::ofstream(folder + "/ne_50m_land.json.gz") << "no coast line";
  EXPECT_FALSE(load_coastline(folder));
}

}  // namespace
}  // namespace leadline::maps
