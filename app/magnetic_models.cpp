#include "app/magnetic_models.h"

#include "app/beside_program.h"

namespace leadline::app {

Result<geo::MagneticModel> load_magnetic_models() {
  return geo::MagneticModel::load(installed_or_beside("share/leadline", "magnetic").string());
}

}  // namespace leadline::app
