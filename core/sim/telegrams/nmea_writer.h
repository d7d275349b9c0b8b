#pragma once

#include <span>
#include <string>

#include "core/sim/sensors/measurement.h"
#include "core/sim/sensors/sensor_options.h"
#include "core/sim/telegrams/telegrams.h"
#include "core/types/time.h"

namespace leadline::sim {

/// Sentences that say one measurement, each a telegram of its own: the mirror of decode's nmea0183.
/// sentences: as sentences_of(sensor) has them; device: the instrument's own clock.
void write_nmea(const SensorSetup& sensor, std::span<const std::string> sentences, Time device,
                const Measurement& measurement, Telegrams& out);

}  // namespace leadline::sim
