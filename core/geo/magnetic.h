#pragma once

#include <memory>
#include <string>

#include "core/types/position.h"
#include "core/types/result.h"
#include "core/types/time.h"

namespace leadline::geo {

/// Years as the magnetic models count them: 2025.5 is the middle of 2025, leap or not.
[[nodiscard]] double decimal_year(Time time);

/// NOAA's World Magnetic Models 2015v2, 2020 and 2025. Every const function is thread safe; movable.
class MagneticModel {
 public:
  /// Reads the three models once, `wmm2025.wmm` with `wmm2025.wmm.cof` and so on, which the build puts into
  /// its folder `magnetic`. Error names the file that is missing or damaged.
  [[nodiscard]] static Result<MagneticModel> load(const std::string& folder);

  struct Declination {
    Angle east;             ///< magnetic north clockwise from true north, in [-pi, pi]
    bool outside_validity;  ///< before 2015 or from 2030 on: the nearest model, carried on linearly
  };

  /// The date of the measurement chooses the model: an epoch's own instant (2025.0) belongs to the new one.
  /// The models' own uncertainty is 0.3 to 0.4 deg, more near the magnetic poles; this reproduces NOAA's
  /// test values to their printed 0.01 deg. No allocation.
  [[nodiscard]] Declination declination(Geodetic position, EllipsoidHeight height, Time time) const;

  MagneticModel(MagneticModel&&) noexcept;
  MagneticModel& operator=(MagneticModel&&) noexcept;
  ~MagneticModel();

 private:
  struct Models;
  explicit MagneticModel(std::unique_ptr<const Models> models);
  std::unique_ptr<const Models> models_;
};

}  // namespace leadline::geo
