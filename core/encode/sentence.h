#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "core/encode/telegrams.h"
#include "core/types/position.h"
#include "core/types/time.h"

namespace leadline::encode {

/// Writes one NMEA 0183 sentence field by field; its end adds checksum and CR LF.
class Sentence {
 public:
  /// talker empty: a maker's address.
  Sentence(Telegrams& out, std::string_view talker, std::string_view address);
  ~Sentence();
  Sentence(const Sentence&) = delete;
  Sentence& operator=(const Sentence&) = delete;

  Sentence& text(std::string_view text);
  Sentence& number(std::optional<double> value, int decimals);
  Sentence& whole(std::int64_t value, int width);
  /// 0 to 360, rounded; never written as 360.
  Sentence& heading(std::optional<Angle> angle, int decimals);
  /// Magnitude and letter.
  Sentence& directed(std::optional<Angle> angle, int decimals, char positive, char negative);
  /// ddmm.m, N or S, dddmm.m, E or W; four empty fields without a position.
  Sentence& position(const std::optional<Geodetic>& position, int decimals);
  /// hhmmss.ss
  Sentence& time_of_day(Time t, int decimals);

 private:
  void arc(double deg, int degree_digits, int decimals, char positive, char negative);
  Telegrams& out_;
  std::size_t begin_;
};

/// A time to the nearest 10^-decimals s, as its telegram states it.
[[nodiscard]] Time rounded(Time t, int decimals);

}  // namespace leadline::encode
