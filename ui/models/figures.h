#pragma once

// Every figure of the console as text, UTF-8: minus is U+2212, what is unknown is "− − −", never 0.

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "core/types/position.h"
#include "core/types/result.h"
#include "core/types/time.h"

namespace leadline::ui {

inline constexpr const char* kUnknown = "\u2212 \u2212 \u2212";

/// A number with its minus sign; -0.04 with one decimal is "0.0". kUnknown where it is not finite.
[[nodiscard]] std::string number_text(double value, int decimals);
/// The same with "+" or "−" always; "0.0" carries a plus.
[[nodiscard]] std::string signed_text(double value, int decimals);
/// How many decimals are worth showing: none below a tenth of sigma, 0..at_most. Without a sigma at_most.
[[nodiscard]] int decimals_for(std::optional<double> sigma, int at_most);
/// "0.3", "0.02", "23": one figure below 1, whole from 10; "<0.001".
[[nodiscard]] std::string sigma_text(double sigma);

enum class PositionFormat : std::uint8_t { dm, dd, dms, utm };
/// Two lines: "36°54.60000′ N", "129°54.30000′ E"; "36.9100000° N"; "36°54′36.000″ N"; "52N 402345.67 E",
/// "4085123.45 N". UTM has no name for the poles: there it is DM.
struct PositionText {
  std::string first, second;
  bool operator==(const PositionText&) const = default;
};
[[nodiscard]] PositionText position_text(Geodetic position, PositionFormat format = PositionFormat::dm);
/// In one line, two blanks between.
[[nodiscard]] std::string position_line(Geodetic position, PositionFormat format = PositionFormat::dm);
/// A pasted position in any of these forms, signed or with N S E W before or behind, latitude first where no
/// letter says else. Error: what it cannot be read as, in a sentence.
[[nodiscard]] Result<Geodetic> parse_position(std::string_view text);

/// "071.9"; 359.96 is "000.0".
[[nodiscard]] std::string heading_text(Angle heading, int decimals = 1);
/// "420 m", "12.3 km" from 10 km.
[[nodiscard]] std::string distance_text(double metres);
/// "0.2 s" below 10 s, "14 s", "2:41", "1:02:41"; cut, not rounded, so that it never shows what is to come.
[[nodiscard]] std::string age_text(Duration age);
/// "14:02:37 Z"; decimals 0..3, cut.
[[nodiscard]] std::string time_text(Time time, int decimals = 0);
/// "2026-09-14".
[[nodiscard]] std::string date_text(Time time);
/// "0.125 Hz", "5.0 Hz", "50 Hz".
[[nodiscard]] std::string rate_text(double hz);
/// "41 ms", "1.1 s", "2:41" from a minute.
[[nodiscard]] std::string latency_text(double latency_s);
/// "1 : 4 000": two figures that count, thousands apart.
[[nodiscard]] std::string scale_text(double denominator);

inline constexpr double kKnotsPerMps = 3600.0 / 1852.0;

}  // namespace leadline::ui
