#pragma once

#include "core/geo/magnetic.h"

namespace leadline::app {

/// The world magnetic models that lie beside the program (`magnetic/`) or were installed with it.
[[nodiscard]] Result<geo::MagneticModel> load_magnetic_models();

}  // namespace leadline::app
