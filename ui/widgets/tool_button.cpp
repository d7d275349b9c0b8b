#include "ui/widgets/tool_button.h"

#include <QPainter>

#include "ui/look/icon.h"
#include "ui/look/look.h"

namespace leadline::ui {

ToolButton::ToolButton(const char* name, const QString& icon, const QString& words, const QString& key,
                       QWidget* parent)
    : QAbstractButton(parent), icon_(icon) {
  setObjectName(QString::fromLatin1(name));
  setAccessibleName(words);
  setToolTip(key.isEmpty() ? words : QStringLiteral("%1  (%2)").arg(words, key));
  setFocusPolicy(Qt::StrongFocus);
  setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
}

void ToolButton::paintEvent(QPaintEvent* /*event*/) {
  const Colours& colours = Look::current().colours();
  QPainter painter(this);
  if (isChecked() || isDown()) {
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    painter.setBrush(colours.of(Role::select));
    painter.drawRoundedRect(rect(), 3, 3);
    painter.fillRect(QRect(0, 0, 3, height()), colours.of(Role::text));
  } else if (underMouse() && isEnabled()) {
    painter.fillRect(rect(), colours.of(Role::bg_raised));
  }
  const Role ink = !isEnabled() ? Role::text_off : isChecked() || isDown() ? Role::text : Role::text_2;
  draw_icon(painter, QRectF(rect()).center(), icon_, 20, colours.of(ink));
}

}  // namespace leadline::ui
