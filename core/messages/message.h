#pragma once

#include <cstdint>
#include <variant>

#include "core/messages/bookkeeping.h"
#include "core/messages/measurements.h"
#include "core/messages/navigation.h"
#include "core/types/time.h"

namespace leadline {

/// Every kind of fact there is. Closed: who reads messages is told by the compiler of a new kind.
using Message = std::variant<RawFrame, Rejected, Health, Alarm, Tick, ClockReading, GnssFix, Course, Heading,
                             Attitude, Rates, ImuSample, DvlVelocity, BeamRanges, AltitudeAboveBottom,
                             DepthMeasured, BottomDepth, Pressure, SoundSpeed, UsblRelative, UsblGeographic,
                             UsblGrid, Solution, FixVerdict, ModeChange>;

/// A source's place in the order of configuration.
using SourceId = std::uint16_t;
inline constexpr SourceId kNoSource = 0xFFFF;

/// A message with its place in the one order of everything.
struct Envelope {
  std::uint64_t seq = 0;  ///< numbered by the Bus from 1
  std::uint64_t raw = 0;  ///< seq of the RawFrame it was made from; 0: none
  Time valid;             ///< when it was true
  Arrival arrival;        ///< when it, or what it was made from, was heard
  Time wall_utc;          ///< the host's wall clock then: a label, never used in arithmetic
  SourceId source = kNoSource;
  Message message;
};

}  // namespace leadline
