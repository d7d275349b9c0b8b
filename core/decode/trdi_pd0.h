#pragma once

#include <memory>

#include "core/flow/decoder.h"

namespace leadline::decode {

/// Teledyne RDI PD0 ensembles (wire-formats 3) with embedded NMEA. Kinds: "ensemble", "waves" (`7F 79`,
/// unused) and, as blocks of an ensemble, "NMEA GGA", "NMEA VTG", "NMEA DBT" (binary), "NMEA text", "NMEA
/// other". A GNSS fix is told once: a block that repeats the UTC of one told, or of a binary one in the same
/// ensemble, is unused. Its time is the ensemble's minus its delay, on the device's clock; a ClockReading
/// beside it holds both that time and the fix's UTC. No velocity is corrected for mount, heading bias or
/// declination.
[[nodiscard]] std::unique_ptr<Decoder> make_trdi_pd0(const DecoderSettings& settings);

}  // namespace leadline::decode
