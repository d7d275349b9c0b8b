#pragma once

#include <span>
#include <string>

#include "core/encode/udpbc.h"
#include "core/sim/telegrams/nmea_writer.h"

namespace leadline::sim {

/// Who says a sensor's sentences in IEC 61162-450: its talker, else its kind's usual one, and its number.
[[nodiscard]] std::string sfi_of(const SensorSetup& sensor, std::size_t number);

/// The sentences of one measurement as datagrams: the mirror of decode's iec61162-450.
void write_udpbc(const SensorSetup& sensor, std::span<const std::string> sentences, Time device,
                 const Measurement& measurement, encode::Udpbc& udpbc, Telegrams& out);

}  // namespace leadline::sim
