#pragma once

#include "core/sim/sensors/dvl.h"
#include "core/sim/telegrams/telegrams.h"
#include "core/types/time.h"

namespace leadline::sim {

/// One line of a NavQuest, the mirror of decode's navquest as it is without profile: velocities are the
/// bottom's, the checksum is 0. It tells no time. Instrument coordinates only. Resolution: 0.1 mm/s, 1 cm of
/// range, 0.01 deg.
void write_navquest(const DvlOptions& options, Time device, const DvlMeasurement& measurement,
                    Telegrams& out);

}  // namespace leadline::sim
