#include "core/nav/engines/registry.h"

#include <array>
#include <string>

#include "core/nav/engines/dead_reckoning_engine.h"
#include "core/nav/engines/ekf7_engine.h"
#include "core/nav/engines/fusion_engine.h"

namespace leadline::nav {

std::span<const EngineInfo> engines() {
  static constexpr std::array<EngineInfo, 3> kEngines{{
      {"dead-reckoning", "DVL and heading summed up from the first fix; uses no fix after it"},
      {"fusion",
       "dead reckoning and position fixes: an error-state filter, or covariance intersection (Kim, Choi, Lee "
       "2010, corrected)"},
      {"ekf7",
       "compass, DVL and GNSS by a filter of seven states that finds the heading's bias (Kang, Lee, Yoon "
       "2017)"},
  }};
  return kEngines;
}

Result<std::unique_ptr<Engine>> make_engine(std::string_view name, const EngineSetup& setup) {
  if (name == "dead-reckoning") return std::unique_ptr<Engine>(std::make_unique<DeadReckoningEngine>(setup));
  if (name == "fusion") return std::unique_ptr<Engine>(std::make_unique<FusionEngine>(setup));
  if (name == "ekf7") return std::unique_ptr<Engine>(std::make_unique<Ekf7Engine>(setup));
  std::string known;
  for (const auto& engine : engines()) known += (known.empty() ? "" : ", ") + std::string(engine.name);
  return Error{"no engine is called \"" + std::string(name) + "\"", "--engine", "this build has " + known};
}

}  // namespace leadline::nav
