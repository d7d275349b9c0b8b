#pragma once

#include "core/sim/sensors/usbl.h"
#include "core/sim/telegrams/telegrams.h"
#include "core/types/time.h"

namespace leadline::sim {

/// One USBLLONG notification, nothing without a reply: the mirror of decode's evologics-usbl. The transponder
/// is a number. Resolution: 0.1 mm, 1 us; up is minus the transponder's depth.
void write_evologics(Time device, const UsblMeasurement& measurement, Telegrams& out);

}  // namespace leadline::sim
