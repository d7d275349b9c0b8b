#pragma once

// What the navigation core makes of the facts.

#include <cstdint>
#include <optional>

#include "core/types/angle.h"
#include "core/types/position.h"
#include "core/types/text.h"

namespace leadline {

/// Availability (Kim 2010 table 1 as corrected in navigation-fusion 1.3).
enum class Mode : std::uint8_t {
  A,   ///< GNSS and bottom lock
  B,   ///< USBL and bottom lock
  C,   ///< GNSS without bottom lock
  D,   ///< USBL without bottom lock
  E1,  ///< bottom lock only: dead reckoning, sigma grows
  E0,  ///< nothing: the last position is held
};

enum class PositionSource : std::uint8_t { none, gnss, usbl };

/// Which engine speaks: its place in the order of configuration; the ship's own track has its own.
using EngineId = std::uint8_t;
inline constexpr EngineId kShipTrack = 255;

/// One navigation solution of one body at its reference point.
struct Solution {
  EngineId engine = 0;
  Geodetic position;
  std::optional<Depth> depth;
  std::optional<Angle> roll, pitch, heading;
  std::optional<double> vel_north_mps, vel_east_mps, vel_down_mps;
  double var_north_m2 = 0.0, cov_north_east_m2 = 0.0, var_east_m2 = 0.0;
  std::optional<double> sd_down_m;
  std::optional<Angle> sd_heading, heading_bias;
  std::optional<Mode> mode;
  PositionSource position_source = PositionSource::none;  ///< of the last accepted fix
  bool operator==(const Solution&) const = default;
};

/// What became of one position fix. Envelope::source is the fix's source.
struct FixVerdict {
  EngineId engine = 0;
  Geodetic position;
  std::optional<Depth> depth;
  std::optional<double> residual_m;     ///< horizontal, fix minus engine at the fix's time
  std::optional<double> dr_residual_m;  ///< the same against pure dead reckoning since the engine's start
  std::optional<double> gate_m;         ///< radius of the gate along the residual
  std::optional<bool> accepted;         ///< empty: the engine did not use it
  bool operator==(const FixVerdict&) const = default;
};

struct ModeChange {
  EngineId engine = 0;
  Mode from = Mode::E0, to = Mode::E0;
  Text<100> reason;
  bool operator==(const ModeChange&) const = default;
};

}  // namespace leadline
