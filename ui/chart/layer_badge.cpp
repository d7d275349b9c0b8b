#include "ui/chart/layer_badge.h"

#include <QFontMetricsF>
#include <algorithm>
#include <cmath>

#include "ui/chart/furniture_panel.h"
#include "ui/chart/halo.h"
#include "ui/look/look.h"

namespace leadline::ui {
namespace {

constexpr double kPad_px = 10.0, kRow_px = 18.0, kIcon_px = 13.0, kGap_px = 9.0, kChevron_px = 9.0;

// The caution icon of the alert bar, small: a yellow square with its mark.
void draw_caution(QPainter& painter, QRectF box, const Colours& colours) {
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(pen_of({Role::caution_mark, 1.3}, colours));
  painter.setBrush(colours.of(Role::caution_icon));
  painter.drawRect(box.adjusted(0.65, 0.65, -0.65, -0.65));
  const double x = box.center().x();
  painter.setPen(QPen(colours.of(Role::caution_glyph), 1.9, Qt::SolidLine, Qt::FlatCap));
  painter.drawLine(QPointF(x, box.top() + 3.0), QPointF(x, box.top() + 7.6));
  painter.drawLine(QPointF(x, box.bottom() - 3.9), QPointF(x, box.bottom() - 2.1));
  painter.restore();
}

void draw_chevron(QPainter& painter, QPointF middle, bool folded, const Colours& colours) {
  const double down = folded ? 1.0 : -1.0;
  QPainterPath path;
  path.moveTo(middle + QPointF(-4, -2 * down));
  path.lineTo(middle + QPointF(0, 2 * down));
  path.lineTo(middle + QPointF(4, -2 * down));
  painter.setRenderHint(QPainter::Antialiasing);
  painter.strokePath(path, QPen(colours.of(Role::text_2), 1.6, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
}

struct Row {
  BadgeLine line;
  bool title = false;
};

std::vector<Row> rows_of(const std::vector<BadgeLine>& lines, bool folded) {
  const QString title = QStringLiteral("Layers");
  if (folded) {
    BadgeLine worst = worst_of(lines);
    const bool fine = worst.doubt == BadgeLine::Doubt::none;
    if (fine)
      worst.detail =
          worst.accuracy_m ? QStringLiteral("± %1 m").arg(*worst.accuracy_m, 0, 'g', 3) : QString();
    if (worst.doubt == BadgeLine::Doubt::accuracy_unknown) worst.detail = QStringLiteral("accuracy unknown");
    if (worst.doubt == BadgeLine::Doubt::broken) worst.detail = worst.name + QStringLiteral(" broken");
    worst.name = title;
    return {{worst, true}};
  }
  std::vector<Row> rows{{{title, {}, BadgeLine::Doubt::none, {}}, true}};
  for (const BadgeLine& line : lines) rows.push_back({line, false});
  return rows;
}

double width_of(const Row& row) {
  double width = QFontMetricsF(row.title ? font(12, true) : font(12)).horizontalAdvance(row.line.name);
  if (row.line.doubt != BadgeLine::Doubt::none) width += kGap_px + kIcon_px;
  if (!row.line.detail.isEmpty())
    width += kGap_px + QFontMetricsF(font(12)).horizontalAdvance(row.line.detail);
  return width + (row.title ? kGap_px + kChevron_px : 0.0);
}

}  // namespace

BadgeLine worst_of(const std::vector<BadgeLine>& lines) {
  const auto worse = [](const BadgeLine& a, const BadgeLine& b) {
    if (a.doubt != b.doubt) return a.doubt < b.doubt;
    return a.accuracy_m.value_or(-1.0) < b.accuracy_m.value_or(-1.0);
  };
  const auto worst = std::max_element(lines.begin(), lines.end(), worse);
  return worst == lines.end() ? BadgeLine{} : *worst;
}

QRectF layer_badge_box(const ChartView& view, const std::vector<BadgeLine>& lines, bool folded) {
  if (lines.empty()) return {};
  double width = 0.0;
  const std::vector<Row> rows = rows_of(lines, folded);
  for (const Row& row : rows) width = std::max(width, width_of(row));
  // The orientation box on the other side is never covered.
  const double room = std::max(view.size().width() - 184.0 - 4.0 * kFurnitureMargin_px, 120.0);
  return {kFurnitureMargin_px, kFurnitureMargin_px, std::min(std::ceil(width + 2.0 * kPad_px), room),
          kRow_px * static_cast<double>(rows.size()) + 12.0};
}

QRectF draw_layer_badge(QPainter& painter, const ChartView& view, const std::vector<BadgeLine>& lines,
                        bool folded, const Colours& colours) {
  const QRectF box = layer_badge_box(view, lines, folded);
  if (box.isNull()) return box;
  draw_furniture_panel(painter, box, colours);
  painter.save();
  double top = box.top() + 6.0;
  for (const Row& row : rows_of(lines, folded)) {
    double x = box.left() + kPad_px;
    const double end = box.right() - kPad_px - (row.title ? kGap_px + kChevron_px : 0.0);
    const auto write = [&](const QString& text, const QFont& of, Role role) {
      const QFontMetricsF metrics(of);
      const QString fits = metrics.elidedText(text, Qt::ElideRight, std::max(end - x, 0.0));
      painter.setFont(of);
      painter.setPen(colours.of(role));
      painter.drawText(QRectF(x, top, std::max(end - x, 0.0), kRow_px), Qt::AlignLeft | Qt::AlignVCenter,
                       fits);
      x += metrics.horizontalAdvance(fits) + kGap_px;
    };
    write(row.line.name, row.title ? font(12, true) : font(12), Role::text);
    if (row.line.doubt != BadgeLine::Doubt::none && x + kIcon_px <= box.right() - 2.0) {
      draw_caution(painter, {std::round(x), std::round(top + (kRow_px - kIcon_px) / 2.0), kIcon_px, kIcon_px},
                   colours);
      x += kIcon_px + kGap_px - 3.0;
    }
    if (!row.line.detail.isEmpty()) write(row.line.detail, font(12), Role::text_2);
    if (row.title)
      draw_chevron(painter, {box.right() - kPad_px - kChevron_px / 2.0, top + kRow_px / 2.0}, folded,
                   colours);
    top += kRow_px;
  }
  painter.restore();
  return box;
}

}  // namespace leadline::ui
