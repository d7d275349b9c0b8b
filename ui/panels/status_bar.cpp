#include "ui/panels/status_bar.h"

#include <QPainter>
#include <vector>

#include "ui/look/look.h"
#include "ui/widgets/paint_text.h"

namespace leadline::ui {
namespace {

constexpr int kPad = 14;

/// A read-out of fixed width: label, value, remark.
struct Cell {
  int width;
  QString label, value, remark;
};

void paint_cell(QPainter& painter, int left, int height, const Cell& cell, const Colours& colours) {
  const QFont small = font(12);
  const double base = base_line(height / 2.0, small), right = left + cell.width - 8;
  double x = left + kPad;
  const auto part = [&](const QString& words, Role role) {
    if (words.isEmpty() || x >= right) return;
    x = draw_text(painter, {x, base}, elided(words, small, right - x), small, colours.of(role)) + 8;
  };
  part(cell.label, Role::text_2);
  part(cell.value, Role::text);
  part(cell.remark, Role::text_2);
}

}  // namespace

StatusBar::StatusBar(QWidget* parent) : QWidget(parent) {
  setObjectName(QStringLiteral("statusBar"));
  setAccessibleName(QStringLiteral("Status"));
  set_fold(Fold::wide);
}

void StatusBar::set(const StatusBarText& text) {
  if (text == text_) return;
  text_ = text;
  update();
}

void StatusBar::set_fold(Fold fold) {
  fold_ = fold;
  setFixedHeight(sizeHint().height());
  update();
}

QSize StatusBar::sizeHint() const {
  return {800, fold_ == Fold::wide ? 28 : fold_ == Fold::compact ? 24 : 22};
}

void StatusBar::paintEvent(QPaintEvent* /*event*/) {
  const Colours& colours = Look::current().colours();
  QPainter painter(this);
  painter.fillRect(rect(), colours.of(Role::bg_panel));
  draw_rule(painter, {0, 0}, {width() - 1, 0}, colours.of(Role::line));
  const QString off = QStringLiteral("− − −");
  const QString from = text_.from.empty() ? QString() : QStringLiteral("from ") + q(text_.from);
  // In the order of their worth: what does not fit is left out from the end.
  std::vector<Cell> left{{288, QStringLiteral("Cursor"), text_.cursor.empty() ? off : q(text_.cursor), {}}};
  std::vector<Cell> right;
  if (fold_ != Fold::small) {
    left.push_back({232, from, text_.range.empty() ? off : q(text_.range), {}});
    left.push_back(
        {208, QStringLiteral("Depth"), text_.depth.empty() ? off : q(text_.depth), q(text_.depth_layer)});
    left.push_back({168, {}, {}, q(text_.datum)});
    left.push_back({120, q(text_.tool), q(text_.tool_key), {}});
    right.push_back({74, {}, {}, QStringLiteral("F1 help")});
    right.push_back({158, QStringLiteral("Links"), q(text_.links), {}});
    if (!text_.user.empty()) right.push_back({158, QStringLiteral("Operator"), q(text_.user), {}});
    right.push_back({190, QStringLiteral("Screen"), q(text_.screen), {}});
  }
  int begin = 0, end = width();
  std::size_t l = 0, r = 0;
  // Taken by turns, so that neither side starves the other.
  while (l < left.size() || r < right.size()) {
    const bool fits_left = l < left.size() && begin + left[l].width <= end;
    if (fits_left) {
      paint_cell(painter, begin, height(), left[l], colours);
      begin += left[l].width;
      draw_rule(painter, {begin, 1}, {begin, height() - 1}, colours.of(Role::line));
    }
    ++l;
    const bool fits_right = r < right.size() && end - right[r].width >= begin;
    if (fits_right) {
      end -= right[r].width;
      paint_cell(painter, end, height(), right[r], colours);
      draw_rule(painter, {end, 1}, {end, height() - 1}, colours.of(Role::line));
    }
    ++r;
  }
}

}  // namespace leadline::ui
