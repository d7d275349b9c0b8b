#include "core/nav/engines/registry.h"

#include <array>
#include <string>

#include "core/nav/engines/dead_reckoning_engine.h"
#include "core/nav/engines/fusion_engine.h"

namespace leadline::nav {

std::span<const EngineInfo> engines() {
  static constexpr std::array<EngineInfo, 2> kEngines{{
      {"dead-reckoning", "DVL and heading summed up from the first fix; uses no fix after it"},
      {"fusion",
       "dead reckoning and position fixes by covariance intersection (Kim, Choi, Lee 2010, corrected)"},
  }};
  return kEngines;
}

Result<std::unique_ptr<Engine>> make_engine(std::string_view name, const EngineSetup& setup) {
  if (name == "dead-reckoning") return std::unique_ptr<Engine>(std::make_unique<DeadReckoningEngine>(setup));
  if (name == "fusion") return std::unique_ptr<Engine>(std::make_unique<FusionEngine>(setup));
  std::string known;
  for (const auto& engine : engines()) known += (known.empty() ? "" : ", ") + std::string(engine.name);
  return Error{"no engine is called \"" + std::string(name) + "\"", "--engine", "this build has " + known};
}

}  // namespace leadline::nav
