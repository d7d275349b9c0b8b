#include "ui/widgets/button.h"

#include <QPainter>
#include <cmath>

#include "ui/look/icon.h"
#include "ui/look/look.h"
#include "ui/widgets/paint_text.h"

namespace leadline::ui {
namespace {

constexpr int kHeight = 28, kPad = 11, kIcon = 18;

}  // namespace

Button::Button(const char* name, const QString& icon, const QString& text, const QString& tip,
               QWidget* parent, Kind kind)
    : QAbstractButton(parent), icon_(icon), kind_(kind) {
  setObjectName(QString::fromLatin1(name));
  setText(text);
  setToolTip(tip);
  setAccessibleName(text);
  setFocusPolicy(Qt::StrongFocus);
  setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
  icon_only_ = !icon.isEmpty() && text.isEmpty();
}

void Button::set_icon(const QString& icon) {
  if (icon == icon_) return;
  icon_ = icon;
  update();
}

void Button::set_icon_only(bool icon_only) {
  if (icon_only == icon_only_) return;
  icon_only_ = icon_only;
  updateGeometry();
  update();
}

QSize Button::sizeHint() const {
  if (icon_only_) return {34, kHeight};
  const double words = std::ceil(text_width(text(), ui::font(13)));
  return {static_cast<int>(words) + 2 * kPad + (icon_.isEmpty() ? 0 : kIcon + 6), kHeight};
}

void Button::paintEvent(QPaintEvent* /*event*/) {
  const Colours& colours = Look::current().colours();
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const bool primary = kind_ == Kind::primary && isEnabled();
  const bool down = isDown() || isChecked();
  const Role fill = !isEnabled() ? Role::bg_panel
                    : primary    ? (down ? Role::text_2 : Role::text)
                    : down       ? Role::select
                                 : Role::bg_raised;
  const Role ink = !isEnabled() ? Role::text_off : primary ? Role::bg_raised : Role::text;
  const Role edge = !isEnabled() ? Role::line : underMouse() ? Role::text : Role::line_strong;
  painter.setPen(QPen(colours.of(edge), 1.0));
  painter.setBrush(colours.of(fill));
  painter.drawRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), 3, 3);
  const QFont words = ui::font(13, primary);
  const double y = height() / 2.0;
  if (icon_only_) return draw_icon(painter, QRectF(rect()).center(), icon_, kIcon, colours.of(ink));
  const double content = text_width(text(), words) + (icon_.isEmpty() ? 0 : kIcon + 6);
  double x = (width() - content) / 2;
  if (!icon_.isEmpty()) {
    draw_icon(painter, {x + kIcon / 2.0, y}, icon_, kIcon, colours.of(ink));
    x += kIcon + 6;
  }
  draw_text(painter, {x, base_line(y, words)}, text(), words, colours.of(ink));
}

}  // namespace leadline::ui
