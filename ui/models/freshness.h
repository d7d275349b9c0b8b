#pragma once

#include "core/types/time.h"
#include "ui/models/tile_text.h"

namespace leadline::ui {

/// Above these ages a value is ageing, stale, lost. period_s: the nominal interval of its source; 0: unknown.
struct AgeLimits {
  double ageing_s, stale_s, lost_s;
};
[[nodiscard]] AgeLimits age_limits(double period_s);

/// live, ageing, stale or lost.
[[nodiscard]] ValueState freshness(Duration age, double period_s);

/// Where several hold: lost, stale, alert, disagree, pending, ageing, live.
[[nodiscard]] constexpr ValueState worse(ValueState a, ValueState b) { return a > b ? a : b; }

/// One sigma of a position that nobody renews, metres: sigma + (last speed + 0.1 m/s) age.
[[nodiscard]] double grown_sigma_m(double sigma_m, double last_speed_mps, Duration age);

}  // namespace leadline::ui
