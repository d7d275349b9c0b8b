#include "ui/widgets/table.h"

#include <QHelpEvent>
#include <QPainter>
#include <QToolTip>
#include <algorithm>
#include <array>
#include <cmath>

#include "ui/look/icon.h"
#include "ui/look/look.h"
#include "ui/widgets/alert_icon.h"
#include "ui/widgets/paint_text.h"
#include "ui/widgets/spoken.h"

namespace leadline::ui {
namespace {

const QString kUnknown = QStringLiteral("− − −");

double base_of(int row) { return base_line((row + 0.5) * kTableRow, ui::font(12)); }

void draw_ground(QPainter& painter, const QWidget& widget, int rows, const Colours& colours) {
  painter.fillRect(widget.rect(), colours.of(Role::bg_tile));
  for (int row = 1; row < rows + 1; ++row)
    draw_rule(painter, {0, row * kTableRow - 1}, {widget.width() - 1, row * kTableRow - 1},
              colours.of(Role::line));
}

/// The ink of a row by its state; what is lost has no figures.
Role ink_of(ValueState state) {
  return state == ValueState::stale || state == ValueState::lost ? Role::text_2 : Role::text;
}

void draw_figure(QPainter& painter, double right, int row, const std::string& figure, ValueState state,
                 double room, const Colours& colours) {
  const QFont small = ui::font(12);
  const bool unknown = figure.empty() || state == ValueState::lost;
  draw_text_right(painter, {right, base_of(row)}, elided(unknown ? kUnknown : q(figure), small, room), small,
                  colours.of(unknown ? Role::text_2 : ink_of(state)));
}

void draw_age(QPainter& painter, double right, int row, const std::string& age, ValueState state,
              const Colours& colours) {
  const bool old = state == ValueState::stale || state == ValueState::lost;
  const QFont small = ui::font(12, old);
  const double base = base_of(row);
  const QColor ink = colours.of(age.empty() ? Role::text_2 : Role::text);
  const double left = draw_text_right(painter, {right, base}, age.empty() ? kUnknown : q(age), small, ink);
  if (state == ValueState::ageing)
    for (double dot = std::round(left); dot < right; dot += 2)
      painter.fillRect(QRectF(dot, base + 2, 1, 1), ink);
}

void draw_mark(QPainter& painter, QPointF centre, const SourceRow& row, const Colours& colours) {
  if (row.alert)
    return draw_alert_icon(painter, centre, *row.alert == Alarm::Priority::alarm ? 13 : 14, *row.alert,
                           AlertMark::unacknowledged, colours);
  const char* const name = row.state == ValueState::lost    ? "cross"
                           : row.state == ValueState::stale ? "clock"
                                                            : "check";
  draw_icon(painter, centre, QString::fromLatin1(name), 13, colours.of(Role::text_2));
}

template <class Row>
void show_tip_of_row(const QHelpEvent& help, const std::vector<Row>& rows, QWidget* table) {
  const auto row = static_cast<std::size_t>(std::max(0, help.y() / kTableRow - 1));
  if (help.y() >= kTableRow && row < rows.size() && !rows[row].tool_tip.empty())
    QToolTip::showText(help.globalPos(), q(rows[row].tool_tip), table);
  else
    QToolTip::hideText();
}

}  // namespace

SourcesTable::SourcesTable(QWidget* parent) : QWidget(parent) {
  setObjectName(QStringLiteral("sourcesTable"));
  setAccessibleName(QStringLiteral("Sources"));
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
}

void SourcesTable::set(const std::vector<SourceRow>& rows) {
  if (rows == rows_) return;
  const bool grown = rows.size() != rows_.size();
  rows_ = rows;
  QStringList words;
  for (const auto& row : rows_)
    words << QStringLiteral("%1 %2, age %3, %4")
                 .arg(q(row.name), state_word(row.state), q(row.age), q(row.quality));
  setAccessibleDescription(words.join(QStringLiteral("; ")));
  if (grown) updateGeometry();
  update();
}

QSize SourcesTable::sizeHint() const { return {320, kTableRow * (static_cast<int>(rows_.size()) + 1)}; }

bool SourcesTable::event(QEvent* event) {
  if (event->type() != QEvent::ToolTip) return QWidget::event(event);
  show_tip_of_row(static_cast<const QHelpEvent&>(*event), rows_, this);
  return true;
}

void SourcesTable::paintEvent(QPaintEvent* /*event*/) {
  const Colours& colours = Look::current().colours();
  QPainter painter(this);
  draw_ground(painter, *this, static_cast<int>(rows_.size()), colours);
  const double w = width();
  const bool narrow = w < 360;
  const double quality_room = narrow ? 84 : 98, rate_room = narrow ? 52 : 62;
  const double quality = w - 8, latency = quality - quality_room - 6, age = latency - (narrow ? 46 : 54),
               rate = age - (narrow ? 36 : 48);
  const double name_left = narrow ? 25 : 29, name_room = rate - rate_room - name_left;
  const QFont small = ui::font(12);
  for (const auto& [x, title] :
       {std::pair{rate, "rate"}, {age, "age"}, {latency, "latency"}, {quality, "quality"}})
    draw_text_right(painter, {x, base_of(0)}, QString::fromLatin1(title), small, colours.of(Role::text_2));
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    const SourceRow& row = rows_[i];
    const int at = static_cast<int>(i) + 1;
    draw_mark(painter, {narrow ? 13.0 : 15.0, (at + 0.5) * kTableRow - 0.5}, row, colours);
    draw_text(painter, {name_left, base_of(at)}, elided(q(row.name), small, name_room), small,
              colours.of(ink_of(row.state)));
    draw_figure(painter, rate, at, row.rate, row.state, rate_room, colours);
    draw_age(painter, age, at, row.age, row.state, colours);
    draw_figure(painter, latency, at, row.latency, row.state, narrow ? 44 : 52, colours);
    draw_figure(painter, quality, at, row.quality, row.state, quality_room, colours);
  }
}

