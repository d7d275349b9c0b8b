#include "ui/models/freshness.h"

#include <algorithm>

namespace leadline::ui {

AgeLimits age_limits(double period_s) {
  return {std::max(2.0 * period_s, 1.0), std::max(5.0 * period_s, 3.0), std::max(20.0 * period_s, 60.0)};
}

ValueState freshness(Duration age, double period_s) {
  const AgeLimits limits = age_limits(period_s);
  return age > duration(limits.lost_s)     ? ValueState::lost
         : age > duration(limits.stale_s)  ? ValueState::stale
         : age > duration(limits.ageing_s) ? ValueState::ageing
                                           : ValueState::live;
}

double grown_sigma_m(double sigma_m, double last_speed_mps, Duration age) {
  return sigma_m + (last_speed_mps + 0.1) * std::max(seconds(age), 0.0);
}

}  // namespace leadline::ui
