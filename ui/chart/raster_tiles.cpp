#include "ui/chart/raster_tiles.h"

#include <QMetaObject>
#include <algorithm>
#include <cmath>
#include <cstring>

#include "core/geo/geodesy.h"

namespace leadline::ui {
namespace {

constexpr int kTile = RasterTiles::kTile_px;
constexpr int kCoarserLevels = 6;  // above a missing tile that may stand in for it
// Tiles are smoothed each for itself: so far below the chart's own cell a tile's edge no longer shows.
constexpr int kFinerLevels = 4;
constexpr double kEarth_m = 6'371'000.0;
constexpr double kStandIn_m = 300'000.0;   // planes further apart are not mapped onto one another
constexpr std::int64_t kMostCells = 4096;  // of one view and chart

std::int64_t floor_div(std::int64_t a, std::int64_t b) { return a >= 0 ? a / b : -((-a + b - 1) / b); }

double side_m(int level) { return std::ldexp(kTile, level); }

int level_of(double metres_per_px) { return static_cast<int>(std::floor(std::log2(metres_per_px) + 1e-9)); }

maps::PlaneBox box_of(const TileKey& key) {
  const double side = side_m(key.level);
  const auto east = static_cast<double>(key.east), north = static_cast<double>(key.north);
  return {east * side, north * side, (east + 1.0) * side, (north + 1.0) * side};
}

// Tile px (x right, y down from its north-west corner) to plane metres.
QTransform tile_to_plane(const TileKey& key) {
  const double resolution = std::ldexp(1.0, key.level);
  const maps::PlaneBox box = box_of(key);
  return {resolution, 0.0, 0.0, -resolution, box.west_m, box.north_m};
}

QRectF rectangle(const maps::PlaneBox& box) {
  return {box.west_m, box.south_m, box.east_m - box.west_m, box.north_m - box.south_m};
}

QImage image_of(const maps::Picture& picture) {
  const bool nothing =
      std::all_of(picture.argb.begin(), picture.argb.end(), [](auto p) { return p >> 24 == 0; });
  if (nothing) return {};
  QImage image(picture.width, picture.height, QImage::Format_ARGB32_Premultiplied);
  for (int y = 0; y < picture.height; ++y) {
    std::memcpy(image.scanLine(y), picture.argb.data() + static_cast<std::size_t>(y) * picture.width,
                static_cast<std::size_t>(picture.width) * 4);
  }
  return image;
}

// Copy on write: an image that the tone leaves as it is stays shared.
QImage toned_copy(const QImage& plain, const Tone& tone) {
  QImage image = plain;
  if (!image.isNull() && !(tone == Tone{})) apply_tone(tone, image);
  return image;
}

std::size_t bytes_of(const QImage& plain, const QImage& toned) {
  std::size_t bytes = 128;
  if (!plain.isNull()) bytes += static_cast<std::size_t>(plain.sizeInBytes());
  if (!toned.isNull() && toned.cacheKey() != plain.cacheKey())
    bytes += static_cast<std::size_t>(toned.sizeInBytes());
  return bytes;
}

const Result<maps::RasterChart>& open_in(TileWorkers::OpenCharts& charts, int number,
                                         const std::string& path) {
  const auto found = charts.find(number);
  if (found != charts.end()) return found->second;
  return charts.emplace(number, maps::RasterChart::open(path)).first->second;
}

}  // namespace

void apply_tone(const Tone& tone, QImage& image) {
  for (int y = 0; y < image.height(); ++y) {
    auto* row = reinterpret_cast<QRgb*>(image.scanLine(y));
    for (int x = 0; x < image.width(); ++x) {
      const QRgb p = row[x];
      const double red = qRed(p), green = qGreen(p), blue = qBlue(p);
      const double luma = 0.2126 * red + 0.7152 * green + 0.0722 * blue;
      const auto part = [&](double c, double tint) {
        const double out = (luma + (c - luma) * tone.saturation) * tone.gain * tint;
        return std::min(static_cast<int>(std::max(out, 0.0) + 0.5), qAlpha(p));
      };
      row[x] = qRgba(part(red, tone.tint[0]), part(green, tone.tint[1]), part(blue, tone.tint[2]), qAlpha(p));
    }
  }
}

std::optional<QTransform> between_planes(const maps::LocalProjection& from, const maps::LocalProjection& to,
                                         Geodetic about) {
  const auto far = [&](Geodetic origin) { return geo::geodesic(origin, about).distance_m > kStandIn_m; };
  if (far(from.origin()) || far(to.origin())) return std::nullopt;
  const maps::PlanePoint a = from.forward(about), b = to.forward(about);
  const auto scale = [](maps::PlanePoint p) {
    return 1.0 + (p.east_m * p.east_m + p.north_m * p.north_m) / (4.0 * kEarth_m * kEarth_m);
  };
  const Angle turn = to.convergence(about) - from.convergence(about);
  const double k = scale(b) / scale(a), c = k * cos(turn), s = k * sin(turn);
  return QTransform(c, s, -s, c, b.east_m - (a.east_m * c - a.north_m * s),
                    b.north_m - (a.east_m * s + a.north_m * c));
}

RasterTiles::RasterTiles(TileWorkers& workers, std::size_t cache_bytes)
    : workers_(workers), cache_bytes_(cache_bytes) {}

RasterTiles::Chart* RasterTiles::chart(int number) {
  const auto found =
      std::find_if(charts_.begin(), charts_.end(), [&](const Chart& c) { return c.number == number; });
  return found == charts_.end() ? nullptr : &*found;
}

void RasterTiles::set_charts(const std::vector<std::string>& paths) {
  std::vector<Chart> next;
  for (const std::string& path : paths) {
    const auto known = std::find_if(charts_.begin(), charts_.end(),
                                    [&](const Chart& c) { return c.path == path && !c.error; });
    if (known != charts_.end()) {
      next.push_back(*known);
      continue;
    }
    next.push_back({++numbers_, path});
    workers_.add([this, path, number = numbers_](TileWorkers::OpenCharts& charts) {
      const auto& opened_chart = open_in(charts, number, path);
      auto result =
          opened_chart ? Result<maps::ChartInfo>(opened_chart.value().info()) : opened_chart.error();
      QMetaObject::invokeMethod(
          this, [this, number, result = std::move(result)]() mutable { opened(number, std::move(result)); },
          Qt::QueuedConnection);
    });
  }
  charts_ = std::move(next);
  emit chartsChanged();
}

void RasterTiles::show(const std::string& path, bool shown) {
  for (Chart& c : charts_) {
    if (c.path == path) c.shown = shown;
  }
  emit chartsChanged();
}

void RasterTiles::opened(int number, Result<maps::ChartInfo> result) {
  Chart* c = chart(number);
  if (c == nullptr) return;
  if (result) {
    c->info = std::move(result).value();
  } else {
    c->error = result.error();
  }
  emit chartsChanged();
}

int RasterTiles::plane_of(const ChartView& view) {
  if (planes_.empty() || !(planes_.front().projection.origin() == view.projection().origin())) {
    planes_.push_front({++numbers_, view.projection()});
    if (planes_.size() > 2) planes_.pop_back();
  }
  return planes_.front().number;
}

const RasterTiles::Tile* RasterTiles::ready(const TileKey& key, const Tone& tone) {
  const auto found = tiles_.find(key);
  if (found == tiles_.end() || !(found->second.tone == tone)) return nullptr;
  found->second.used = ++clock_;
  return &found->second;
}

void RasterTiles::paint(QPainter& painter, const ChartView& view, QRect exposed, const Tone& tone) {
  const int plane = plane_of(view);
  const double mpp = view.metres_per_px();
  painter.save();
  painter.setClipRect(exposed, Qt::IntersectClip);
  painter.setRenderHint(QPainter::Antialiasing, false);  // half covered edges would show as seams
  std::optional<QTransform> from_before;
  for (Chart& c : charts_) {
    if (!c.info || !c.shown) continue;
    if (c.plane != plane) {
      c.plane = plane;
      c.extent = maps::extent_in_plane(c.info->bounds, view.projection());
    }
    const int level = std::max(level_of(mpp), level_of(c.info->cell_size_m) - kFinerLevels);
    const bool unscaled = view.up() == Angle{} && std::ldexp(1.0, level) == mpp;
    const auto paint_all = [&](int of, const QTransform& to_screen, bool one_to_one) {
      return paint_chart(painter, c, of, to_screen, exposed, level, tone, one_to_one);
    };
    // The plane before stands in below; it is asked only when something is missing.
    if (planes_.size() > 1) {
      QPainter nowhere;
      if (!paint_chart(nowhere, c, plane, view.plane_to_screen(), exposed, level, tone, unscaled)) {
        if (!from_before)
          from_before = between_planes(planes_[1].projection, planes_[0].projection, view.centre());
        if (from_before) paint_all(planes_[1].number, *from_before * view.plane_to_screen(), false);
      }
    }
    paint_all(plane, view.plane_to_screen(), unscaled);
  }
  painter.restore();
  want(view, plane, tone);
}

// True when every tile was there. A painter that is not active only asks.
bool RasterTiles::paint_chart(QPainter& painter, const Chart& c, int plane, const QTransform& to_screen,
                              QRectF exposed, int level, const Tone& tone, bool unscaled) {
  QRectF area = to_screen.inverted().mapRect(exposed);
  if (c.extent && plane == c.plane) area = area.intersected(rectangle(*c.extent));
  if (area.isEmpty()) return true;
  const double side = side_m(level);
  const auto cell = [&](double m) { return static_cast<std::int64_t>(std::floor(m / side)); };
  const Cells cells{cell(area.left()), cell(area.top()), cell(area.right()), cell(area.bottom())};
  if ((cells.east - cells.west + 1) * (cells.north - cells.south + 1) > kMostCells) return true;
  const QTransform world = painter.isActive() ? painter.worldTransform() : QTransform();
  if (painter.isActive()) painter.setRenderHint(QPainter::SmoothPixmapTransform, !unscaled);
  bool all = true;
  for (std::int64_t north = cells.south; north <= cells.north; ++north) {
    for (std::int64_t east = cells.west; east <= cells.east; ++east) {
      const TileKey key{c.number, plane, level, east, north};
      const Tile* tile = ready(key, tone);
      all = all && tile != nullptr;
      if (!painter.isActive() || (tile != nullptr && tile->toned.isNull())) continue;
      painter.setWorldTransform(tile_to_plane(key) * to_screen * world);
      if (tile != nullptr) {
        painter.drawImage(QPointF(0.0, 0.0), tile->toned);
      } else {
        paint_stand_in(painter, key, tone);
      }
    }
  }
  if (painter.isActive()) painter.setWorldTransform(world);
  return all;
}

// In the missing tile's coordinates: the part of a coarser tile, else the finer ones there are.
bool RasterTiles::paint_stand_in(QPainter& painter, const TileKey& key, const Tone& tone) {
  for (int up = 1; up <= kCoarserLevels; ++up) {
    const std::int64_t parts = std::int64_t{1} << up;
    TileKey coarse = key;
    coarse.level += up;
    coarse.east = floor_div(key.east, parts);
    coarse.north = floor_div(key.north, parts);
    const Tile* tile = ready(coarse, tone);
    if (tile == nullptr) continue;
    if (tile->toned.isNull()) return true;
    const double size = static_cast<double>(kTile) / static_cast<double>(parts);
    const auto column = static_cast<double>(key.east - coarse.east * parts);
    const auto row = static_cast<double>(parts - 1 - (key.north - coarse.north * parts));
    painter.drawImage(QRectF(0.0, 0.0, kTile, kTile), tile->toned,
                      QRectF(column * size, row * size, size, size));
    return true;
  }
  bool any = false;
  for (int i = 0; i < 4; ++i) {
    const TileKey fine{key.chart, key.plane, key.level - 1, key.east * 2 + i % 2, key.north * 2 + i / 2};
    const Tile* tile = ready(fine, tone);
    if (tile == nullptr || tile->toned.isNull()) continue;
    painter.drawImage(QRectF(i % 2 * kTile / 2.0, (1 - i / 2) * kTile / 2.0, kTile / 2.0, kTile / 2.0),
                      tile->toned, QRectF(0.0, 0.0, kTile, kTile));
    any = true;
  }
  return any;
}

void RasterTiles::want(const ChartView& view, int plane, const Tone& tone) {
  struct Missing {
    TileKey key;
    const Chart* chart;
    double from_centre_m;
  };
  std::vector<Missing> missing;
  const maps::PlaneBox all = view.plane_box(QRectF(QPointF(0.0, 0.0), QSizeF(view.size())));
  const maps::PlanePoint centre{(all.west_m + all.east_m) / 2.0, (all.south_m + all.north_m) / 2.0};
  const QRectF screen(QPointF(0.0, 0.0), QSizeF(view.size()));
  for (const Chart& c : charts_) {
    if (!c.info || !c.shown || c.error) continue;
    const int level = std::max(level_of(view.metres_per_px()), level_of(c.info->cell_size_m) - kFinerLevels);
    const double side = side_m(level);
    QRectF area = rectangle(all);
    if (c.extent) area = area.intersected(rectangle(*c.extent));
    if (area.isEmpty()) continue;
    const auto cell = [&](double m) { return static_cast<std::int64_t>(std::floor(m / side)); };
    const Cells cells{cell(area.left()), cell(area.top()), cell(area.right()), cell(area.bottom())};
    if ((cells.east - cells.west + 1) * (cells.north - cells.south + 1) > kMostCells) continue;
    for (std::int64_t north = cells.south; north <= cells.north; ++north) {
      for (std::int64_t east = cells.west; east <= cells.east; ++east) {
        const TileKey key{c.number, plane, level, east, north};
        if (ready(key, tone) != nullptr) continue;
        const QRectF box = rectangle(box_of(key));
        if (!view.plane_to_screen().mapRect(box).intersects(screen)) continue;
        missing.push_back(
            {key, &c, std::hypot(box.center().x() - centre.east_m, box.center().y() - centre.north_m)});
      }
    }
  }
  std::stable_sort(missing.begin(), missing.end(),
                   [](const Missing& a, const Missing& b) { return a.from_centre_m < b.from_centre_m; });
  std::vector<TileWorkers::TileJob> jobs;
  jobs.reserve(missing.size());
  for (const Missing& m : missing) jobs.push_back(job(*m.chart, m.key, planes_.front(), tone));
  workers_.want(std::move(jobs));
}

TileWorkers::TileJob RasterTiles::job(const Chart& c, const TileKey& key, const Plane& plane,
                                      const Tone& tone) {
  const auto known = tiles_.find(key);
  if (known != tiles_.end()) {
    return {key, [this, key, tone, plain = known->second.plain](TileWorkers::OpenCharts&) {
              QImage toned = toned_copy(plain, tone);
              QMetaObject::invokeMethod(
                  this, [=, this] { arrived(key, tone, plain, toned); }, Qt::QueuedConnection);
            }};
  }
  return {key, [this, key, tone, path = c.path,
                projection = plane.projection.definition()](TileWorkers::OpenCharts& charts) {
            const auto& opened_chart = open_in(charts, key.chart, path);
            auto picture = opened_chart ? opened_chart.value().read(box_of(key), projection, kTile, kTile)
                                        : Result<maps::Picture>(opened_chart.error());
            if (!picture) {
              QMetaObject::invokeMethod(
                  this, [this, key, error = picture.error()] { failed(key, error); }, Qt::QueuedConnection);
              return;
            }
            QImage plain = image_of(picture.value()), toned = toned_copy(plain, tone);
            QMetaObject::invokeMethod(
                this, [=, this] { arrived(key, tone, plain, toned); }, Qt::QueuedConnection);
          }};
}

void RasterTiles::arrived(const TileKey& key, const Tone& tone, QImage plain, QImage toned) {
  workers_.taken(key);
  if (chart(key.chart) == nullptr) return;
  Tile& tile = tiles_[key];
  if (tile.used != 0) held_bytes_ -= bytes_of(tile.plain, tile.toned);
  tile = {std::move(plain), std::move(toned), tone, ++clock_};
  held_bytes_ += bytes_of(tile.plain, tile.toned);
  evict();
  if (!planes_.empty() && key.plane == planes_.front().number) emit changed(rectangle(box_of(key)));
}

void RasterTiles::failed(const TileKey& key, Error error) {
  workers_.taken(key);
  Chart* c = chart(key.chart);
  if (c == nullptr || c->error) return;
  c->error = std::move(error);
  emit chartsChanged();
}

// An eighth at a time, so that it is seldom.
void RasterTiles::evict() {
  if (held_bytes_ <= cache_bytes_) return;
  std::vector<std::uint64_t> ages;
  ages.reserve(tiles_.size());
  for (const auto& [key, tile] : tiles_) ages.push_back(tile.used);
  const auto nth = ages.begin() + static_cast<std::ptrdiff_t>(ages.size() / 8);
  std::nth_element(ages.begin(), nth, ages.end());
  const std::uint64_t oldest_kept = *nth + 1;
  for (auto it = tiles_.begin(); it != tiles_.end();) {
    if (it->second.used >= oldest_kept) {
      ++it;
      continue;
    }
    held_bytes_ -= bytes_of(it->second.plain, it->second.toned);
    it = tiles_.erase(it);
  }
}

bool RasterTiles::settled() const {
  const bool opening =
      std::any_of(charts_.begin(), charts_.end(), [](const Chart& c) { return !c.info && !c.error; });
  return !opening && workers_.no_tiles();
}

}  // namespace leadline::ui
