#include "ui/widgets/value_tile.h"

#include <QHelpEvent>
#include <QToolTip>

#include "ui/look/look.h"
#include "ui/widgets/spoken.h"

namespace leadline::ui {

ValueTile::ValueTile(TileStyle style, QWidget* parent) : QWidget(parent), style_(style) {
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
}

void ValueTile::set(const std::optional<TileText>& text) {
  if (text == text_) return;
  text_ = text;
  setAccessibleName(text_ ? spoken(*text_) : QString());
  update();
}

QSize ValueTile::sizeHint() const {
  const int height = text_ && !text_->value_2.empty() ? kPositionTileHeight
                     : style_.value_px > 18           ? kTileHeight
                                                      : kSmallTileHeight;
  return {170, height};
}

bool ValueTile::event(QEvent* event) {
  if (event->type() == QEvent::ToolTip && text_) {
    QToolTip::showText(static_cast<QHelpEvent*>(event)->globalPos(), explained(*text_), this);
    return true;
  }
  return QWidget::event(event);
}

void ValueTile::paintEvent(QPaintEvent* /*event*/) {
  if (!text_) return;
  QPainter painter(this);
  draw_tile(painter, rect(), *text_, Look::current().colours(), style_);
}

}  // namespace leadline::ui
