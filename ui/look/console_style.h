#pragma once

#include <QProxyStyle>

namespace leadline::ui {

/// Fusion with check boxes, tab edges and the ring of a row from roles. The ring around a whole widget is
/// FocusRing's, as a style paints inside a widget only.
class ConsoleStyle final : public QProxyStyle {
 public:
  ConsoleStyle();

  void drawPrimitive(PrimitiveElement element, const QStyleOption* option, QPainter* painter,
                     const QWidget* widget) const override;
  int pixelMetric(PixelMetric metric, const QStyleOption* option, const QWidget* widget) const override;
  int styleHint(StyleHint hint, const QStyleOption* option, const QWidget* widget,
                QStyleHintReturn* returned) const override;
};

}  // namespace leadline::ui
