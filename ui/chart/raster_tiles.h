#pragma once

#include <QImage>
#include <QObject>
#include <QPainter>
#include <deque>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "maps/charts/raster_chart.h"
#include "ui/chart/chart_view.h"
#include "ui/chart/tile_workers.h"
#include "ui/look/colours.h"

namespace leadline::ui {

/// A tone applied to premultiplied pixels in place; transparent stays transparent. Luma as in ITU-R BT.709.
void apply_tone(const Tone& tone, QImage& image);

/// From one plane to another for the moment until the right tiles are there: true about one place, off with
/// the square of the distance from it. Origins 50 km apart: 77 m at 500 km, 4 km at 3600 km; 200 km apart:
/// four times that. Empty when an origin lies over 300 km from the place.
[[nodiscard]] std::optional<QTransform> between_planes(const maps::LocalProjection& from,
                                                       const maps::LocalProjection& to, Geodetic about);

/// Raster charts as tiles, read by workers and kept toned. What is not there yet is shown from coarser or
/// finer tiles, or from those of the plane before. GUI thread.
class RasterTiles final : public QObject {
  Q_OBJECT

 public:
  struct Chart {
    int number = 0;
    std::string path;
    bool shown = true;
    std::optional<maps::ChartInfo> info;  ///< empty while it is being opened
    std::optional<Error> error;           ///< then nothing more is read from it
    int plane = -1;                       ///< that `extent` is of
    std::optional<maps::PlaneBox> extent;
  };

  /// The cache holds at most this much, less than all that is asked for only on a screen beyond 8K.
  explicit RasterTiles(TileWorkers& workers, std::size_t cache_bytes = std::size_t{256} << 20);

  /// From below to above. Charts that were there before keep their tiles.
  void set_charts(const std::vector<std::string>& paths);
  void show(const std::string& path, bool shown);
  [[nodiscard]] const std::vector<Chart>& charts() const { return charts_; }

  /// Paints what is loaded within `exposed` and asks for all that the view lacks; what an earlier view
  /// lacked is dropped.
  void paint(QPainter& painter, const ChartView& view, QRect exposed, const Tone& tone);
  /// Nothing is outstanding for the view last painted.
  [[nodiscard]] bool settled() const;

  static constexpr int kTile_px = 256;

 signals:
  /// Part of the plane last painted: x east, y north, m.
  void changed(QRectF plane_box);
  void chartsChanged();

 private:
  struct Tile {
    QImage plain, toned;  ///< null where the chart has nothing
    Tone tone;
    std::uint64_t used = 0;
  };
  struct Plane {
    int number;
    maps::LocalProjection projection;
  };
  struct Cells {
    std::int64_t west, south, east, north;  ///< both ends within
  };

  void opened(int number, Result<maps::ChartInfo> result);
  void arrived(const TileKey& key, const Tone& tone, QImage plain, QImage toned);
  void failed(const TileKey& key, Error error);
  [[nodiscard]] Chart* chart(int number);
  int plane_of(const ChartView& view);
  [[nodiscard]] const Tile* ready(const TileKey& key, const Tone& tone);
  bool paint_chart(QPainter& painter, const Chart& chart, int plane, const QTransform& to_screen,
                   QRectF exposed, int level, const Tone& tone, bool unscaled);
  bool paint_stand_in(QPainter& painter, const TileKey& key, const Tone& tone);
  void want(const ChartView& view, int plane, const Tone& tone);
  [[nodiscard]] TileWorkers::TileJob job(const Chart& chart, const TileKey& key, const Plane& plane,
                                         const Tone& tone);
  void evict();

  TileWorkers& workers_;
  std::size_t cache_bytes_;
  std::vector<Chart> charts_;
  std::deque<Plane> planes_;  ///< the one in force first, the one before second
  std::unordered_map<TileKey, Tile, TileKeyHash> tiles_;
  std::size_t held_bytes_ = 0;
  std::uint64_t clock_ = 0;
  int numbers_ = 0;
};

}  // namespace leadline::ui
