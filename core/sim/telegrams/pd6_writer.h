#pragma once

#include "core/sim/sensors/dvl.h"
#include "core/sim/telegrams/telegrams.h"
#include "core/types/time.h"

namespace leadline::sim {

/// The lines of one PD6 ping, each a telegram of its own: the mirror of decode's trdi-pd6. Instrument
/// coordinates send BI, BS and BE, ship ones BS and BE, earth ones BE; BS is level. Resolution: 1 mm/s, 0.01
/// deg, 1 cm of range, 10 ms of time, 0.1 m of depth. The distances made good are zero.
void write_pd6(const DvlOptions& options, Time device, const DvlMeasurement& measurement, Telegrams& out);

}  // namespace leadline::sim
