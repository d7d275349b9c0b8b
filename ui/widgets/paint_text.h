#pragma once

#include <QFont>
#include <QPainter>
#include <QString>
#include <string>

#include "ui/look/colours.h"

namespace leadline::ui {

[[nodiscard]] inline QString q(const std::string& text) { return QString::fromStdString(text); }

[[nodiscard]] double text_width(const QString& text, const QFont& font);
[[nodiscard]] QString elided(const QString& text, const QFont& font, double width);

/// Draws at the left end of the base line and returns where the text ends.
double draw_text(QPainter& painter, QPointF at, const QString& text, const QFont& font, const QColor& colour);
/// `at`: the right end of the base line; returns where the text begins.
double draw_text_right(QPainter& painter, QPointF at, const QString& text, const QFont& font,
                       const QColor& colour);
void draw_text_centred(QPainter& painter, QPointF at, const QString& text, const QFont& font,
                       const QColor& colour);

/// The base line that centres capitals of a font on y.
[[nodiscard]] double base_line(double y, const QFont& font);

/// Panel titles: bold capitals, a little wide.
[[nodiscard]] QFont title_font();

/// Diagonal stripes, 6 px of tile and 3 px of panel: what is stale.
void draw_hatch(QPainter& painter, const QRectF& rect, const QColor& stripe);

/// A one-pixel rule on whole pixels.
void draw_rule(QPainter& painter, QPoint from, QPoint to, const QColor& colour);

}  // namespace leadline::ui
