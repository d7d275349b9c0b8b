#pragma once

// A log of the gpsd project beside what gpsd's own decoder said after each of its sentences (NAME.log.chk).

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "core/flow/decoder.h"
#include "tests/support/decoder_harness.h"

namespace leadline::test::gpsd {

/// One sentence of the log and what our decoder made of it.
struct Telegram {
  std::string text, kind;
  int line = 0;  ///< in the log, from 1
  std::vector<Decoded::Fact> facts;
  std::optional<Time> epoch;  ///< the newest time told up to and with this sentence
};

enum class Field {
  position,     ///< lat and lon
  time,         ///< of a report with a position
  time_no_fix,  ///< of a report without one
  height,       ///< altHAE
  speed,        ///< m/s
  track,        ///< degrees true
  heading,      ///< degrees true
  mag_heading,  ///< degrees magnetic
  roll,         ///< degrees
  pitch         ///< degrees
};
inline constexpr std::array kFields = {Field::position, Field::time,  Field::time_no_fix, Field::height,
                                       Field::speed,    Field::track, Field::heading,     Field::mag_heading,
                                       Field::roll,     Field::pitch};
std::string name_of(Field field);

/// One number, or the latitude and longitude of a position; times in seconds since 1970.
struct Value {
  double a = 0.0, b = 0.0;
};
/// Positions within 1e-7 degree in both axes, times within 0.5 ms, everything else within half of gpsd's last
/// digit.
bool equal(Field field, const Value& x, const Value& y);

/// One value that gpsd reported.
struct Told {
  Field field = Field::position;
  Value value;
  std::size_t at = 0;        ///< the sentence before the report, an index into Log::telegrams
  std::optional<Time> time;  ///< of the report
};

struct Log {
  std::string name;
  std::vector<Telegram> telegrams;
  std::vector<Told> told;
  int unfound = 0;  ///< sentences of the .chk that the log does not hold in that order
};
Log read_log(const std::string& name);

/// What we have for it: of the same time where the report has one, else of the order: the newest up to the
/// sentence before the report, else the first one behind it.
std::optional<Value> ours(const Log& log, const Told& told);

/// The value of one sentence when a decoder hears nothing else; empty when it holds none.
std::optional<Value> alone(const Telegram& telegram, Field field);

/// Field n of a sentence, 0 the address; empty when it has none.
std::string field_of(const std::string& sentence, std::size_t n);

}  // namespace leadline::test::gpsd
