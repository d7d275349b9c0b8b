#include "ui/look/colours.h"

#include <algorithm>
#include <cmath>

namespace leadline::ui {
namespace {

// IEC 61966-2-1.
double linear(int byte) {
  const double c = byte / 255.0;
  return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
}

int byte(double light) {
  const double c = light <= 0.0031308 ? light * 12.92 : 1.055 * std::pow(light, 1.0 / 2.4) - 0.055;
  return static_cast<int>(std::lround(std::clamp(c, 0.0, 1.0) * 255.0));
}

bool alert(Role role) { return role >= Role::alarm && role <= Role::caution_glyph; }

QRgb dimmed(QRgb rgb, double luminance) {
  return qRgb(byte(linear(qRed(rgb)) * luminance), byte(linear(qGreen(rgb)) * luminance),
              byte(linear(qBlue(rgb)) * luminance));
}

// A gain works on sRGB bytes, the dimmer on light: the power law of the greater part of the curve.
Tone dimmed(Tone tone, double luminance) {
  tone.gain *= std::pow(luminance, 1.0 / 2.2);
  return tone;
}

}  // namespace

Colours::Colours(Palette palette, double luminance) : palette_(palette), luminance_(luminance) {
  for (std::size_t i = 0; i < rgb_.size(); ++i) {
    const auto role = static_cast<Role>(i);
    const double light = alert(role) ? std::max(luminance, 0.5) : luminance;
    rgb_[i] = light < 1.0 ? dimmed(argb(role, palette), light) : argb(role, palette);
  }
}

QColor Colours::of(Role role, double opacity) const {
  QColor colour = QColor::fromRgb(rgb_[static_cast<std::size_t>(role)]);
  if (opacity < 1.0) colour.setAlphaF(opacity);
  return colour;
}

Tone base_tone(const Colours& colours) {
  switch (colours.palette()) {
    case Palette::dusk:
      return dimmed(Tone{0.47, 0.95, {0.86, 0.99, 1.10}}, colours.luminance());
    case Palette::night:
      return dimmed(Tone{0.17, 0.55, {0.92, 1.0, 1.06}}, colours.luminance());
    case Palette::day:
      break;
  }
  return dimmed(Tone{}, colours.luminance());
}

Tone data_tone(const Colours& colours) {
  switch (colours.palette()) {
    case Palette::dusk:
      return dimmed(Tone{0.66, 0.92}, colours.luminance());
    case Palette::night:
      return dimmed(Tone{0.30, 0.80}, colours.luminance());
    case Palette::day:
      break;
  }
  return dimmed(Tone{}, colours.luminance());
}

}  // namespace leadline::ui
