#pragma once

#include "core/sim/sensors/dvl.h"
#include "core/sim/telegrams/telegrams.h"
#include "core/types/time.h"

namespace leadline::sim {

/// DF21 records of bottom track and, where it is measured, water track: the mirror of decode's nortek-dvl.
/// Instrument coordinates only. Resolution: that of 32-bit floats, 100 us of time. Beams 1 to 4 look forward,
/// to starboard, aft, to port; the pressure is 0.1 bar a metre.
void write_nortek(const DvlOptions& options, Time device, const DvlMeasurement& measurement, Telegrams& out);

}  // namespace leadline::sim
