#include "ui/chart/ground.h"

#include <QRegion>

namespace leadline::ui {
namespace {

int wrapped(int value, int size) {
  const int rest = value % size;
  return rest < 0 ? rest + size : rest;
}

/// Calls place(screen part, picture's left, picture's top) for the up to four parts of a screen rectangle.
template <class Place>
void for_each_part(const QRect& screen, QPoint origin, QSize size, Place place) {
  for (int y = screen.top(); y <= screen.bottom();) {
    const int top = wrapped(y - origin.y(), size.height());
    const int height = std::min(screen.bottom() - y + 1, size.height() - top);
    for (int x = screen.left(); x <= screen.right();) {
      const int left = wrapped(x - origin.x(), size.width());
      const int width = std::min(screen.right() - x + 1, size.width() - left);
      place(QRect(x, y, width, height), left, top);
      x += width;
    }
    y += height;
  }
}

bool same_but_for_place(const ChartView& a, const ChartView& b) {
  return a.size() == b.size() && a.metres_per_px() == b.metres_per_px() && a.up() == b.up() &&
         a.projection().origin() == b.projection().origin();
}

}  // namespace

void Ground::invalidate() {
  view_.reset();
  stale_.clear();
}

void Ground::invalidate(const maps::PlaneBox& box) { stale_.push_back(box); }

long long Ground::take_painted_px() { return std::exchange(painted_px_, 0); }

void Ground::paint_part(QRect screen, const Paint& paint) {
  painted_px_ += static_cast<long long>(screen.width()) * screen.height();
  for_each_part(screen, view_->origin_px(), picture_.size(), [&](const QRect& part, int left, int top) {
    QPainter painter(&picture_);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.translate(left - part.x(), top - part.y());
    painter.setClipRect(part);
    paint(painter, part);
  });
}

void Ground::update(const ChartView& view, const Paint& paint) {
  const QRect all(QPoint(0, 0), view.size());
  if (all.isEmpty()) return;
  QRegion exposed;
  if (!view_ || !same_but_for_place(*view_, view)) {
    if (picture_.size() != view.size()) picture_ = QImage(view.size(), QImage::Format_RGB32);
    exposed = all;
  } else {
    const QPoint moved = view.origin_px() - view_->origin_px();
    exposed = QRegion(all) - QRegion(all.translated(moved));
    for (const maps::PlaneBox& box : stale_) {
      const QPolygonF corners({view.to_screen(maps::PlanePoint{box.west_m, box.south_m}),
                               view.to_screen(maps::PlanePoint{box.west_m, box.north_m}),
                               view.to_screen(maps::PlanePoint{box.east_m, box.north_m}),
                               view.to_screen(maps::PlanePoint{box.east_m, box.south_m})});
      exposed += corners.boundingRect().intersected(QRectF(all)).toAlignedRect().intersected(all);
    }
  }
  view_ = view;
  stale_.clear();
  for (const QRect& part : exposed) paint_part(part, paint);
}

void Ground::add(const QRect& screen, const Paint& paint) {
  const QRect seen = screen.intersected(QRect(QPoint(0, 0), picture_.size()));
  if (view_ && !seen.isEmpty()) paint_part(seen, paint);
}

void Ground::draw(QPainter& painter) const {
  if (!view_) return;
  const auto mode = painter.compositionMode();
  painter.setCompositionMode(QPainter::CompositionMode_Source);
  for_each_part(QRect(QPoint(0, 0), picture_.size()), view_->origin_px(), picture_.size(),
                [&](const QRect& part, int left, int top) {
                  painter.drawImage(part.topLeft(), picture_, QRect(left, top, part.width(), part.height()));
                });
  painter.setCompositionMode(mode);
}

}  // namespace leadline::ui
