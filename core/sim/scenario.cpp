#include "core/sim/scenario.h"

#include <array>

#include "core/types/expect.h"

namespace leadline::sim {

std::span<const Key<ScenarioOptions>> scenario_keys() {
  using O = ScenarioOptions;
  static const std::array<Key<O>, 11> keys{{
      {"name", &O::name, "of the vehicle in the configuration"},
      {"start_utc", &O::start_utc, "YYYY-MM-DDThh:mm:ssZ"},
      {"duration_s", &O::duration_s, "of the whole", 0.01, 1e6},
      {"step_s", &O::step_s, "of the grid on which set points are worked out", 1e-3, 1},
      {"truth_hz", &O::truth_hz, "rows of truth.csv a second", 1e-3, 1000},
      {"seed", &O::seed, "of the noise; --seed wins", 0, 9e15},
      {"lat_deg", &O::lat_deg, "of the origin", -85, 85},
      {"lon_deg", &O::lon_deg, "of the origin", -180, 180},
      {"body",
       &O::body,
       "whose solution is wanted, and whose truth truth.csv holds",
       0,
       0,
       {"vehicle", "ship"}},
      {"engine", &O::engine, "in the configuration"},
      {"initial_known", &O::initial_known, "the configuration gives the true start"},
  }};
  return keys;
}

Geodetic Scenario::origin() const {
  return {Angle::deg(options.lat_deg), Angle::deg(options.lon_deg).wrapped_pi()};
}

Time Scenario::start() const {
  const auto start = parse_iso8601(options.start_utc);
  LL_EXPECT(start.has_value());
  return *start;
}

}  // namespace leadline::sim
