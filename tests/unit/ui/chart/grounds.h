#pragma once

#include <QImage>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "ui/look/colours.h"

namespace leadline::ui::test {

/// What symbols are drawn on, made by arithmetic alone so that it is the same everywhere: plain water, a
/// coast from above, a side-scan mosaic; rasters under the palette's tone curve.
enum class Ground { deep, shallow, imagery, mosaic };
inline constexpr std::array kGrounds{Ground::deep, Ground::shallow, Ground::imagery, Ground::mosaic};

inline double speck(int x, int y) {
  std::uint32_t h = static_cast<std::uint32_t>(x) * 374761393U + static_cast<std::uint32_t>(y) * 668265263U;
  h = (h ^ (h >> 13)) * 1274126177U;
  return static_cast<double>((h ^ (h >> 16)) & 0xFFFFU) / 65535.0;
}
/// Smooth noise in [0, 1] with features of about `size` px.
inline double cloud(double x, double y, double size) {
  const double u = x / size, v = y / size, fu = u - std::floor(u), fv = v - std::floor(v);
  const int i = static_cast<int>(std::floor(u)), j = static_cast<int>(std::floor(v));
  const double a = fu * fu * (3.0 - 2.0 * fu), b = fv * fv * (3.0 - 2.0 * fv);
  return (speck(i, j) * (1 - a) + speck(i + 1, j) * a) * (1 - b) +
         (speck(i, j + 1) * (1 - a) + speck(i + 1, j + 1) * a) * b;
}

using Rgb = std::array<double, 3>;
inline Rgb mixed(const Rgb& a, const Rgb& b, double t) {
  return {a[0] + (b[0] - a[0]) * t, a[1] + (b[1] - a[1]) * t, a[2] + (b[2] - a[2]) * t};
}

inline double rough_at(double x, double y) {
  return 0.45 * cloud(x, y, 40) + 0.27 * cloud(x, y, 15) + 0.18 * cloud(x, y, 6) + 0.10 * cloud(x, y, 3);
}
inline Rgb imagery(double x, double y, double width) {
  const double rough = rough_at(x, y);
  const double coast = width * 0.56 + 60.0 * (cloud(0, y, 70) - 0.5) + 24.0 * (cloud(9, y, 19) - 0.5);
  if (x < coast) {
    const double shade = 0.95 + 3.0 * (rough - rough_at(x + 2.0, y + 2.0));  // light from the north-west
    return mixed({74 * shade, 84 * shade, 50 * shade}, {132 * shade, 122 * shade, 92 * shade},
                 std::clamp(cloud(x, y, 90) * 1.3 - 0.3, 0.0, 1.0));
  }
  const double depth = std::clamp((x - coast) / 190.0 + 0.25 * (rough - 0.5), 0.0, 1.0);
  const Rgb surf{112, 172, 166}, shelf{38, 104, 134}, deep{10, 44, 84};
  return depth < 0.4 ? mixed(surf, shelf, depth / 0.4) : mixed(shelf, deep, (depth - 0.4) / 0.6);
}

inline Rgb mosaic(double x, double y) {
  const double ripple = 0.5 + 0.5 * std::sin((x * 0.24 + y * 0.55 + 5.0 * cloud(x, y, 60)) * 1.1);
  double level =
      0.30 + 0.26 * cloud(x, y, 120) + 0.16 * ripple * cloud(x + 500, y, 150) + 0.14 * (cloud(x, y, 2) - 0.5);
  const double stone = cloud(x + 900, y + 40, 9) * cloud(x + 300, y, 31);
  level += 1.6 * std::max(stone - 0.55, 0.0);  // an echo, and its shadow further out
  level -= 1.6 * std::max(cloud(x + 894, y + 41, 9) * cloud(x + 294, y, 31) - 0.55, 0.0);
  level = std::clamp(level, 0.0, 1.0);
  static constexpr std::array<Rgb, 5> kCopper{
      {{18, 10, 4}, {74, 43, 16}, {150, 96, 42}, {211, 155, 82}, {246, 220, 166}}};
  const int k = std::min(static_cast<int>(level * 4.0), 3);
  return mixed(kCopper[k], kCopper[k + 1], level * 4.0 - k);
}

// In steps of eight, so that golden pictures stay small.
inline QRgb toned(Rgb c, const Tone& tone) {
  for (double& v : c) v = std::round(v / 8.0) * 8.0;
  const double luma = 0.299 * c[0] + 0.587 * c[1] + 0.114 * c[2];
  std::array<int, 3> out{};
  for (std::size_t i = 0; i < 3; ++i) {
    const double v = (luma + (c[i] - luma) * tone.saturation) * tone.gain * tone.tint[i];
    out[i] = static_cast<int>(std::lround(std::clamp(v, 0.0, 255.0)));
  }
  return qRgb(out[0], out[1], out[2]);
}

inline QImage ground(Ground kind, QSize size, const Colours& colours) {
  QImage image(size, QImage::Format_RGB32);
  image.fill(colours.of(kind == Ground::shallow ? Role::sea_shallow : Role::sea_deep));
  if (kind == Ground::deep || kind == Ground::shallow) return image;
  const Tone tone = kind == Ground::imagery ? base_tone(colours) : data_tone(colours);
  for (int y = 0; y < size.height(); ++y) {
    auto* row = reinterpret_cast<QRgb*>(image.scanLine(y));
    for (int x = 0; x < size.width(); ++x)
      row[x] = toned(kind == Ground::imagery ? imagery(x, y, size.width()) : mosaic(x, y), tone);
  }
  return image;
}

}  // namespace leadline::ui::test
