#include "maps/charts/raster_chart.h"

#include <gdal_priv.h>
#include <gdal_utils.h>
#include <ogr_spatialref.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <filesystem>

#include "core/geo/geodesy.h"
#include "core/types/time.h"
#include "maps/charts/gdal_session.h"

namespace leadline::maps {
namespace {

constexpr const char* kCopyAgain = "copy it again from where it came from";

struct OptionsFree {
  void operator()(GDALWarpAppOptions* o) const { GDALWarpAppOptionsFree(o); }
  void operator()(GDALTranslateOptions* o) const { GDALTranslateOptionsFree(o); }
};

class Words {
 public:
  void add(const std::string& word) { list_.AddString(word.c_str()); }
  template <class... More>
  void add(const std::string& word, const More&... more) {
    add(word);
    add(more...);
  }
  char** list() { return list_.List(); }

 private:
  CPLStringList list_;
};

std::optional<double> number(const char* text) {
  if (text == nullptr) return std::nullopt;
  char* end = nullptr;
  const double value = std::strtod(text, &end);
  if (end == text || !std::isfinite(value)) return std::nullopt;
  return value;
}

// "2025:08:14 10:00:00" as TIFF writes it, or ISO: the day, when it is one.
std::optional<std::string> day(const char* text) {
  if (text == nullptr) return std::nullopt;
  std::string date = std::string(text).substr(0, 10);
  std::replace(date.begin(), date.end(), ':', '-');
  if (!parse_date(date)) return std::nullopt;
  return date;
}

const char* first_of(GDALDataset& set, std::initializer_list<std::pair<const char*, const char*>> places) {
  for (const auto& [domain, key] : places) {
    if (const char* value = set.GetMetadataItem(key, domain)) return value;
  }
  return nullptr;
}

OGRSpatialReference wgs84() {
  OGRSpatialReference reference;
  reference.SetWellKnownGeogCS("WGS84");
  reference.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  return reference;
}

struct Located {
  std::array<double, 6> to_ground{};  // of pixel, line
  std::unique_ptr<OGRCoordinateTransformation> to_degrees, from_degrees;

