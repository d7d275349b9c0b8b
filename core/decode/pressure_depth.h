#pragma once

#include <optional>

#include "core/decode/profile.h"
#include "core/messages/bookkeeping.h"
#include "core/types/angle.h"

namespace leadline::decode {

inline constexpr double kStandardAtmosphere_pa = 101'325.0;

/// Depth below the surface, m, of a pressure above the atmosphere's, Pa, -1e5 to 1.1e8: Fofonoff and Millard,
/// Algorithms for computation of fundamental properties of seawater, UNESCO technical papers in marine
/// science 44 (1983), page 28: a standard ocean of 0 degC and salinity 35, gravity of the latitude that grows
/// with depth. 10000 dbar at 30 deg are 9712.653 m.
[[nodiscard]] double depth_of_pressure_m(double gauge_pa, Angle latitude);

/// The same of water whose density is known and constant: p / (density gravity), gravity that of 1983 at the
/// surface.
[[nodiscard]] double depth_of_pressure_m(double gauge_pa, Angle latitude, double density_kgm3);

/// Pressure to depth as a profile's latitude_deg and density_kgm3 say.
class PressureDepth {
 public:
  PressureDepth(double latitude_deg, std::optional<double> density_kgm3)
      : latitude_(Angle::deg(latitude_deg)), density_kgm3_(density_kgm3) {}
  [[nodiscard]] double metres(double gauge_pa) const {
    return density_kgm3_ ? depth_of_pressure_m(gauge_pa, latitude_, *density_kgm3_)
                         : depth_of_pressure_m(gauge_pa, latitude_);
  }
  /// What is calculated, for the record: once, before the first depth.
  [[nodiscard]] std::optional<Health> note();

 private:
  Angle latitude_;
  std::optional<double> density_kgm3_;
  bool told_ = false;
};

}  // namespace leadline::decode
