#pragma once

#include "core/flow/source_info.h"

namespace leadline::nav {

/// The velocity of a ping in north, east, down, m/s: Kim 2010 eq. (1) for tilted axes, eq. (2) for level
/// ones, never both. The mount turns instrument axes only; the calibration's angles and scale apply in every
/// frame. Earth velocities are first turned back by the heading the device used. attitude: of the body, true
/// heading.
[[nodiscard]] Vec3<Ned> velocity_ned(const DvlVelocity& ping, const SourceInfo& source,
                                     const EulerAngles& attitude);

}  // namespace leadline::nav
