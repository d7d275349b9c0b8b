#include "ui/chart/labels.h"

#include <QFontMetricsF>
#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "core/types/angle.h"
#include "ui/chart/halo.h"
#include "ui/look/halo_text.h"
#include "ui/look/look.h"

namespace leadline::ui {
namespace {

constexpr int kBeside = 4;       // places beside the symbol; the others have a leader
constexpr int kDirections = 16;  // of leaders, on rings further and further out
constexpr int kRings = 12;
constexpr int kPlaces = kBeside + kDirections * kRings;
constexpr double kHaloEdge_px = 1.5;
constexpr double kSpare_px = 3.0;     // round a new place, so that it lasts
constexpr double kComeBack_px = 6.0;  // round a place beside the symbol, to leave a leader for

QFont name_font() { return font(13, true); }
QFont detail_font() { return font(12); }

double line_height(const QFont& of) {
  const QFontMetricsF metrics(of);
  return std::ceil(metrics.ascent() + metrics.descent());
}

QSizeF size_of(const Label& label) {
  double width = QFontMetricsF(name_font()).horizontalAdvance(label.name);
  double height = line_height(name_font());
  if (!label.detail.isEmpty()) {
    width = std::max(width, QFontMetricsF(detail_font()).horizontalAdvance(label.detail));
    height += line_height(detail_font());
  }
  return {std::ceil(width) + 2.0 * kHaloEdge_px, height};
}

struct Place {
  QRectF box;
  bool at_left = false;
};

Place place_at(int number, const Label& label, QSizeF size) {
  const double clear = label.clear_px;
  QRectF box(QPointF(), size);
  if (number < kBeside) {
    const bool at_left = number >= 2, above = number % 2 == 1;
    const double x = clear * 0.8, y = clear * 0.25;
    if (at_left) {
      box.moveRight(label.at.x() - x);
    } else {
      box.moveLeft(label.at.x() + x);
    }
    if (above) {
      box.moveBottom(label.at.y() - y);
    } else {
      box.moveTop(label.at.y() + y);
    }
    return {box, at_left};
  }
  const int ring = (number - kBeside) / kDirections, direction = (number - kBeside) % kDirections;
  // From the lower right by turns to both sides.
  const int turn = (direction + 1) / 2 * (direction % 2 == 0 ? 1 : -1);
  const double a = (45.0 + turn * 360.0 / kDirections) * kRadPerDeg;
  const double out = clear + 18.0 + 22.0 * ring;
  const QPointF way(std::cos(a), std::sin(a));
  // The near edge, not the middle, lies on the ring.
  box.moveCenter(label.at +
                 QPointF(way.x() * (out + size.width() / 2.0), way.y() * (out + size.height() / 2.0)));
  return {box, way.x() < 0.0};
}

bool crosses(QRectF box, QLineF line) {
  if (line.isNull()) return false;
  if (box.contains(line.p1()) || box.contains(line.p2())) return true;
  const QRectF reach = QRectF(line.p1(), line.p2()).normalized().adjusted(-0.1, -0.1, 0.1, 0.1);
  if (!reach.intersects(box)) return false;
  // All corners on one side of the line, or not.
  const auto side = [&](QPointF p) {
    return line.dx() * (p.y() - line.y1()) - line.dy() * (p.x() - line.x1()) > 0.0;
  };
  const bool first = side(box.topLeft());
  return side(box.topRight()) != first || side(box.bottomLeft()) != first || side(box.bottomRight()) != first;
}

QLineF leader_to(QRectF box, const Label& label) {
  const QPointF end(std::clamp(label.at.x(), box.left(), box.right()),
                    std::clamp(label.at.y(), box.top(), box.bottom()));
  const QLineF whole(label.at, end);
  const double start = std::min(label.clear_px * 0.8, whole.length() / 2.0);
  return {whole.pointAt(start / std::max(whole.length(), 1e-9)), end};
}

/// What is taken so far.
class Room {
 public:
  Room(const std::vector<Label>& labels, const LabelObstacles& obstacles, QRectF chart)
      : chart_(chart), boxes_(obstacles.boxes), lines_(obstacles.lines) {
    for (const Label& label : labels) {
      const double half = label.clear_px * 0.7;
      symbols_.push_back({label.at.x() - half, label.at.y() - half, 2.0 * half, 2.0 * half});
    }
  }

