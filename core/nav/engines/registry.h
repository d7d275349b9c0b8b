#pragma once

#include <memory>
#include <span>
#include <string_view>

#include "core/flow/engine.h"
#include "core/nav/engines/options.h"
#include "core/nav/motion/body_attitude.h"
#include "core/types/result.h"

namespace leadline::nav {

struct EngineInfo {
  std::string_view name, help;
};
/// The engines of this build.
[[nodiscard]] std::span<const EngineInfo> engines();

/// Everything an engine is made from; sources and magnetic outlive it.
struct EngineSetup {
  EngineId id = 0;
  Body body = Body::vehicle;
  Options options;
  std::span<const SourceInfo> sources;
  const geo::MagneticModel* magnetic = nullptr;
};
/// Error: no engine of that name.
[[nodiscard]] Result<std::unique_ptr<Engine>> make_engine(std::string_view name, const EngineSetup& setup);

}  // namespace leadline::nav
