#pragma once

#include "core/sim/sensors/compass.h"
#include "core/sim/telegrams/telegrams.h"

namespace leadline::sim {

/// One kGetDataResp with heading and distortion: the mirror of decode's pni-tcm. Big-endian, 32-bit floats.
void write_pni(const CompassMeasurement& measurement, Telegrams& out);

}  // namespace leadline::sim
