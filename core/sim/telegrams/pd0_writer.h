#pragma once

#include "core/sim/sensors/dvl.h"
#include "core/sim/telegrams/telegrams.h"
#include "core/types/time.h"

namespace leadline::sim {

/// One PD0 ensemble of leaders and bottom track: the mirror of decode's trdi-pd0 (Pathfinder DVL Guide, April
/// 2018). Resolution: 1 mm/s (0.01 mm/s with high_resolution), 0.01 deg, 1 cm of range, 10 ms of time; depth
/// 0.1 m.
void write_pd0(const DvlOptions& options, Time device, const DvlMeasurement& measurement, Telegrams& out);

}  // namespace leadline::sim