  [[nodiscard]] std::optional<Geodetic> at(double pixel, double line) const {
    const auto& g = to_ground;
    double x = g[0] + pixel * g[1] + line * g[2], y = g[3] + pixel * g[4] + line * g[5];
    if (!to_degrees->Transform(1, &x, &y) || !std::isfinite(x) || !std::isfinite(y)) return std::nullopt;
    return Geodetic{Angle::deg(y), geo::normal_longitude(Angle::deg(x))};
  }
  [[nodiscard]] bool holds(double lat_deg, double lon_deg, int width, int height) const {
    double x = lon_deg, y = lat_deg, pixel = 0.0, line = 0.0;
    std::array<double, 6> ground = to_ground, inverse{};
    if (!from_degrees || !from_degrees->Transform(1, &x, &y) ||
        !GDALInvGeoTransform(ground.data(), inverse.data())) {
      return false;
    }
    GDALApplyGeoTransform(inverse.data(), x, y, &pixel, &line);
    return pixel >= 0.0 && pixel <= width && line >= 0.0 && line <= height;
  }
};

// Around the edge, with longitudes that run on over the date line.
std::optional<ChartInfo::Bounds> bounds_of(const Located& located, int width, int height) {
  constexpr int kSteps = 32;
  std::optional<ChartInfo::Bounds> bounds;
  std::optional<Geodetic> last;
  Angle lon;
  for (int side = 0; side < 4; ++side) {
    for (int i = 0; i < kSteps; ++i) {
      const double t = static_cast<double>(i) / kSteps;
      const double u = side == 0 ? t : side == 1 ? 1.0 : side == 2 ? 1.0 - t : 0.0;
      const double v = side == 0 ? 0.0 : side == 1 ? t : side == 2 ? 1.0 : 1.0 - t;
      const auto at = located.at(u * width, v * height);
      if (!at) continue;
      lon = last ? lon + (at->lon - last->lon).wrapped_pi() : at->lon;
      last = at;
      if (!bounds) bounds = ChartInfo::Bounds{at->lat, lon, at->lat, lon};
      bounds->south = std::min(bounds->south, at->lat);
      bounds->north = std::max(bounds->north, at->lat);
      bounds->west = std::min(bounds->west, lon);
      bounds->east = std::max(bounds->east, lon);
    }
  }
  if (!bounds) return std::nullopt;
  const bool north = located.holds(90.0, 0.0, width, height),
             south = located.holds(-90.0, 0.0, width, height);
  if (north) bounds->north = Angle::deg(90.0);
  if (south) bounds->south = Angle::deg(-90.0);
  if (north || south || (bounds->east - bounds->west).deg() >= 359.0) {
    bounds->west = Angle::deg(-180.0);
    bounds->east = Angle::deg(180.0);
  }
  while (bounds->west.deg() < -180.0 || bounds->west.deg() >= 180.0) {
    const Angle turn = Angle::deg(bounds->west.deg() < 0.0 ? 360.0 : -360.0);
    bounds->west = bounds->west + turn;
    bounds->east = bounds->east + turn;
  }
  return bounds;
}

// Whether GDAL's complaint is of the file, not of a point that has no place in the other projection.
bool of_file(const GdalSession::Failure& failure) {
  for (const char* word : {"ransform", "roject", "PROJ", "domain", "latitude", "longitude"}) {
    if (failure.text.find(word) != std::string::npos) return false;
  }
  return true;
}

std::string kind_of(GDALDataset& set) {
  const std::string driver = set.GetDriverName();
  return driver == "GTiff" ? "GeoTIFF" : driver;
}

// Colour or grey bytes with their alpha, whatever the file holds; nullptr when it is that already.
GDALDatasetUniquePtr as_colours(GDALDataset& set) {
  const int count = set.GetRasterCount();
  GDALRasterBand& first = *set.GetRasterBand(1);
  const bool bytes = first.GetRasterDataType() == GDT_Byte;
  const auto colour = [&](int band) { return set.GetRasterBand(band)->GetColorInterpretation(); };
  const bool rgb = count >= 3 && colour(1) != GCI_PaletteIndex && colour(1) != GCI_GrayIndex;
  if (bytes && rgb && (count == 3 || (count == 4 && colour(4) == GCI_AlphaBand))) return nullptr;
  Words words;
  words.add("-of", "VRT");
  if (bytes && first.GetColorTable() != nullptr) {
    words.add("-expand", "rgba");
  } else {
    for (int band = 1; band <= 3; ++band) {
      words.add("-b", std::to_string(rgb ? band : 1));
      if (bytes) continue;
      std::array<double, 2> span{0.0, 1.0};
      set.GetRasterBand(rgb ? band : 1)->ComputeRasterMinMax(TRUE, span.data());
      words.add("-scale_" + std::to_string(band), std::to_string(span[0]), std::to_string(span[1]));
      words.add("0", "255");
    }
    words.add("-b", "mask");
    words.add("-ot", "Byte", "-a_nodata", "none");
  }
  const std::unique_ptr<GDALTranslateOptions, OptionsFree> options(
      GDALTranslateOptionsNew(words.list(), nullptr));
  int misused = 0;
  GDALDatasetUniquePtr colours(
      GDALDataset::FromHandle(GDALTranslate("", GDALDataset::ToHandle(&set), options.get(), &misused)));
  if (colours) {
    for (int band = 1; band <= 4; ++band) {
      colours->GetRasterBand(band)->SetColorInterpretation(
          static_cast<GDALColorInterp>(GCI_RedBand + band - 1));
    }
  }
  return colours;
}

Result<void> check_is_file(const std::string& path) {
  std::error_code failed;
  if (!std::filesystem::exists(path, failed)) return Error{"there is no such chart", path, "check its name"};
  if (!std::filesystem::is_regular_file(path, failed))
    return Error{"this is no chart file", path, "name a file"};
  if (std::filesystem::file_size(path, failed) == 0) return Error{"the chart is empty", path, kCopyAgain};
  return {};
}

// Why GDAL would not open it as a picture.
Error refusal(const std::string& path, const GdalSession& session) {
  const std::string reason = session.first_failure("");
  const GDALDatasetUniquePtr vectors(
      GDALDataset::Open(path.c_str(), GDAL_OF_VECTOR, nullptr, nullptr, nullptr));
  if (vectors && vectors->GetLayerCount() > 0) {
    return {"the file holds vector data, which is not drawn as a chart", path,
            "export it as raster tiles (PNG, JPEG or WebP) or as a GeoTIFF"};
  }
  if (reason.empty() || reason.find("not recognized as a supported") != std::string::npos) {
    return {"the file is no raster chart that GDAL knows, or its beginning is damaged", path,
            "give a GeoTIFF or an MBTiles file, or copy it again from where it came from"};
  }
  return {"the chart is damaged: " + reason, path, kCopyAgain};
}

}  // namespace

struct RasterChart::File {
  GDALDatasetUniquePtr set;
  GDALDatasetUniquePtr colours;  // over `set`, goes first
  ChartInfo info;

