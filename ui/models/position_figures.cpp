// Latitude and longitude as text. Rounding is done once, in the smallest unit that is shown, so
// that 59.999999 minutes become the next degree.

#include <array>
#include <cmath>
#include <cstdio>

#include "core/geo/geodesy.h"
#include "core/geo/utm.h"
#include "ui/models/figures.h"

namespace leadline::ui {
namespace {

/// degree_digits: 2 of a latitude, 3 of a longitude.
std::string axis(double deg, PositionFormat format, int degree_digits, const char* letters) {
  const long long per_degree = format == PositionFormat::dm   ? 6'000'000
                               : format == PositionFormat::dd ? 10'000'000
                                                              : 3'600'000;
  const long long units = std::llround(std::abs(deg) * static_cast<double>(per_degree));
  const long long whole = units / per_degree, rest = units % per_degree;
  const char letter = letters[deg < 0.0 && units > 0 ? 1 : 0];
  std::array<char, 64> text{};
  if (format == PositionFormat::dm)
    std::snprintf(text.data(), text.size(), "%0*lld°%02lld.%05lld′ %c", degree_digits, whole, rest / 100'000,
                  rest % 100'000, letter);
  else if (format == PositionFormat::dd)
    std::snprintf(text.data(), text.size(), "%0*lld.%07lld° %c", degree_digits, whole, rest, letter);
  else
    std::snprintf(text.data(), text.size(), "%0*lld°%02lld′%02lld.%03lld″ %c", degree_digits, whole,
                  rest / 60'000, rest / 1000 % 60, rest % 1000, letter);
  return text.data();
}

}  // namespace

PositionText position_text(Geodetic position, PositionFormat format) {
  const double lat_deg = position.lat.deg(), lon_deg = position.lon.deg();
  if (!std::isfinite(lat_deg) || !std::isfinite(lon_deg) || std::abs(lat_deg) > 90.0 + 1e-9)
    return {kUnknown, kUnknown};
  if (format == PositionFormat::utm) {
    const auto utm = geo::to_utm(position);
    if (utm) {
      std::array<char, 48> first{}, second{};
      std::snprintf(first.data(), first.size(), "%d%c %.2f E", utm.value().zone,
                    utm.value().north ? 'N' : 'S', utm.value().easting_m);
      std::snprintf(second.data(), second.size(), "%.2f N", utm.value().northing_m);
      return {first.data(), second.data()};
    }
    format = PositionFormat::dm;
  }
  return {axis(lat_deg, format, 2, "NS"), axis(geo::normal_longitude(position.lon).deg(), format, 3, "EW")};
}

std::string position_line(Geodetic position, PositionFormat format) {
  const PositionText text = position_text(position, format);
  return text.first == kUnknown ? text.first : text.first + "  " + text.second;
}

}  // namespace leadline::ui
