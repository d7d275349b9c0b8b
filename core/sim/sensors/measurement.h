#pragma once

#include <variant>

#include "core/sim/sensors/ahrs.h"
#include "core/sim/sensors/compass.h"
#include "core/sim/sensors/dvl.h"
#include "core/sim/sensors/gnss.h"
#include "core/sim/sensors/imu.h"
#include "core/sim/sensors/sounder.h"
#include "core/sim/sensors/usbl.h"

namespace leadline::sim {

/// What one instrument measured at one instant, at full precision: what its telegrams are written from.
using Measurement = std::variant<GnssMeasurement, UsblMeasurement, DvlMeasurement, AttitudeMeasurement,
                                 CompassMeasurement, ImuSample, DepthMeasurement, AltitudeMeasurement>;

}  // namespace leadline::sim