  [[nodiscard]] GDALDataset& pixels() const { return colours ? *colours : *set; }
  ~File() {
    GdalSession quiet;
    colours.reset();
    set.reset();
  }
};

RasterChart::RasterChart(std::unique_ptr<File> file) : file_(std::move(file)) {}
RasterChart::RasterChart(RasterChart&&) noexcept = default;
RasterChart& RasterChart::operator=(RasterChart&&) noexcept = default;
RasterChart::~RasterChart() = default;

const ChartInfo& RasterChart::info() const { return file_->info; }

Result<RasterChart> RasterChart::open(const std::string& path) {
  if (auto is_file = check_is_file(path); !is_file) return is_file.error();
  GdalSession session;
  auto file = std::make_unique<File>();
  file->set.reset(GDALDataset::Open(path.c_str(), GDAL_OF_RASTER | GDAL_OF_VERBOSE_ERROR));
  if (!file->set) return refusal(path, session);
  GDALDataset& set = *file->set;
  const int width = set.GetRasterXSize(), height = set.GetRasterYSize();
  if (set.GetRasterCount() == 0) {
    return Error{"the file holds several pictures, none by itself", path, "give the one that is meant"};
  }
  Located located;
  const OGRSpatialReference* reference = set.GetSpatialRef();
  if (reference == nullptr || reference->IsLocal() ||
      set.GetGeoTransform(located.to_ground.data()) != CE_None) {
    return Error{
        "the picture does not say where on the Earth it lies", path,
        "georeference it (for instance gdal_translate -a_srs EPSG:4326 -a_ullr west north east south)"};
  }
  const OGRSpatialReference degrees = wgs84();
  located.to_degrees.reset(OGRCreateCoordinateTransformation(reference, &degrees));
  located.from_degrees.reset(OGRCreateCoordinateTransformation(&degrees, reference));
  const auto middle = located.to_degrees ? located.at(width / 2.0, height / 2.0) : std::nullopt;
  const auto right = middle ? located.at(width / 2.0 + 1.0, height / 2.0) : std::nullopt;
  const auto below = middle ? located.at(width / 2.0, height / 2.0 + 1.0) : std::nullopt;
  const auto bounds = middle ? bounds_of(located, width, height) : std::nullopt;
  if (!right || !below || !bounds) {
    return Error{"the chart's coordinate system cannot be brought to WGS-84: " +
                     session.first_failure("no transformation is known"),
                 path, "warp it to WGS-84 or UTM first (gdalwarp -t_srs EPSG:4326)"};
  }
  session.clear();
  file->colours = as_colours(set);

  ChartInfo& info = file->info;
  info.path = path;
  info.kind = kind_of(set);
  const char* name = first_of(set, {{"", "name"}, {"", "TIFFTAG_DOCUMENTNAME"}});
  info.name = name != nullptr && *name != '\0' ? name : std::filesystem::path(path).stem().string();
  info.cell_size_m =
      std::sqrt(geo::geodesic(*middle, *right).distance_m * geo::geodesic(*middle, *below).distance_m);
  info.date =
      day(first_of(set, {{"IMAGERY", "ACQUISITIONDATETIME"}, {"", "TIFFTAG_DATETIME"}, {"", "DATE"}}));
  info.accuracy_m = number(set.GetMetadataItem("ACCURACY_M"));
  const auto shift = number(set.GetMetadataItem("SHIFT_M")),
             bearing = number(set.GetMetadataItem("SHIFT_BEARING_DEG"));
  if (shift && bearing) info.shift = ChartInfo::Shift{*shift, Angle::deg(*bearing).wrapped_2pi()};
  info.bounds = *bounds;

  // What is cut off or scrambled often shows at the first and the last pixel only.
  for (const auto& [x, y] : {std::pair{0, 0}, std::pair{width - 1, height - 1}}) {
    double value = 0.0;
    if (set.GetRasterBand(1)->RasterIO(GF_Read, x, y, 1, 1, &value, 1, 1, GDT_Float64, 0, 0, nullptr) !=
        CE_None) {
      return Error{
          "the chart is damaged or cut off: " + session.first_failure("it cannot be read to its end"), path,
          kCopyAgain};
    }
  }
  return RasterChart(std::move(file));
}

Result<Picture> RasterChart::read(const PlaneBox& box, const std::string& projection, int width,
                                  int height) const {
  LL_EXPECT(width > 0 && height > 0 && box.east_m > box.west_m && box.north_m > box.south_m);
  GdalSession session;
  auto* memory = GetGDALDriverManager()->GetDriverByName("MEM");
  const GDALDatasetUniquePtr out(memory->Create("", width, height, 4, GDT_Byte, nullptr));
  OGRSpatialReference plane;
  LL_EXPECT(out && plane.SetFromUserInput(projection.c_str()) == OGRERR_NONE);
  std::array<double, 6> to_plane{box.west_m, (box.east_m - box.west_m) / width,    0.0, box.north_m,
                                 0.0,        -(box.north_m - box.south_m) / height};
  out->SetGeoTransform(to_plane.data());
  out->SetSpatialRef(&plane);
  for (int band = 1; band <= 4; ++band) {
    out->GetRasterBand(band)->SetColorInterpretation(static_cast<GDALColorInterp>(GCI_RedBand + band - 1));
  }
  Words words;
  words.add("-r", "bilinear", "-q");
  // The edges of a box around a pole say nothing of what lies within.
  words.add("-wo", "SAMPLE_GRID=YES", "-wo", "SOURCE_EXTRA=4");
  const std::unique_ptr<GDALWarpAppOptions, OptionsFree> options(
      GDALWarpAppOptionsNew(words.list(), nullptr));
  GDALDatasetH from = GDALDataset::ToHandle(&file_->pixels());
  int misused = 0;
  GDALWarp(nullptr, GDALDataset::ToHandle(out.get()), 1, &from, options.get(), &misused);
  const auto& failures = session.failures();
  if (const auto bad = std::find_if(failures.begin(), failures.end(), of_file); bad != failures.end()) {
    return Error{"the chart cannot be read here: " + bad->text, file_->info.path, kCopyAgain};
  }
  std::vector<std::uint8_t> rgba(static_cast<std::size_t>(width) * height * 4);
  if (out->RasterIO(GF_Read, 0, 0, width, height, rgba.data(), width, height, GDT_Byte, 4, nullptr, 4,
                    static_cast<GSpacing>(width) * 4, 1, nullptr) != CE_None) {
    return Error{"the chart cannot be drawn: " + session.first_failure("out of memory"), file_->info.path,
                 ""};
  }
  Picture picture{width, height, std::vector<std::uint32_t>(static_cast<std::size_t>(width) * height)};
  for (std::size_t i = 0; i < picture.argb.size(); ++i) {
    const std::uint32_t a = rgba[4 * i + 3];
    const auto part = [&](std::size_t band) { return (rgba[4 * i + band] * a + 127) / 255; };
    picture.argb[i] = a << 24 | part(0) << 16 | part(1) << 8 | part(2);
  }
  return picture;
}

std::optional<PlaneBox> extent_in_plane(const ChartInfo::Bounds& bounds, const LocalProjection& projection) {
  constexpr int kSteps = 16;
  const Angle width = bounds.east - bounds.west, height = bounds.north - bounds.south;
  const double most_lat = std::max(std::abs(bounds.south.deg()), std::abs(bounds.north.deg()));
  if (width.deg() > 60.0 || height.deg() > 60.0 || most_lat > 85.0) return std::nullopt;
  const Geodetic middle{(bounds.south + bounds.north) * 0.5,
                        geo::normal_longitude((bounds.west + bounds.east) * 0.5)};
  if (geo::geodesic(projection.origin(), middle).distance_m > 8'000'000.0) return std::nullopt;
  std::optional<PlaneBox> box;
  for (int side = 0; side < 4; ++side) {
    for (int i = 0; i <= kSteps; ++i) {
      const double t = static_cast<double>(i) / kSteps;
      const Angle lat = side == 0 ? bounds.south : side == 1 ? bounds.north : bounds.south + height * t;
      const Angle lon = side == 2 ? bounds.west : side == 3 ? bounds.east : bounds.west + width * t;
      const PlanePoint p = projection.forward(Geodetic{lat, geo::normal_longitude(lon)});
      if (!std::isfinite(p.east_m) || !std::isfinite(p.north_m)) return std::nullopt;
      if (!box) box = PlaneBox{p.east_m, p.north_m, p.east_m, p.north_m};
      box->west_m = std::min(box->west_m, p.east_m);
      box->east_m = std::max(box->east_m, p.east_m);
      box->south_m = std::min(box->south_m, p.north_m);
      box->north_m = std::max(box->north_m, p.north_m);
    }
  }
  // Between the points a side bulges by less than this; the origin inside needs no more.
  const double margin_m = 0.01 * std::max(box->east_m - box->west_m, box->north_m - box->south_m);
  return PlaneBox{box->west_m - margin_m, box->south_m - margin_m, box->east_m + margin_m,
                  box->north_m + margin_m};
}

}  // namespace leadline::maps
