#pragma once

#include <cstdint>

#include "core/messages/measurements.h"
#include "core/sim/sensors/ahrs.h"
#include "core/sim/telegrams/telegrams.h"
#include "core/types/time.h"

namespace leadline::sim {

/// One MTData2 packet with UTC, packet counter and status word: the mirror of decode's xsens-mtdata2. An AHRS
/// says a quaternion in ENU and its turn rate, an IMU rates and accelerations in NED; 64-bit floats.
void write_xsens(std::uint16_t counter, Time device, const AttitudeMeasurement& measurement, Telegrams& out);
/// sample: rates, not increments.
void write_xsens(std::uint16_t counter, Time device, const ImuSample& sample, Telegrams& out);

}  // namespace leadline::sim
