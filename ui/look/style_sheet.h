#pragma once

#include <QString>

#include "ui/look/colours.h"

namespace leadline::ui {

/// console.qss with its tokens filled in: @role (dots as in the table), @sp1 and @sp2 for 4 and 8 px.
[[nodiscard]] QString style_sheet(const Colours& colours);

}  // namespace leadline::ui
