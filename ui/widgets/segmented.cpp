#include "ui/widgets/segmented.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <cmath>

#include "ui/look/look.h"
#include "ui/widgets/paint_text.h"

namespace leadline::ui {
namespace {

constexpr int kHeight = 28;

int width_of(const QString& word, int pad) {
  return std::max(34, static_cast<int>(std::ceil(text_width(word, font(13, true)))) + 2 * pad);
}

}  // namespace

Segmented::Segmented(const char* name, const QString& words, const QStringList& options, QWidget* parent)
    : QWidget(parent), words_(words), options_(options) {
  setObjectName(QString::fromLatin1(name));
  setFocusPolicy(Qt::StrongFocus);
  setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
  setToolTip(words);
  name_current();
}

void Segmented::set_current(int index) {
  if (index == current_) return;
  current_ = index;
  name_current();
  update();
}

void Segmented::set_close(bool close) {
  pad_ = close ? 7 : 11;
  updateGeometry();
  update();
}

void Segmented::name_current() {
  setAccessibleName(current_ < 0 ? words_ : words_ + QStringLiteral(", ") + options_.at(current_));
}

QRect Segmented::segment(int index) const {
  int x = 0;
  for (int i = 0; i < index; ++i) x += width_of(options_.at(i), pad_);
  return {x, 0, width_of(options_.at(index), pad_), kHeight};
}

QSize Segmented::sizeHint() const {
  const QRect last = segment(options_.size() - 1);
  return {last.right() + 1, kHeight};
}

void Segmented::choose(int index) {
  if (index < 0 || index >= options_.size() || index == current_) return;
  set_current(index);
  emit chosen(index);
}

void Segmented::paintEvent(QPaintEvent* /*event*/) {
  const Colours& colours = Look::current().colours();
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const QRectF whole = QRectF(QPointF(), QSizeF(sizeHint())).adjusted(0.5, 0.5, -0.5, -0.5);
  QPainterPath outline;
  outline.addRoundedRect(whole, 3, 3);
  painter.fillPath(outline, colours.of(isEnabled() ? Role::bg_raised : Role::bg_panel));
  for (int i = 0; i < options_.size(); ++i) {
    const QRect box = segment(i);
    const bool in_force = i == current_ && isEnabled();
    if (in_force) {
      QPainterPath fill;
      fill.addRect(box);
      painter.fillPath(fill.intersected(outline), colours.of(Role::replay));
    }
    if (i > 0) draw_rule(painter, box.topLeft(), box.bottomLeft(), colours.of(Role::line_strong));
    const QFont words = ui::font(13, in_force);
    const Role ink = !isEnabled() ? Role::text_off : in_force ? Role::replay_on : Role::text;
    draw_text_centred(painter, {QRectF(box).center().x(), base_line(kHeight / 2.0, words)}, options_.at(i),
                      words, colours.of(ink));
  }
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(colours.of(Role::line_strong), 1.0));
  painter.drawPath(outline);
}

void Segmented::mousePressEvent(QMouseEvent* event) {
  for (int i = 0; i < options_.size(); ++i)
    if (segment(i).contains(event->pos())) choose(i);
}

void Segmented::keyPressEvent(QKeyEvent* event) {
  switch (event->key()) {
    case Qt::Key_Left:
      return choose(current_ - 1);
    case Qt::Key_Right:
      return choose(current_ + 1);
    case Qt::Key_Home:
      return choose(0);
    case Qt::Key_End:
      return choose(options_.size() - 1);
    default:
      QWidget::keyPressEvent(event);
  }
}

}  // namespace leadline::ui
