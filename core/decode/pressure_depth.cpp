#include "core/decode/pressure_depth.h"

#include <array>
#include <charconv>
#include <string>

namespace leadline::decode {
namespace {

constexpr double kPaPerDbar = 1e4;

double surface_gravity_mps2(Angle latitude) {
  const double x = sin(latitude) * sin(latitude);
  return 9.780318 * (1.0 + (5.2788e-3 + 2.36e-5 * x) * x);
}

/// Three decimals whatever the locale.
std::string fixed(double value) {
  std::array<char, 32> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::fixed, 3);
  return std::string(text.data(), end.ptr);
}

}  // namespace

double depth_of_pressure_m(double gauge_pa, Angle latitude) {
  const double p = gauge_pa / kPaPerDbar;
  const double gravity_mps2 = surface_gravity_mps2(latitude) + 1.092e-6 * p;
  return (((-1.82e-15 * p + 2.279e-10) * p - 2.2512e-5) * p + 9.72659) * p / gravity_mps2;
}

double depth_of_pressure_m(double gauge_pa, Angle latitude, double density_kgm3) {
  return gauge_pa / (density_kgm3 * surface_gravity_mps2(latitude));
}

std::optional<Health> PressureDepth::note() {
  if (told_) return std::nullopt;
  told_ = true;
  const std::string latitude = fixed(latitude_.deg()) + " deg";
  if (density_kgm3_)
    return Health{Health::Level::note, "depth is pressure / (" + fixed(*density_kgm3_) +
                                           " kg/m3 * gravity at latitude " + latitude + ")"};
  return Health{Health::Level::note,
                "depth is calculated from pressure after UNESCO 44 (Fofonoff and Millard 1983): standard "
                "ocean, latitude " +
                    latitude};
}

}  // namespace leadline::decode
