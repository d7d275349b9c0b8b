#pragma once

#include "core/sim/sensors/dvl.h"
#include "core/sim/telegrams/telegrams.h"
#include "core/types/time.h"

namespace leadline::sim {

/// One PD4 frame, or PD5 where attitude or depth are told: the mirror of decode's trdi-pd4. Resolution: 1
/// mm/s, 1 cm of range, 10 ms of time; PD5: 0.01 deg, 0.1 m of depth. Beam coordinates cannot be sent.
void write_pd4(const DvlOptions& options, Time device, const DvlMeasurement& measurement, Telegrams& out);

}  // namespace leadline::sim
