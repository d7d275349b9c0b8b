#pragma once

#include <QPainter>

#include "core/messages/bookkeeping.h"
#include "ui/look/colours.h"
#include "ui/models/bar_text.h"

namespace leadline::ui {

/// The roles of one priority.
struct AlertRoles {
  Role fill, on, mark, icon, glyph;
};
[[nodiscard]] AlertRoles alert_roles(Alarm::Priority priority);
/// "WARNING"
[[nodiscard]] const char* alert_word(Alarm::Priority priority);

enum class AlertGround : std::uint8_t {
  panel,  ///< a neutral ground: the icon brings its colour
  fill,   ///< on the priority's own fill: shape in `on`, glyph in the fill
};

/// Shape is the priority (two triangles, triangle, circle, square), glyph the state. After the public
/// description of IEC 62923-1. A caution has no sound, so its glyph is never a speaker.
void draw_alert_icon(QPainter& painter, QPointF centre, double size, Alarm::Priority priority, AlertMark mark,
                     const Colours& colours, AlertGround ground = AlertGround::panel);

}  // namespace leadline::ui
