#pragma once

#include <QObject>
#include <QPainter>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "maps/charts/coastline.h"
#include "ui/chart/chart_view.h"
#include "ui/chart/raster_tiles.h"
#include "ui/chart/tile_workers.h"
#include "ui/look/colours.h"

namespace leadline::ui {

/// One layer in force, for the badge and the layers panel.
struct LayerLine {
  enum class State : std::uint8_t { ok, loading, broken, hidden };
  std::string name;    ///< "Bathymetry"
  std::string detail;  ///< "10 m · 2025-08-14 · ± 8 m · shift 3.2 m at 041°"; what is wrong when broken
  State state = State::ok;
  std::string remedy;  ///< when broken: what the operator can do
  bool accuracy_known = false;
  std::optional<double> accuracy_m;  ///< for the folded badge
};

/// What lies under everything else on a chart: sea, land with its coast line, raster charts. Loads in
/// threads of its own and never waits. GUI thread.
class Background final : public QObject {
  Q_OBJECT

 public:
  explicit Background(QObject* parent = nullptr);
  ~Background() override;

  /// The folder with the coast line: `charts/` beside the program or share/leadline/charts.
  void load_coastline(const std::string& folder);
  /// Raster charts from below to above; those there before keep what is loaded.
  void set_charts(const std::vector<std::string>& paths) { tiles_.set_charts(paths); }
  void show_chart(const std::string& path, bool shown) { tiles_.show(path, shown); }

  /// Paints the screen rectangle `exposed` of a view with what is loaded now and asks for the rest of the
  /// view. The painter takes screen coordinates; its state is kept.
  void paint(QPainter& painter, const ChartView& view, QRect exposed, const Colours& colours);
  /// The coast about a place, north up, with cross hair and frame.
  void paint_overview(QPainter& painter, QRect box, Geodetic centre, double metres_per_px,
                      const Colours& colours) const;

  /// Nothing is outstanding for the view last painted.
  [[nodiscard]] bool settled() const;
  /// From above to below.
  [[nodiscard]] std::vector<LayerLine> layers() const;

  /// A coast line of 1 : 50 000 000 is kilometres off: at fewer metres to the pixel there is only water.
  static constexpr double kFinestCoastline_m_per_px = 100.0;

 signals:
  /// To be painted anew: a part of the plane last painted, x east and y north, m; null: everything.
  void changed(QRectF plane_box);
  void overviewChanged();
  void layersChanged();

 private:
  // The land in one plane, and the plane that is wanted.
  struct Land {
    std::optional<maps::LocalProjection> projection;
    std::shared_ptr<const std::vector<maps::PlaneRing>> rings;
    std::optional<Geodetic> wanted;
    bool under_way = false;
  };

  void coastline_loaded(Result<maps::Coastline> result);
  void ask(Land& land, Geodetic origin) const;
  void land_ready(Land& land, Geodetic origin, std::shared_ptr<const std::vector<maps::PlaneRing>> rings);
  [[nodiscard]] bool coastline_hidden() const { return metres_per_px_ < kFinestCoastline_m_per_px; }
  [[nodiscard]] std::optional<LayerLine> coastline_line() const;

  std::unique_ptr<TileWorkers> workers_;
  RasterTiles tiles_;
  bool coastline_loading_ = false;
  std::shared_ptr<const maps::Coastline> coastline_;
  std::optional<Error> coastline_error_;
  double metres_per_px_ = 0.0;  ///< of the view last painted
  Land land_;
  mutable Land overview_land_;  ///< a cache
};

}  // namespace leadline::ui
