#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/types/position.h"
#include "core/types/result.h"
#include "maps/charts/local_projection.h"
#include "maps/layers/plane.h"

namespace leadline::maps {

/// What a chart, an image or a set of tiles says of itself. What the file does not state stays empty: an
/// accuracy is never guessed.
struct ChartInfo {
  std::string name;  ///< the file's own, else its file name without ending
  std::string path;
  std::string kind;                  ///< "GeoTIFF", "MBTiles", ...
  double cell_size_m = 0.0;          ///< on the ground, in the middle of the chart
  std::optional<std::string> date;   ///< "2025-08-14", as much of it as is stated
  std::optional<double> accuracy_m;  ///< metadata ACCURACY_M
  struct Shift {
    double metres;
    Angle bearing;
  };
  std::optional<Shift> shift;  ///< already in the file's position; metadata SHIFT_M, SHIFT_BEARING_DEG
  /// east - west in [0, 360] deg, east above 180 deg where the chart lies over the date line.
  struct Bounds {
    Angle south, west, north, east;
  };
  Bounds bounds;
};

/// Premultiplied ARGB, rows from the top; fully transparent where the chart has nothing.
struct Picture {
  int width = 0, height = 0;
  std::vector<std::uint32_t> argb;
};

/// A georeferenced raster file: GeoTIFF, MBTiles of pictures, whatever GDAL tells apart by content. Colour
/// and grey pass as they are, a palette is looked up, wider samples are stretched to what they span.
/// Belongs to one thread; each thread opens its own.
class RasterChart {
 public:
  /// Fails with a sentence for what is missing, broken, no picture (vector tiles) or without position.
  [[nodiscard]] static Result<RasterChart> open(const std::string& path);
  RasterChart(RasterChart&&) noexcept;
  RasterChart& operator=(RasterChart&&) noexcept;
  ~RasterChart();

  [[nodiscard]] const ChartInfo& info() const;
  /// The part of a plane (LocalProjection::definition()) that `box` names, north up, from the overview that
  /// suffices; bilinear. Within half a cell of the file's own positions. Fails when the file cannot be read
  /// there.
  [[nodiscard]] Result<Picture> read(const PlaneBox& box, const std::string& projection, int width,
                                     int height) const;

 private:
  struct File;
  explicit RasterChart(std::unique_ptr<File> file);
  std::unique_ptr<File> file_;
};

/// Where a chart lies in a plane, a box around it; empty when it is so large or far away that no box says.
[[nodiscard]] std::optional<PlaneBox> extent_in_plane(const ChartInfo::Bounds& bounds,
                                                      const LocalProjection& projection);

}  // namespace leadline::maps
