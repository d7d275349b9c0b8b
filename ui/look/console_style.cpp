#include "ui/look/console_style.h"

#include <QAbstractItemView>
#include <QPainter>
#include <QPainterPath>
#include <QStyleFactory>
#include <QStyleOption>

#include "ui/look/look.h"

namespace leadline::ui {
namespace {

void draw_check_box(QPainter& painter, const QStyleOption& option, const Colours& colours) {
  const bool enabled = option.state.testFlag(QStyle::State_Enabled);
  const QRectF box = QRectF(option.rect).adjusted(0.5, 0.5, -0.5, -0.5);
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(QPen(colours.of(enabled ? Role::line_strong : Role::line), 1.0));
  painter.setBrush(colours.of(enabled ? Role::bg_tile : Role::bg_panel));
  painter.drawRoundedRect(box, 2, 2);
  painter.setPen(QPen(colours.of(enabled ? Role::text : Role::text_off), 2.0, Qt::SolidLine, Qt::RoundCap,
                      Qt::RoundJoin));
  const double w = box.width(), h = box.height();
  if (option.state.testFlag(QStyle::State_On)) {
    QPainterPath tick(box.topLeft() + QPointF(0.22 * w, 0.54 * h));
    tick.lineTo(box.topLeft() + QPointF(0.43 * w, 0.75 * h));
    tick.lineTo(box.topLeft() + QPointF(0.80 * w, 0.28 * h));
    painter.setBrush(Qt::NoBrush);
    painter.drawPath(tick);
  } else if (option.state.testFlag(QStyle::State_NoChange)) {
    painter.drawLine(box.center() - QPointF(0.25 * w, 0), box.center() + QPointF(0.25 * w, 0));
  }
  painter.restore();
}

}  // namespace

ConsoleStyle::ConsoleStyle() : QProxyStyle(QStyleFactory::create(QStringLiteral("Fusion"))) {}

void ConsoleStyle::drawPrimitive(PrimitiveElement element, const QStyleOption* option, QPainter* painter,
                                 const QWidget* widget) const {
  const Colours& colours = Look::current().colours();
  switch (element) {
    case PE_FrameFocusRect:
      // Around a widget stands FocusRing; only a row within a view is ringed here.
      if (qobject_cast<const QAbstractItemView*>(widget)) {
        painter->save();
        painter->setBrush(Qt::NoBrush);
        painter->setPen(QPen(colours.of(Role::focus), 2.0));
        painter->drawRect(option->rect.adjusted(1, 1, -1, -1));
        painter->restore();
      }
      return;
    case PE_IndicatorCheckBox:
    case PE_IndicatorItemViewItemCheck:
      draw_check_box(*painter, *option, colours);
      return;
    case PE_FrameTabWidget:
    case PE_FrameTabBarBase:
      painter->save();
      painter->setBrush(Qt::NoBrush);
      painter->setPen(QPen(colours.of(Role::line), 1.0));
      if (element == PE_FrameTabWidget)
        painter->drawRect(option->rect.adjusted(0, 0, -1, -1));
      else
        painter->drawLine(option->rect.bottomLeft(), option->rect.bottomRight());
      painter->restore();
      return;
    default:
      QProxyStyle::drawPrimitive(element, option, painter, widget);
  }
}

int ConsoleStyle::pixelMetric(PixelMetric metric, const QStyleOption* option, const QWidget* widget) const {
  switch (metric) {
    case PM_IndicatorWidth:
    case PM_IndicatorHeight:
      return 16;
    case PM_SplitterWidth:
      return 1;
    case PM_ScrollBarExtent:
      return 12;
    default:
      return QProxyStyle::pixelMetric(metric, option, widget);
  }
}

int ConsoleStyle::styleHint(StyleHint hint, const QStyleOption* option, const QWidget* widget,
                            QStyleHintReturn* returned) const {
  if (hint == SH_Widget_Animation_Duration) return 0;  // nothing moves without a reason
  if (hint == SH_EtchDisabledText || hint == SH_DitherDisabledText) return 0;
  return QProxyStyle::styleHint(hint, option, widget, returned);
}

}  // namespace leadline::ui