RangeBearingTable::RangeBearingTable(QWidget* parent) : QWidget(parent) {
  setObjectName(QStringLiteral("rangeTable"));
  setAccessibleName(QStringLiteral("Range and bearing"));
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
}

void RangeBearingTable::set(const std::vector<RangeRow>& rows) {
  if (rows == rows_) return;
  const bool grown = rows.size() != rows_.size();
  rows_ = rows;
  QStringList words;
  for (const auto& row : rows_)
    words << QStringLiteral("%1 to %2: %3, bearing %4, slant %5")
                 .arg(q(row.from), q(row.to), q(row.horizontal), q(row.bearing), q(row.slant));
  setAccessibleDescription(words.join(QStringLiteral("; ")));
  if (grown) updateGeometry();
  update();
}

QSize RangeBearingTable::sizeHint() const { return {320, kTableRow * (static_cast<int>(rows_.size()) + 1)}; }

bool RangeBearingTable::event(QEvent* event) {
  if (event->type() != QEvent::ToolTip) return QWidget::event(event);
  show_tip_of_row(static_cast<const QHelpEvent&>(*event), rows_, this);
  return true;
}

void RangeBearingTable::paintEvent(QPaintEvent* /*event*/) {
  const Colours& colours = Look::current().colours();
  QPainter painter(this);
  draw_ground(painter, *this, static_cast<int>(rows_.size()), colours);
  const QFont small = ui::font(12);
  const double w = width(), slant = w - 8, bearing = slant - 0.2 * w, horizontal = bearing - 0.235 * w;
  for (const auto& [x, title] : {std::pair{horizontal, "horizontal"}, {bearing, "bearing"}, {slant, "slant"}})
    draw_text_right(painter, {x, base_of(0)}, QString::fromLatin1(title), small, colours.of(Role::text_2));
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    const RangeRow& row = rows_[i];
    const int at = static_cast<int>(i) + 1;
    const QString pair = q(row.from) + QStringLiteral(" → ") + q(row.to);
    const bool stale = row.state == ValueState::stale || row.state == ValueState::lost;
    const double end =
        draw_text(painter, {8, base_of(at)}, elided(pair, small, horizontal - 0.22 * w - (stale ? 26 : 8)),
                  small, colours.of(ink_of(row.state)));
    if (stale)
      draw_icon(painter, {end + 11, (at + 0.5) * kTableRow - 0.5},
                row.state == ValueState::lost ? QStringLiteral("cross") : QStringLiteral("clock"), 13,
                colours.of(Role::text_2));
    draw_figure(painter, horizontal, at, row.horizontal, row.state, 0.22 * w, colours);
    draw_figure(painter, bearing, at, row.bearing, row.state, 0.22 * w, colours);
    draw_figure(painter, slant, at, row.slant, row.state, 0.19 * w, colours);
  }
}

}  // namespace leadline::ui
