#include "ui/widgets/link_table.h"

#include <QHelpEvent>
#include <QKeyEvent>
#include <QPainter>
#include <QScrollBar>
#include <QTextDocument>
#include <QToolTip>
#include <algorithm>
#include <array>

#include "ui/look/icon.h"
#include "ui/look/look.h"
#include "ui/widgets/alert_icon.h"
#include "ui/widgets/paint_text.h"
#include "ui/widgets/spoken.h"
#include "ui/widgets/table.h"

namespace leadline::ui {
namespace {

constexpr int kWords = 3;  ///< columns of words; the others are figures
constexpr std::array<int, kLinkColumns.size()> kNarrow{0, 0, 0, 64, 82, 72, 60, 62, 52, 50};
constexpr std::array<int, kLinkColumns.size()> kRoomy{0, 0, 0, 84, 96, 84, 84, 84, 72, 72};
constexpr int kMark = 26, kGap = 10, kEdge = 8;

struct Column {
  double left = 0.0, right = 0.0;
};

/// Figures have a width each; names, addresses and troubles share what is left.
std::array<Column, kLinkColumns.size()> columns(int width) {
  const bool narrow = width < 1100;
  const auto& figures = narrow ? kNarrow : kRoomy;
  std::array<Column, kLinkColumns.size()> made;
  double right = width - kEdge;
  for (std::size_t i = made.size(); i-- > kWords;) {
    made[i] = {right - figures[i] + kGap, right};
    right -= figures[i];
  }
  const double room = std::max(0.0, right - kMark);
  const auto shares = narrow ? std::array{0.2, 0.4, 0.4} : std::array{0.2, 0.3, 0.5};
  double left = kMark;
  for (std::size_t i = 0; i < kWords; ++i) {
    const double share = room * shares[i];
    made[i] = {left, left + share - kGap};
    left += share;
  }
  return made;
}

double base_of(int top) { return base_line(top + 0.5 * kTableRow, ui::font(12)); }

void draw_mark(QPainter& painter, QPointF centre, const LinkRow& row, const Colours& colours) {
  if (row.state == LinkRow::State::failed)
    return draw_alert_icon(painter, centre, 14, Alarm::Priority::caution, AlertMark::unacknowledged, colours);
  const bool open = row.state == LinkRow::State::open;
  draw_icon(painter, centre, open ? QStringLiteral("check") : QStringLiteral("cross"), 13,
            colours.of(Role::text_2));
}

/// What a row says to eyes that look closer and to ears.
QString told(const LinkRow& row) {
  const LinkCells cells = link_cells(row);
  QStringList words;
  for (std::size_t i = 0; i < cells.size(); ++i)
    if (!cells[i].empty()) words << QString::fromLatin1(kLinkColumns[i]) + ' ' + q(cells[i]);
  if (const std::string trouble = link_trouble(row); !trouble.empty()) words << q(trouble);
  return words.join(QStringLiteral(", "));
}

}  // namespace

LinkTable::LinkTable(QWidget* parent) : QAbstractScrollArea(parent) {
  setObjectName(QStringLiteral("linkTable"));
  setAccessibleName(QStringLiteral("Links"));
  setFrameShape(QFrame::NoFrame);
  setFocusPolicy(Qt::StrongFocus);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  verticalScrollBar()->setSingleStep(kTableRow);
  connect(&Look::current(), &Look::lookChanged, viewport(), qOverload<>(&QWidget::update));
}

void LinkTable::set(const std::vector<LinkRow>& rows) {
  if (rows == rows_) return;
  const bool grown = rows.size() != rows_.size();
  rows_ = rows;
  if (selected_ >= static_cast<int>(rows_.size())) selected_ = -1;
  QStringList words;
  for (const LinkRow& row : rows_) words << told(row);
  setAccessibleDescription(words.join(QStringLiteral("; ")));
  if (grown) {
    set_range();
    updateGeometry();
  }
  viewport()->update();
}

void LinkTable::select(int row) {
  if (row == selected_ || row >= static_cast<int>(rows_.size())) return;
  selected_ = row;
  const int top = row * kTableRow, room = viewport()->height() - kTableRow;
  QScrollBar* bar = verticalScrollBar();
  if (row >= 0) bar->setValue(std::clamp(bar->value(), std::min(top, top + kTableRow - room), top));
  viewport()->update();
}

void LinkTable::choose(int row) {
  if (rows_.empty()) return;
  row = std::clamp(row, 0, static_cast<int>(rows_.size()) - 1);
  if (row == selected_) return;
  select(row);
  emit chosen(row);
}

QSize LinkTable::sizeHint() const { return {760, kTableRow * (static_cast<int>(rows_.size()) + 1)}; }

void LinkTable::set_range() {
  const int room = viewport()->height() - kTableRow;
  verticalScrollBar()->setPageStep(std::max(room, kTableRow));
  verticalScrollBar()->setRange(0, std::max(0, static_cast<int>(rows_.size()) * kTableRow - room));
}

int LinkTable::row_at(int y) const {
  const int row = (y - kTableRow + verticalScrollBar()->value()) / kTableRow;
  return y >= kTableRow && row < static_cast<int>(rows_.size()) ? row : -1;
}

void LinkTable::resizeEvent(QResizeEvent* /*event*/) { set_range(); }

void LinkTable::mousePressEvent(QMouseEvent* event) {
  if (const int row = row_at(event->y()); row >= 0) choose(row);
}

void LinkTable::keyPressEvent(QKeyEvent* event) {
  const int last = static_cast<int>(rows_.size()) - 1;
  switch (event->key()) {
    case Qt::Key_Up:
      return choose(selected_ - 1);
    case Qt::Key_Down:
      return choose(selected_ + 1);
    case Qt::Key_Home:
      return choose(0);
    case Qt::Key_End:
      return choose(last);
    default:
      return QAbstractScrollArea::keyPressEvent(event);
  }
}

bool LinkTable::viewportEvent(QEvent* event) {
  if (event->type() != QEvent::ToolTip) return QAbstractScrollArea::viewportEvent(event);
  const auto& help = static_cast<const QHelpEvent&>(*event);
  const int row = row_at(help.y());
  // An error may quote anything: it is shown as the plain text it is.
  if (row >= 0)
    QToolTip::showText(help.globalPos(), Qt::convertFromPlainText(told(rows_[static_cast<std::size_t>(row)])),
                       viewport());
  else
    QToolTip::hideText();
  return true;
}

void LinkTable::paintEvent(QPaintEvent* /*event*/) {
  const Colours& colours = Look::current().colours();
  QPainter painter(viewport());
  const QRect all = viewport()->rect();
  painter.fillRect(all, colours.of(Role::bg_tile));
  const auto places = columns(all.width());
  const QFont small = ui::font(12);
  const auto cell = [&](std::size_t column, int top, const std::string& text, Role role, bool bold = false) {
    const QFont font = ui::font(12, bold);
    const Column& at = places[column];
    // What tells one address from another is at either end.
    const QString shown = QFontMetricsF(font).elidedText(text.empty() ? QStringLiteral("− − −") : q(text),
                                                         column == 1 ? Qt::ElideMiddle : Qt::ElideRight,
                                                         std::max(0.0, at.right - at.left));
    const QColor ink = colours.of(text.empty() ? Role::text_2 : role);
    if (column < kWords)
      draw_text(painter, {at.left, base_of(top)}, shown, font, ink);
    else
      draw_text_right(painter, {at.right, base_of(top)}, shown, font, ink);
  };
  painter.setClipRect(all.adjusted(0, kTableRow, 0, 0));
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    const LinkRow& row = rows_[i];
    const int top = kTableRow * (static_cast<int>(i) + 1) - verticalScrollBar()->value();
    if (static_cast<int>(i) == selected_)
      painter.fillRect(QRect(0, top, all.width(), kTableRow - 1), colours.of(Role::select));
    draw_rule(painter, {0, top + kTableRow - 1}, {all.width() - 1, top + kTableRow - 1},
              colours.of(Role::line));
    draw_mark(painter, {kMark / 2.0, top + kTableRow / 2.0 - 0.5}, row, colours);
    const LinkCells cells = link_cells(row);
    const bool silent = row.heard == ValueState::stale || row.heard == ValueState::lost;
    for (std::size_t column = 0; column + 1 < cells.size(); ++column)
      cell(column, top, cells[column], row.state == LinkRow::State::open ? Role::text : Role::text_2,
           column == 2 && row.state == LinkRow::State::failed);
    cell(cells.size() - 1, top, cells.back(), Role::text, silent);
  }
  painter.setClipping(false);
  for (std::size_t i = 0; i < kLinkColumns.size(); ++i) cell(i, 0, kLinkColumns[i], Role::text_2);
  draw_rule(painter, {0, kTableRow - 1}, {all.width() - 1, kTableRow - 1}, colours.of(Role::line));
}

}  // namespace leadline::ui
