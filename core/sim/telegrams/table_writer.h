#pragma once

#include <string>
#include <vector>

#include "core/sim/sensors/measurement.h"
#include "core/sim/sensors/sensor_options.h"
#include "core/sim/telegrams/telegrams.h"
#include "core/types/time.h"

namespace leadline::sim {

/// The columns of a sensor's rows, as decode's table and the configuration name them.
[[nodiscard]] std::vector<std::string> table_columns_of(const SensorSetup& sensor);

/// One row at full precision: numbers as short as they read back to the same bits. Nothing where there is
/// nothing to say.
void write_row(const SensorSetup& sensor, Time device, const Measurement& measurement, Telegrams& out);

}  // namespace leadline::sim
