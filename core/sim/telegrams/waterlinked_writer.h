#pragma once

#include "core/sim/sensors/dvl.h"
#include "core/sim/telegrams/telegrams.h"
#include "core/types/time.h"

namespace leadline::sim {

/// One ping of a Water Linked DVL, the mirrors of decode's waterlinked-serial (wrz, four wru; wrs with water
/// track, wrp with attitude_told) and waterlinked-json (velocity, velocity_water, position_local).
/// Instrument coordinates only. Resolution: 1 mm/s, 1 cm of range, 1 us of time, 0.01 deg.
void write_waterlinked_serial(const DvlOptions& options, Time device, const DvlMeasurement& measurement,
                              Telegrams& out);
void write_waterlinked_json(const DvlOptions& options, Time device, const DvlMeasurement& measurement,
                            Telegrams& out);

}  // namespace leadline::sim
