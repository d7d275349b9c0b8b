#pragma once

#include <array>
#include <optional>

#include "core/types/angle.h"
#include "core/types/vec3.h"

namespace leadline::decode {

/// A velocity in PD0's sense: of the bottom (or water) past the instrument, which it takes for fixed.
/// Instrument: x from beam 1 to 2, y from beam 4 to 3, z from the bottom to the transducer's face.
struct Pd0Velocity {
  double x_mps = 0.0, y_mps = 0.0, z_mps = 0.0;
  std::optional<double> error_mps;  ///< empty in a three-beam solution, which assumes it is 0
};

/// Instrument velocity from radial ones, positive towards the transducer (wire-formats 3, "From beams to the
/// body"). beam_angle: from the vertical, inside (0, 90) deg. A concave head changes the sign of x and y.
/// One missing beam is made up from error velocity 0 where the device allows it; else the result is empty.
[[nodiscard]] std::optional<Pd0Velocity> pd0_from_beams(const std::array<std::optional<double>, 4>& beams_mps,
                                                        Angle beam_angle, bool convex,
                                                        bool three_beams_allowed);

/// Velocity of the vehicle, forward-starboard-down of the instrument, mounted with beam 3 forward.
/// A down-facing head has x to starboard, y forward and z up. An up-facing one is the same head rolled by
/// 180 degrees about y: x is then to port and z down. So the roll is put in here, the result is level when
/// the instrument's own roll reads 0, and the mount's angles stay small either way.
[[nodiscard]] Vec3<Instrument> pd0_vehicle_velocity(const Pd0Velocity& bottom, bool up_facing);

}  // namespace leadline::decode
