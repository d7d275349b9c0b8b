#pragma once

#include <optional>

#include "core/decode/trdi_pd0_ensemble.h"
#include "core/flow/decoder.h"
#include "core/messages/measurements.h"
#include "core/types/time.h"

namespace leadline::decode {

/// UTC on the device's clock: the four-digit clock where its century is 19 or 20, else the two-digit one
/// (80..99: 19xx). A REMUS has other things in the place of the first. Empty: not set or no date.
[[nodiscard]] std::optional<Time> pd0_time(const Pd0VariableLeader& leader);

/// Over the bottom, of the vehicle: PD0 gives the bottom's, so every sign turns. Needs e.bottom. 0x5803
/// refines 0x0600 where both agree to its millimetre. valid is false when a needed component or beam is
/// missing.
[[nodiscard]] DvlVelocity pd0_bottom_velocity(const Pd0Ensemble& e, const DecoderSettings& settings);

/// Through the water, from the bottom-track ping's reference layer; empty when no layer is set (its far end
/// is 0: a RiverPro then writes zeros, not "missing") or it gave nothing.
[[nodiscard]] std::optional<DvlVelocity> pd0_water_velocity(const Pd0Ensemble& e,
                                                            const DecoderSettings& settings);

/// Mean of the vertical ranges over those pairs of opposite beams (1-2, 3-4) that both see the bottom: in a
/// pair a tilt's error cancels to first order, a single beam would carry it whole. Empty without a pair.
[[nodiscard]] std::optional<AltitudeAboveBottom> pd0_altitude(const Pd0BottomTrack& bottom);

/// Everything an ensemble itself measured, in the order ClockReading, Heading, Attitude, SoundSpeed,
/// DepthMeasured, Pressure, BeamRanges, AltitudeAboveBottom, DvlVelocity bottom, DvlVelocity water.
/// The leader's sigmas are not used: they are the scatter within one ensemble (0 on most units), not an
/// accuracy, and an Explorer keeps something else in these bytes (its "heading sigma" reaches 255 deg).
void tell_pd0_facts(const Pd0Ensemble& e, const DecoderSettings& settings, DecoderOutput& out);

}  // namespace leadline::decode
