#pragma once

#include <QColor>

#include "ui/look/role.h"

namespace leadline::ui {

/// The colours in force: a palette under the operator's dimmer. A value; everything that paints is handed
/// one.
class Colours {
 public:
  /// luminance: factor on linear light, (0, 1]; alert roles stop at 0.5.
  explicit Colours(Palette palette, double luminance = 1.0);

  /// opacity in [0, 1].
  [[nodiscard]] QColor of(Role role, double opacity = 1.0) const;
  [[nodiscard]] Palette palette() const { return palette_; }
  [[nodiscard]] double luminance() const { return luminance_; }
  bool operator==(const Colours& o) const { return palette_ == o.palette_ && luminance_ == o.luminance_; }

 private:
  Palette palette_;
  double luminance_;
  std::array<QRgb, kRoles.size()> rgb_;
};

/// How rasters obey the palette: out = (y + (c - y) * saturation) * gain * tint on sRGB bytes, y = luma.
struct Tone {
  double gain = 1.0, saturation = 1.0;
  std::array<double, 3> tint{1.0, 1.0, 1.0};  ///< red, green, blue
  bool operator==(const Tone&) const = default;
};
/// For imagery, bathymetry and charts.
[[nodiscard]] Tone base_tone(const Colours& colours);
/// For the side-scan mosaic and waterfall.
[[nodiscard]] Tone data_tone(const Colours& colours);

}  // namespace leadline::ui