  [[nodiscard]] bool free(QRectF box, std::size_t own, double margin_px) const {
    box.adjust(-margin_px, -margin_px, margin_px, margin_px);
    if (!chart_.contains(box)) return false;
    for (std::size_t i = 0; i < symbols_.size(); ++i)
      if (i != own && symbols_[i].intersects(box)) return false;
    return std::none_of(boxes_.begin(), boxes_.end(), [&](QRectF taken) { return taken.intersects(box); }) &&
           std::none_of(lines_.begin(), lines_.end(), [&](QLineF line) { return crosses(box, line); });
  }
  /// A leader may cross lines, but no text and no symbol.
  [[nodiscard]] bool free(QLineF leader, std::size_t own) const {
    for (std::size_t i = 0; i < symbols_.size(); ++i)
      if (i != own && crosses(symbols_[i], leader)) return false;
    return std::none_of(boxes_.begin(), boxes_.end(), [&](QRectF taken) { return crosses(taken, leader); });
  }
  void take(const PlacedLabel& placed) {
    boxes_.push_back(placed.box);
    if (!placed.leader.isNull()) lines_.push_back(placed.leader);
  }

 private:
  QRectF chart_;
  std::vector<QRectF> boxes_, symbols_;
  std::vector<QLineF> lines_;
};

enum class Leader { clear, anywhere };

std::optional<PlacedLabel> fitted(const Room& room, int number, const Label& label, QSizeF size,
                                  std::size_t own, double margin_px, Leader leader = Leader::clear) {
  const Place place = place_at(number, label, size);
  if (!room.free(place.box, own, margin_px)) return std::nullopt;
  PlacedLabel placed{label, place.box, place.at_left, {}};
  if (number < kBeside) return placed;
  placed.leader = leader_to(place.box, label);
  if (leader == Leader::clear && !room.free(placed.leader, own)) return std::nullopt;
  return placed;
}

}  // namespace

std::vector<PlacedLabel> place_labels(LabelPlaces& places, const std::vector<Label>& labels,
                                      const LabelObstacles& obstacles, QRectF chart) {
  Room room(labels, obstacles, chart);
  std::vector<std::optional<PlacedLabel>> found(labels.size());
  std::vector<QSizeF> sizes(labels.size());
  std::map<std::string, int> next;
  const auto settle = [&](std::size_t i, int number, const PlacedLabel& placed) {
    found[i] = placed;
    next[labels[i].key] = number;
    room.take(placed);
  };

  // First those that stay, so that a newcomer pushes nobody away.
  for (std::size_t i = 0; i < labels.size(); ++i) {
    if (!chart.contains(labels[i].at)) continue;
    sizes[i] = size_of(labels[i]);
    const auto last = places.place.find(labels[i].key);
    if (last == places.place.end()) continue;
    if (last->second >= kBeside) {
      for (int number = 0; number < kBeside && !found[i]; ++number)
        if (const auto placed = fitted(room, number, labels[i], sizes[i], i, kComeBack_px))
          settle(i, number, *placed);
    }
    if (found[i]) continue;
    if (const auto placed = fitted(room, last->second, labels[i], sizes[i], i, 0.0, Leader::anywhere))
      settle(i, last->second, *placed);
  }
  for (std::size_t i = 0; i < labels.size(); ++i) {
    if (found[i] || !chart.contains(labels[i].at)) continue;
    // A symbol under furniture or in a crowd: its leader may cross what it must, its text still not.
    for (const auto& [spare_px, leader] : {std::pair{kSpare_px, Leader::clear}, std::pair{0.0, Leader::clear},
                                           std::pair{0.0, Leader::anywhere}}) {
      for (int number = 0; number < kPlaces && !found[i]; ++number)
        if (const auto placed = fitted(room, number, labels[i], sizes[i], i, spare_px, leader))
          settle(i, number, *placed);
    }
    if (found[i]) continue;
    // No room anywhere: over others rather than not at all.
    const Place place = place_at(0, labels[i], sizes[i]);
    settle(i, 0, {labels[i], place.box, place.at_left, {}});
  }

  places.place = std::move(next);
  std::vector<PlacedLabel> placed;
  for (const auto& label : found)
    if (label) placed.push_back(*label);
  return placed;
}

void draw_label(QPainter& painter, const PlacedLabel& placed, const Colours& colours) {
  if (!placed.leader.isNull()) {
    QPainterPath leader(placed.leader.p1());
    leader.lineTo(placed.leader.p2());
    painter.setRenderHint(QPainter::Antialiasing);
    stroke_haloed(painter, leader, {Role::ink, 1.0}, Halo::line, colours);
  }
  double top = placed.box.top();
  const auto line = [&](const QString& text, const QFont& of, Role role) {
    const QFontMetricsF metrics(of);
    const double left = placed.at_left ? placed.box.right() - kHaloEdge_px - metrics.horizontalAdvance(text)
                                       : placed.box.left() + kHaloEdge_px;
    draw_halo_text(painter, {left, top + metrics.ascent()}, text, of, role, colours);
    top += line_height(of);
  };
  line(placed.label.name, name_font(), placed.label.role);
  if (!placed.label.detail.isEmpty()) line(placed.label.detail, detail_font(), Role::ink);
}

}  // namespace leadline::ui
