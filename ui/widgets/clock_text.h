#pragma once

#include <QString>

#include "core/types/time.h"

namespace leadline::ui {

/// "14:02:37 Z"; decimals 0..3 are cut, not rounded, as a clock does.
[[nodiscard]] QString clock_text(Time time, int decimals = 0);
/// "14:02 Z"
[[nodiscard]] QString hour_text(Time time);
/// "2 h 41 min", "4 min 12 s", "12 s"
[[nodiscard]] QString duration_words(Duration length);

}  // namespace leadline::ui
