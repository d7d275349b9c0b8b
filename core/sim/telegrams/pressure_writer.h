#pragma once

#include "core/sim/sensors/sounder.h"
#include "core/sim/telegrams/telegrams.h"

namespace leadline::sim {

/// A depth as the pressure sensors say it, the mirrors of decode's valeport ($PVIPS2: depth and the pressure
/// of it) and paroscientific (absolute, psi), as those are without profile: standard atmosphere and ocean, 45
/// degrees of latitude. Resolution: 1 mm; 0.01 mm.
void write_valeport(const DepthMeasurement& measurement, Telegrams& out);
void write_paroscientific(const DepthMeasurement& measurement, Telegrams& out);

}  // namespace leadline::sim
