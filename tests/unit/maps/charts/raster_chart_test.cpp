#include "maps/charts/raster_chart.h"

#include <gdal_priv.h>
#include <gtest/gtest.h>
#include <ogr_spatialref.h>

#include <chrono>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>

#include "core/geo/geodesy.h"
#include "tests/support/files.h"

namespace leadline::maps {
namespace {

std::string chart_path(const std::string& name) { return test::data_path("map_tiles/" + name); }
Geodetic at(double lat_deg, double lon_deg) { return {Angle::deg(lat_deg), Angle::deg(lon_deg)}; }
Geodetic middle(const ChartInfo::Bounds& b) {
  return {(b.south + b.north) * 0.5, geo::normal_longitude((b.west + b.east) * 0.5)};
}
int channel(std::uint32_t argb, int shift) { return static_cast<int>(argb >> shift & 0xFF); }

PlaneBox around(PlanePoint p, double half_m) {
  return {p.east_m - half_m, p.north_m - half_m, p.east_m + half_m, p.north_m + half_m};
}

std::string made_tiff(const std::string& name, const std::function<void(GDALDataset&)>& fill, int bands = 1,
                      GDALDataType type = GDT_Byte) {
  GDALAllRegister();
  const std::string path = testing::TempDir() + name;
  const GDALDatasetUniquePtr file(
      GetGDALDriverManager()->GetDriverByName("GTiff")->Create(path.c_str(), 64, 64, bands, type, nullptr));
  double ground[6] = {10.0, 0.001, 0.0, 54.0, 0.0, -0.001};
  file->SetGeoTransform(ground);
  OGRSpatialReference degrees;
  degrees.SetWellKnownGeogCS("WGS84");
  file->SetSpatialRef(&degrees);
  fill(*file);
  return path;
}

TEST(RasterChart, EveryPictureFileOpensAndDraws) {
  for (const char* name : {"RGB.byte.tif", "world.rgb.tif", "usda_naip_128_none_z2.tif",
                           "usda_naip_512_deflate_z2.tif", "geography-class-jpg.mbtiles",
                           "geography-class-webp.mbtiles", "some-empty-tiles.mbtiles", "plain_1.mbtiles"}) {
    const auto chart = RasterChart::open(chart_path(name));
    ASSERT_TRUE(chart) << chart.error().line();
    const ChartInfo& info = chart.value().info();
    EXPECT_GT(info.cell_size_m, 0.1) << name;
    EXPECT_FALSE(info.accuracy_m.has_value()) << name;  // none of them says
    EXPECT_FALSE(info.date.has_value()) << name;
    const LocalProjection plane(std::string(name) == "some-empty-tiles.mbtiles" ? at(40.0, -100.0)
                                                                                : middle(info.bounds));
    const auto start = std::chrono::steady_clock::now();
    const auto picture = chart.value().read(around({}, 128 * info.cell_size_m), plane.definition(), 256, 256);
    const double ms =
        std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
    RecordProperty(std::string("ms_") + name, std::to_string(ms));
    ASSERT_TRUE(picture) << picture.error().line();
    std::size_t drawn = 0;
    for (const auto p : picture.value().argb) drawn += p >> 24 > 0 ? 1 : 0;
    EXPECT_GT(drawn, 500u) << name;
  }
}

TEST(RasterChart, WhatIsNoPictureIsRefusedInASentence) {
  const std::string folder = testing::TempDir();
  std::ofstream(folder + "empty.tif");
  std::ofstream(folder + "words.tif") << "this is no chart";
  std::filesystem::copy_file(chart_path("RGB.byte.tif"), folder + "cut.tif",
                             std::filesystem::copy_options::overwrite_existing);
  std::filesystem::permissions(folder + "cut.tif", std::filesystem::perms::owner_all);
  std::filesystem::resize_file(folder + "cut.tif", 900'000);
  made_tiff("nowhere.tif", [](GDALDataset& set) {
    set.SetSpatialRef(nullptr);
    double none[6] = {0, 1, 0, 0, 0, 1};
    set.SetGeoTransform(none);
  });
  const std::vector<std::pair<std::string, std::string>> files{
      {chart_path("world_cities.mbtiles"), "vector data"},
      {chart_path("invalid.mbtiles"), "raster chart"},
      {chart_path("corrupt.mbtiles"), "damaged"},
      {folder + "empty.tif", "empty"},
      {folder + "words.tif", "raster chart"},
      {folder + "cut.tif", "damaged"},
      {folder + "nowhere.tif", "where on the Earth"},
      {folder + "absent.tif", "no such chart"},
      {folder, "no chart file"}};
  for (const auto& [path, word] : files) {
    testing::internal::CaptureStderr();
    const auto chart = RasterChart::open(path);
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "") << path;
    ASSERT_FALSE(chart) << path;
    EXPECT_NE(chart.error().what.find(word), std::string::npos) << chart.error().line();
    EXPECT_EQ(chart.error().where, path);
    EXPECT_FALSE(chart.error().remedy.empty()) << path;
  }
}

TEST(RasterChart, FileThatIsCutOffWhileOpenFailsToRead) {
  const std::string path = testing::TempDir() + "shrinks.tif";
  std::filesystem::copy_file(chart_path("RGB.byte.tif"), path,
                             std::filesystem::copy_options::overwrite_existing);
  std::filesystem::permissions(path, std::filesystem::perms::owner_all);
  const auto chart = RasterChart::open(path);
  ASSERT_TRUE(chart);
  std::filesystem::resize_file(path, 500'000);
  const LocalProjection plane(middle(chart.value().info().bounds));
  testing::internal::CaptureStderr();
  const auto picture = chart.value().read(around({}, 100'000.0), plane.definition(), 256, 256);
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
  ASSERT_FALSE(picture);
  EXPECT_EQ(picture.error().where, path);
}

// The pixel that GDAL itself says lies at a place, read through the plane at the file's own cell size.
TEST(RasterChart, PixelsLieWithinHalfACellOfWhereTheFilePutsThem) {
  for (const char* name : {"RGB.byte.tif", "usda_naip_512_deflate_z2.tif"}) {
    const auto chart = RasterChart::open(chart_path(name)).value();
    const GDALDatasetUniquePtr file(GDALDataset::Open(chart_path(name).c_str()));
    double ground[6];
    file->GetGeoTransform(ground);
    OGRSpatialReference degrees;
    degrees.SetWellKnownGeogCS("WGS84");
    degrees.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
    const std::unique_ptr<OGRCoordinateTransformation> to_degrees(
        OGRCreateCoordinateTransformation(file->GetSpatialRef(), &degrees));
    const int width = file->GetRasterXSize(), height = file->GetRasterYSize();
    int compared = 0, best_elsewhere = 0;
    for (int k = 1; k < 400 && compared < 8; ++k) {
      const int column = 20 + (k * 7919) % (width - 40), row = 20 + (k * 6113) % (height - 40);
      double x = ground[0] + (column + 0.5) * ground[1], y = ground[3] + (row + 0.5) * ground[5];
      ASSERT_TRUE(to_degrees->Transform(1, &x, &y));
      const Geodetic place = at(y, x);
      const LocalProjection plane(at(y + 0.01, x - 0.02));
      const double half_m = 4.5 * chart.info().cell_size_m;
      const auto picture = chart.read(around(plane.forward(place), half_m), plane.definition(), 9, 9).value();
      // Nine by nine cells around: the file's pixel must match best in the middle, not one beside it.
      std::uint8_t raw[3][9 * 9];
      for (int band = 0; band < 3; ++band) {
        ASSERT_EQ(file->GetRasterBand(band + 1)->RasterIO(GF_Read, column - 4, row - 4, 9, 9, raw[band], 9, 9,
                                                          GDT_Byte, 0, 0, nullptr),
                  CE_None);
      }
      const auto error_at = [&](int dx, int dy) {
        double sum = 0.0;
        for (int v = 2; v < 7; ++v) {
          for (int u = 2; u < 7; ++u) {
            const std::uint32_t p = picture.argb[static_cast<std::size_t>(v * 9 + u)];
            for (int band = 0; band < 3; ++band) {
              sum += std::abs(channel(p, 16 - 8 * band) - raw[band][(v + dy) * 9 + u + dx]);
            }
          }
        }
        return sum;
      };
      const double here = error_at(0, 0);
      if (error_at(1, 0) + error_at(0, 1) < 200.0) continue;  // water or no data: alike everywhere
      ++compared;
      for (const auto& [dx, dy] : {std::pair{1, 0}, {-1, 0}, {0, 1}, {0, -1}}) {
        best_elsewhere += error_at(dx, dy) < here ? 1 : 0;
      }
    }
    EXPECT_GT(compared, 5) << name;
    EXPECT_EQ(best_elsewhere, 0) << name;
  }
}

TEST(RasterChart, KnownPixelHasItsColourAndNoDataIsTransparent) {
  const auto chart = RasterChart::open(chart_path("RGB.byte.tif")).value();
  EXPECT_EQ(chart.info().kind, "GeoTIFF");
  EXPECT_EQ(chart.info().name, "RGB.byte");
  EXPECT_NEAR(chart.info().cell_size_m, 300.0, 0.3);
  EXPECT_NEAR(chart.info().bounds.west.deg(), -78.96, 0.01);
  EXPECT_NEAR(chart.info().bounds.north.deg(), 25.55, 0.01);
  EXPECT_NEAR(chart.info().bounds.east.deg(), -76.57, 0.01);
  EXPECT_NEAR(chart.info().bounds.south.deg(), 23.56, 0.05);
  const LocalProjection plane(middle(chart.info().bounds));
  // The upper left corner is no data, and beyond the picture there is nothing.
  const Geodetic corner{chart.info().bounds.north, chart.info().bounds.west};
  EXPECT_EQ(chart.read(around(plane.forward(corner), 300.0), plane.definition(), 1, 1).value().argb[0], 0u);
  EXPECT_EQ(
      chart.read(around(plane.forward(at(26.5, -80.0)), 300.0), plane.definition(), 1, 1).value().argb[0],
      0u);
}

TEST(RasterChart, WorldHasItsColoursOverTheDateLineAndThePole) {
  const auto chart = RasterChart::open(chart_path("world.rgb.tif")).value();
  EXPECT_NEAR((chart.info().bounds.east - chart.info().bounds.west).deg(), 360.0, 1e-6);
  for (const Geodetic origin : {at(-17.0, 180.0), at(67.0, -179.9), at(89.0, 30.0), at(-90.0, 0.0)}) {
    const LocalProjection plane(origin);
    const auto picture = chart.read(around({}, 2'000'000.0), plane.definition(), 256, 256);
    ASSERT_TRUE(picture) << picture.error().line();
    int holes = 0;
    for (const auto p : picture.value().argb) holes += p >> 24 == 255 ? 0 : 1;
    EXPECT_EQ(holes, 0) << origin.lat.deg();
  }
}

TEST(RasterChart, FarAwayIsTransparentNotAnError) {
  const auto chart = RasterChart::open(chart_path("RGB.byte.tif")).value();
  const LocalProjection plane(at(-24.5, 102.0));  // the antipode
  const auto picture = chart.read(around({}, 1'000'000.0), plane.definition(), 64, 64);
  ASSERT_TRUE(picture) << picture.error().line();
  for (const auto p : picture.value().argb) EXPECT_EQ(p, 0u);
}

TEST(RasterChart, SaysWhatTheFileSaysOfItself) {
  const std::string path = made_tiff("told.tif", [](GDALDataset& set) {
    set.SetMetadataItem("TIFFTAG_DATETIME", "2025:08:14 10:30:00");
    set.SetMetadataItem("ACCURACY_M", "8");
    set.SetMetadataItem("SHIFT_M", "3.2");
    set.SetMetadataItem("SHIFT_BEARING_DEG", "41");
    set.GetRasterBand(1)->Fill(77);
  });
  const auto chart = RasterChart::open(path).value();
  EXPECT_EQ(chart.info().date, "2025-08-14");
  EXPECT_EQ(chart.info().accuracy_m, 8.0);
  ASSERT_TRUE(chart.info().shift.has_value());
  EXPECT_DOUBLE_EQ(chart.info().shift->metres, 3.2);
  EXPECT_NEAR(chart.info().shift->bearing.deg(), 41.0, 1e-9);
  const LocalProjection plane(middle(chart.info().bounds));
  EXPECT_EQ(chart.read(around({}, 100.0), plane.definition(), 1, 1).value().argb[0], 0xFF4D4D4Du);
}

TEST(RasterChart, GreyPaletteAndWideSamplesBecomeColours) {
  const auto grey = made_tiff("grey.tif", [](GDALDataset& set) {
    set.GetRasterBand(1)->SetNoDataValue(255);
    set.GetRasterBand(1)->Fill(255);
    std::uint8_t half[64 * 32];
    std::fill(std::begin(half), std::end(half), std::uint8_t{100});
    ASSERT_EQ(set.GetRasterBand(1)->RasterIO(GF_Write, 0, 0, 64, 32, half, 64, 32, GDT_Byte, 0, 0, nullptr),
              CE_None);
  });
  const auto palette = made_tiff("palette.tif", [](GDALDataset& set) {
    GDALColorTable table;
    const GDALColorEntry entry{10, 200, 30, 255};
    table.SetColorEntry(3, &entry);
    set.GetRasterBand(1)->SetColorTable(&table);
    set.GetRasterBand(1)->Fill(3);
  });
  const auto depths = made_tiff(
      "depths.tif",
      [](GDALDataset& set) {
        set.GetRasterBand(1)->Fill(-1500.0);
        std::vector<float> half(64 * 32, -500.0f);
        ASSERT_EQ(set.GetRasterBand(1)->RasterIO(GF_Write, 0, 0, 64, 32, half.data(), 64, 32, GDT_Float32, 0,
                                                 0, nullptr),
                  CE_None);
      },
      1, GDT_Float32);
  const Geodetic upper = at(53.985, 10.032), lower = at(53.945, 10.032);
  const auto pixel = [](const std::string& path, Geodetic place) {
    const auto chart = RasterChart::open(path);
    EXPECT_TRUE(chart) << chart.error().line();
    const LocalProjection plane(place);
    return chart.value().read(around({}, 200.0), plane.definition(), 1, 1).value().argb[0];
  };
  EXPECT_EQ(pixel(grey, upper), 0xFF646464u);
  EXPECT_EQ(pixel(grey, lower), 0u);
  EXPECT_EQ(pixel(palette, upper), 0xFF0AC81Eu);
  EXPECT_EQ(pixel(depths, upper), 0xFFFFFFFFu);
  EXPECT_EQ(pixel(depths, lower), 0xFF000000u);
}

TEST(RasterChart, ExtentInAPlaneHoldsTheChart) {
  const auto chart = RasterChart::open(chart_path("RGB.byte.tif")).value();
  const LocalProjection plane(at(24.0, -77.0));
  const auto box = extent_in_plane(chart.info().bounds, plane);
  ASSERT_TRUE(box.has_value());
  EXPECT_LT(box->east_m - box->west_m, 1.1 * 791 * 300.0);
  for (const Geodetic corner : {Geodetic{chart.info().bounds.south, chart.info().bounds.west},
                                Geodetic{chart.info().bounds.north, chart.info().bounds.east}}) {
    const PlanePoint p = plane.forward(corner);
    EXPECT_TRUE(p.east_m > box->west_m && p.east_m < box->east_m && p.north_m > box->south_m &&
                p.north_m < box->north_m);
  }
  EXPECT_FALSE(extent_in_plane(RasterChart::open(chart_path("world.rgb.tif")).value().info().bounds, plane));
}

}  // namespace
}  // namespace leadline::maps
