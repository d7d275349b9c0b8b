#include "core/decode/trdi_pd0_geometry.h"

#include <algorithm>
#include <cmath>

namespace leadline::decode {
namespace {

/// The beam that makes (b1 + b2) - (b3 + b4), the error velocity, zero.
double consistent_beam(const std::array<std::optional<double>, 4>& b, std::size_t missing) {
  const std::size_t partner = missing ^ 1;
  const std::size_t other = missing < 2 ? 2 : 0;
  return *b[other] + *b[other + 1] - *b[partner];
}

}  // namespace

std::optional<Pd0Velocity> pd0_from_beams(const std::array<std::optional<double>, 4>& beams_mps,
                                          Angle beam_angle, bool convex, bool three_beams_allowed) {
  auto b = beams_mps;
  const auto missing = std::count(b.begin(), b.end(), std::nullopt);
  const double st = sin(beam_angle), ct = cos(beam_angle);
  if (missing > (three_beams_allowed ? 1 : 0) || st <= 0.0 || ct <= 0.0) return std::nullopt;
  if (missing == 1) {
    const auto gap = static_cast<std::size_t>(std::find(b.begin(), b.end(), std::nullopt) - b.begin());
    b[gap] = consistent_beam(b, gap);
  }
  const double side = convex ? 1.0 : -1.0;
  Pd0Velocity v;
  v.x_mps = side * (*b[0] - *b[1]) / (2.0 * st);
  v.y_mps = side * (*b[3] - *b[2]) / (2.0 * st);
  v.z_mps = (*b[0] + *b[1] + *b[2] + *b[3]) / (4.0 * ct);
  if (missing == 0) v.error_mps = (*b[0] + *b[1] - *b[2] - *b[3]) / (2.0 * std::sqrt(2.0) * st);
  return v;
}

Vec3<Instrument> pd0_vehicle_velocity(const Pd0Velocity& bottom, bool up_facing) {
  const double starboard = up_facing ? -bottom.x_mps : bottom.x_mps;
  const double up = up_facing ? -bottom.z_mps : bottom.z_mps;
  return {-bottom.y_mps, -starboard, up};  // the vehicle's up is minus the bottom's, and down is minus up
}

}  // namespace leadline::decode
