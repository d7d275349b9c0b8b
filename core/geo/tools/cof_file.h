#pragma once

#include <array>
#include <string>

#include "core/types/result.h"

namespace leadline::geo {

inline constexpr int kWmmDegree = 12;

/// Coefficients as [n][m], nT (main field) or nT/year (change).
using Harmonics = std::array<std::array<double, kWmmDegree + 1>, kWmmDegree + 1>;

/// NOAA's .COF: the World Magnetic Model of one epoch, degree and order 12, Schmidt semi-normalized.
struct CofFile {
  double epoch_year = 0.0;
  std::string name, release_date;
  Harmonics g{}, h{}, g_rate{}, h_rate{};
};

/// Error names file and line: a row that is missing, out of order or not six numbers, no closing line of 9s.
[[nodiscard]] Result<CofFile> read_cof(const std::string& path);

/// Writes folder/NAME.wmm (text) and folder/NAME.wmm.cof (binary, little-endian on any machine), the format
/// GeographicLib's MagneticModel loads. `name` in lower case.
[[nodiscard]] Result<void> write_wmm(const CofFile& cof, const std::string& folder, const std::string& name);

}  // namespace leadline::geo
