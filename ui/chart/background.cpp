#include "ui/chart/background.h"

#include <QMetaObject>
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "core/geo/geodesy.h"
#include "ui/chart/land_painter.h"

namespace leadline::ui {
namespace {

constexpr double kOverviewPlane_m = 100'000.0;  // from its origin the overview gets a plane of its own

// Two figures, or whole metres.
std::string metres(double m) {
  char text[32];
  if (m >= 10'000.0) {
    std::snprintf(text, sizeof text, "%.0f km", m / 1000.0);
  } else {
    std::snprintf(text, sizeof text, "%.*f m", m >= 10.0 ? 0 : m >= 0.95 ? 1 : 2, m);
  }
  std::string found = text;
  const auto zero = found.find(".0 ");
  if (zero != std::string::npos) found.erase(zero, 2);
  return found;
}

std::string facts(const maps::ChartInfo& info) {
  std::string text = metres(info.cell_size_m);
  if (info.date) text += " · " + *info.date;
  text += info.accuracy_m ? " · ± " + metres(*info.accuracy_m) : " · accuracy unknown";
  if (info.shift) {
    char shift[48];
    const int bearing = static_cast<int>(std::lround(info.shift->bearing.wrapped_2pi().deg())) % 360;
    std::snprintf(shift, sizeof shift, " · shift %.1f m at %03d°", info.shift->metres, bearing);
    text += shift;
  }
  return text;
}

LayerLine line_of(const RasterTiles::Chart& chart) {
  LayerLine line;
  line.name = chart.info ? chart.info->name : chart.path.substr(chart.path.find_last_of('/') + 1);
  if (chart.error) {
    line.state = LayerLine::State::broken;
    line.detail = chart.error->what;
    line.remedy = chart.error->remedy;
  } else if (!chart.info) {
    line.state = LayerLine::State::loading;
    line.detail = "loading";
  } else {
    line.state = chart.shown ? LayerLine::State::ok : LayerLine::State::hidden;
    line.detail = facts(*chart.info);
    line.accuracy_m = chart.info->accuracy_m;
    line.accuracy_known = line.accuracy_m.has_value();
  }
  return line;
}

}  // namespace

Background::Background(QObject* parent)
    : QObject(parent), workers_(std::make_unique<TileWorkers>()), tiles_(*workers_) {
  connect(&tiles_, &RasterTiles::changed, this, &Background::changed);
  connect(&tiles_, &RasterTiles::chartsChanged, this, [this] {
    emit layersChanged();
    emit changed({});
  });
}

// The workers end before what they report to.
Background::~Background() { workers_.reset(); }

void Background::load_coastline(const std::string& folder) {
  coastline_loading_ = true;
  workers_->add([this, folder](TileWorkers::OpenCharts&) {
    auto result = std::make_shared<Result<maps::Coastline>>(maps::load_coastline(folder));
    QMetaObject::invokeMethod(
        this, [this, result] { coastline_loaded(std::move(*result)); }, Qt::QueuedConnection);
  });
  emit layersChanged();
}

void Background::coastline_loaded(Result<maps::Coastline> result) {
  coastline_loading_ = false;
  coastline_error_.reset();
  coastline_.reset();
  if (result) {
    coastline_ = std::make_shared<const maps::Coastline>(std::move(result).value());
  } else {
    coastline_error_ = result.error();
  }
  land_.rings.reset();
  overview_land_.rings.reset();
  emit layersChanged();
  emit changed({});
  emit overviewChanged();
}

void Background::ask(Land& land, Geodetic origin) const {
  if (!coastline_ || (land.rings && land.projection->origin() == origin)) return;
  land.wanted = origin;
  if (land.under_way) return;
  land.under_way = true;
  auto* self = const_cast<Background*>(this);  // the queued answer fills the cache and tells by signals
  workers_->add([self, &land, origin, coastline = coastline_](TileWorkers::OpenCharts&) {
    auto rings = std::make_shared<const std::vector<maps::PlaneRing>>(
        maps::land_in_plane(*coastline, maps::LocalProjection(origin)));
    QMetaObject::invokeMethod(
        self, [self, &land, origin, rings] { self->land_ready(land, origin, rings); }, Qt::QueuedConnection);
  });
}

void Background::land_ready(Land& land, Geodetic origin,
                            std::shared_ptr<const std::vector<maps::PlaneRing>> rings) {
  land.under_way = false;
  land.projection.emplace(origin);
  land.rings = std::move(rings);
  if (land.wanted && !(*land.wanted == origin)) ask(land, *land.wanted);
  if (&land == &overview_land_) {
    emit overviewChanged();
  } else {
    emit changed({});
  }
}

void Background::paint(QPainter& painter, const ChartView& view, QRect exposed, const Colours& colours) {
  const bool was_hidden = coastline_hidden();
  metres_per_px_ = view.metres_per_px();
  painter.fillRect(exposed, colours.of(Role::sea_deep));
  if (!coastline_hidden()) {
    ask(land_, view.projection().origin());
    if (land_.rings) {
      const auto to_plane = land_.projection->origin() == view.projection().origin()
                                ? std::optional(QTransform())
                                : between_planes(*land_.projection, view.projection(), view.centre());
      if (to_plane) {
        draw_land(painter, *land_.rings, *to_plane * view.plane_to_screen(), exposed, Role::sea_deep,
                  colours);
      }
    }
  }
  tiles_.paint(painter, view, exposed, base_tone(colours));
  if (was_hidden != coastline_hidden()) emit layersChanged();
}

void Background::paint_overview(QPainter& painter, QRect box, Geodetic centre, double metres_per_px,
                                const Colours& colours) const {
  painter.fillRect(box, colours.of(Role::sea_mid));
  Land& land = overview_land_;
  const bool near =
      land.projection && geo::geodesic(land.projection->origin(), centre).distance_m < kOverviewPlane_m;
  ask(land, near ? land.projection->origin() : centre);
  const QPointF middle = QRectF(box).center();
  if (land.rings) {
    const double k = 1.0 / metres_per_px;
    if (const auto north_up = between_planes(*land.projection, maps::LocalProjection(centre), centre)) {
      draw_land(painter, *land.rings, *north_up * QTransform(k, 0.0, 0.0, -k, middle.x(), middle.y()), box,
                Role::sea_mid, colours);
    }
  }
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing, false);
  painter.setPen(QPen(colours.of(Role::ship), 1.0));
  painter.setBrush(Qt::NoBrush);
  const QPoint at = middle.toPoint();
  constexpr int kFree = 4;  // an open middle shows the place itself
  painter.drawLine(box.left(), at.y(), at.x() - kFree, at.y());
  painter.drawLine(at.x() + kFree, at.y(), box.right(), at.y());
  painter.drawLine(at.x(), box.top(), at.x(), at.y() - kFree);
  painter.drawLine(at.x(), at.y() + kFree, at.x(), box.bottom());
  painter.drawRect(box.adjusted(0, 0, -1, -1));
  painter.restore();
}

bool Background::settled() const {
  const bool land_waits = !coastline_hidden() && (land_.under_way || (coastline_ && !land_.rings));
  return !coastline_loading_ && !land_waits && !overview_land_.under_way && tiles_.settled();
}

std::optional<LayerLine> Background::coastline_line() const {
  LayerLine line;
  line.name = coastline_ ? coastline_->name : "Coastline";
  if (coastline_error_) {
    line.state = LayerLine::State::broken;
    line.detail = coastline_error_->what;
    line.remedy = coastline_error_->remedy;
  } else if (coastline_loading_) {
    line.state = LayerLine::State::loading;
    line.detail = "loading";
  } else if (!coastline_) {
    return std::nullopt;
  } else if (coastline_hidden()) {
    line.state = LayerLine::State::hidden;
    line.detail = "hidden, too coarse at this scale";
  } else {
    line.detail = "accuracy unknown";
  }
  return line;
}

std::vector<LayerLine> Background::layers() const {
  std::vector<LayerLine> lines;
  for (const auto& chart : tiles_.charts()) lines.push_back(line_of(chart));
  std::reverse(lines.begin(), lines.end());
  if (auto line = coastline_line()) lines.push_back(std::move(*line));
  return lines;
}

}  // namespace leadline::ui
