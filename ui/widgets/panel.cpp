#include "ui/widgets/panel.h"

#include <QPainter>

#include "ui/look/look.h"
#include "ui/widgets/paint_text.h"

namespace leadline::ui {

Panel::Panel(const char* object_name, const QString& name, QWidget* parent) : QWidget(parent), name_(name) {
  setObjectName(QString::fromLatin1(object_name));
  setAccessibleName(name);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
}

void Panel::set_heading(const QString& subject, const QString& fact) {
  if (subject == subject_ && fact == fact_) return;
  subject_ = subject;
  fact_ = fact;
  update();
}

void Panel::set_absent(const QString& why) {
  if (why == absent_) return;
  absent_ = why;
  setAccessibleDescription(why);
  update();
}

QRect Panel::body() const { return rect().adjusted(kPad, kTitle, -kPad, -kPad); }

void Panel::paintEvent(QPaintEvent* /*event*/) {
  const Colours& colours = Look::current().colours();
  QPainter painter(this);
  painter.fillRect(rect(), colours.of(Role::bg_panel));
  painter.setPen(colours.of(Role::line));
  painter.setBrush(Qt::NoBrush);
  painter.drawRect(rect().adjusted(0, 0, -1, -1));
  const QFont title = title_font(), small = ui::font(12);
  const double y = base_line(kTitle / 2.0 + 0.5, title), right = width() - 11;
  const double x = draw_text(painter, {11, y}, name_.toUpper(), title, colours.of(Role::text)) + 11;
  const double fact_room = right - x - 10;
  const QString fact = elided(fact_, small, fact_room);
  const double fact_left = draw_text_right(painter, {right, y}, fact, small, colours.of(Role::text_2));
  draw_text(painter, {x, y}, elided(subject_, small, fact_left - x - 10), small, colours.of(Role::text_2));
  if (!absent_.isEmpty()) {
    const QRect rest = body();
    draw_text(painter, {rest.left() + 5.0, rest.top() + 16.0},
              elided(absent_, ui::font(13), rest.width() - 10), ui::font(13), colours.of(Role::text_2));
  }
}

}  // namespace leadline::ui
