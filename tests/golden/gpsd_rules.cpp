#include "tests/golden/gpsd_rules.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "core/geo/geodesy.h"
#include "tests/support/files.h"

namespace leadline::test::gpsd {
namespace {

using namespace std::chrono_literals;

bool is_position(const Telegram& t) {
  return t.kind == "GGA" || t.kind == "GNS" || t.kind == "RMC" || t.kind == "GLL";
}
/// hhmmss.s... of a position as seconds.
double utc_s(const Telegram& t) {
  const std::string utc = field_of(t.text, t.kind == "GLL" ? 5 : 1);
  const double value = std::atof(utc.c_str());
  const double hours = std::floor(value / 1e4), minutes = std::floor(std::fmod(value, 1e4) / 100.0);
  return hours * 3600.0 + minutes * 60.0 + std::fmod(value, 100.0);
}
bool same_epoch(double a_s, double b_s) { return std::abs(a_s - b_s) < 0.011; }

const Told& told_of(const Difference& d) { return d.log.told[d.told]; }

/// The newest sentence up to the report that `wanted` accepts.
template <class Wanted>
const Telegram* newest(const Difference& d, Wanted wanted) {
  for (std::size_t i = told_of(d).at + 1; i-- > 0;)
    if (wanted(d.log.telegrams[i])) return &d.log.telegrams[i];
  return nullptr;
}
const Telegram* newest_kind(const Difference& d, const std::string& kind) {
  return newest(d, [&](const Telegram& t) { return t.kind == kind; });
}

bool tells(const Telegram* telegram, const Difference& d) {
  if (!telegram) return false;
  const auto value = alone(*telegram, told_of(d).field);
  return value && equal(told_of(d).field, *value, told_of(d).value);
}
bool position_or_height(const Difference& d) {
  return told_of(d).field == Field::position || told_of(d).field == Field::height;
}

/// The sentence with another field n and no checksum.
Telegram with_field(Telegram t, std::size_t n, const std::string& value) {
  std::string text = field_of(t.text, 0);
  for (std::size_t i = 1; i < 15; ++i) text += "," + (i == n ? value : field_of(t.text, i));
  t.text = text;
  return t;
}

/// GGA of this quality, its coordinates taken by gpsd all the same.
bool gga_of_quality(const Difference& d, const std::vector<std::string>& qualities) {
  const Telegram* gga = newest_kind(d, "GGA");
  if (!position_or_height(d) || !gga) return false;
  const bool one_of = std::count(qualities.begin(), qualities.end(), field_of(gga->text, 6)) > 0;
  const Telegram good = with_field(*gga, 6, "1");
  return one_of && tells(&good, d);
}

/// Degrees that half a unit of the last digit of a latitude is.
double half_digit_deg(const std::string& sentence, std::size_t latitude) {
  const std::string text = field_of(sentence, latitude);
  const std::size_t point = text.find('.');
  const auto decimals = point == std::string::npos ? 0 : static_cast<double>(text.size() - point - 1);
  return 0.5 * std::pow(10.0, -decimals) / 60.0;
}

/// One epoch told twice, with more and with fewer digits; gpsd shows the one, we the other.
bool fewer_digits(const Difference& d) {
  if (told_of(d).field != Field::position || !d.ours) return false;
  const Telegram* last = newest(d, is_position);
  if (!tells(last, d)) return false;
  for (const Telegram& other : d.log.telegrams) {
    if (!is_position(other) || !same_epoch(utc_s(other), utc_s(*last))) continue;
    const auto value = alone(other, Field::position);
    if (!value || !equal(Field::position, *value, *d.ours)) continue;
    const auto digits = [](const Telegram& t) {
      return half_digit_deg(t.text, t.kind == "RMC" ? 3u : t.kind == "GLL" ? 1u : 2u);
    };
    const double coarser_deg = std::max(digits(*last), digits(other)) * 1.001;
    return std::abs(value->a - told_of(d).value.a) <= coarser_deg &&
           std::abs(value->b - told_of(d).value.b) <= coarser_deg;
  }
  return false;
}

/// Was a fix given out by a sentence of this UTC?
bool same_epoch_fix(const Log& log, double second) {
  return std::any_of(log.telegrams.begin(), log.telegrams.end(), [&](const Telegram& t) {
    if (!is_position(t) || !same_epoch(utc_s(t), second)) return false;
    return std::any_of(t.facts.begin(), t.facts.end(), [](const Decoded::Fact& fact) {
      return std::holds_alternative<GnssFix>(fact.message);
    });
  });
}

/// A lesser sentence is silent while a better kind was heard within 5 s: positions of RMC and GLL while there
/// is GGA, speeds of RMC while there is VTG.
bool lesser_kind(const Difference& d) {
  const Field field = told_of(d).field;
  if (field != Field::position && field != Field::speed) return false;
  const Telegram* last = newest(d, [](const Telegram& t) { return t.kind == "RMC" || t.kind == "GLL"; });
  if (!tells(last, d)) return false;
  if (field == Field::speed) {
    const Telegram* vtg = newest_kind(d, "VTG");
    return vtg && vtg->epoch && last->epoch && *last->epoch - *vtg->epoch <= 5s;
  }
  const Telegram* gga =
      newest(d, [&](const Telegram& t) { return t.kind == "GGA" && !same_epoch(utc_s(t), utc_s(*last)); });
  return gga && utc_s(*last) - utc_s(*gga) <= 5.0 && !same_epoch_fix(d.log, utc_s(*last));
}

/// No sentence of the epoch has told a speed yet: gpsd's is the way between its last two positions over their
/// time.
bool speed_of_positions(const Difference& d) {
  const Told& told = told_of(d);
  if (told.field != Field::speed) return false;
  struct Moment {
    double utc_s;
    Geodetic position;
  };
  std::vector<Moment> moments;  // the first one of each epoch
  for (std::size_t i = 0; i <= d.told; ++i) {
    if (d.log.told[i].field != Field::position) continue;
    const Telegram* sentence = newest({d.log, i, {}}, is_position);
    if (!sentence || (!moments.empty() && same_epoch(moments.back().utc_s, utc_s(*sentence)))) continue;
    const Value& value = d.log.told[i].value;
    moments.push_back({utc_s(*sentence), {Angle::deg(value.a), Angle::deg(value.b)}});
  }
  if (moments.size() < 2) return false;
  const Moment &now = moments.back(), &before = moments[moments.size() - 2];
  const double speed_mps =
      geo::geodesic(before.position, now.position).distance_m / (now.utc_s - before.utc_s);
  return std::abs(speed_mps - told.value.a) <= 0.01 + 0.01 * told.value.a;
}

/// Above a mean sea level, by a separation there may be.
bool height_above(double level_m, const Difference& d) {
  constexpr double kLargestSeparation_m = 110.0;
  return std::abs(told_of(d).value.a - level_m) <= kLargestSeparation_m;
}

bool own_geoid(const Difference& d) {
  const Telegram* gga = newest_kind(d, "GGA");
  return told_of(d).field == Field::height && gga && field_of(gga->text, 11).empty() &&
         height_above(std::atof(field_of(gga->text, 9).c_str()), d);
}

/// The log's first epoch: RMC or GLL came before GGA, its UTC was given out, and one UTC is one fix.
bool first_epoch(const Difference& d) {
  if (!position_or_height(d) || d.log.telegrams[told_of(d).at].kind == "ZDA") return false;
  const Telegram* gga = newest(d, [](const Telegram& t) { return t.kind == "GGA" || t.kind == "GNS"; });
  if (!tells(gga, d)) return false;
  for (const Telegram& t : d.log.telegrams) {
    if (&t == gga) return false;
    if ((t.kind == "RMC" || t.kind == "GLL") && same_epoch(utc_s(t), utc_s(*gga)))
      return std::any_of(t.facts.begin(), t.facts.end(), [](const Decoded::Fact& fact) {
        return std::holds_alternative<GnssFix>(fact.message);
      });
  }
  return false;
}

/// A new time, the last height again.
bool height_repeated(const Difference& d) {
  const Telegram& last = d.log.telegrams[told_of(d).at];
  return told_of(d).field == Field::height && last.kind == "ZDA" && tells(newest_kind(d, "GGA"), d);
}

bool altimeter(const Difference& d) {
  const std::string& last = d.log.telegrams[told_of(d).at].text;
  return told_of(d).field == Field::height && last.rfind("$PGRMZ,", 0) == 0 && field_of(last, 2) == "f" &&
         height_above(std::atof(field_of(last, 1).c_str()) * 0.3048, d);
}

/// The sentence says that it has no position; its clock may run free.
bool void_clock(const Difference& d) {
  if (told_of(d).field != Field::time_no_fix) return false;
  const Telegram* last = newest(d, [&](const Telegram& t) {
    return is_position(t) && same_epoch(utc_s(t), std::fmod(told_of(d).value.a, 86400.0));
  });
  if (!last || !last->facts.empty()) return false;
  return last->kind == "GGA" ? field_of(last->text, 6) == "0"
                             : field_of(last->text, last->kind == "RMC" ? 2 : 6) == "V";
}

/// Integers in a unit that is not known: 14223 is no heading in degrees, and 171 no pitch.
bool raw_units(const Difference& d) {
  const Field field = told_of(d).field;
  const auto begins = [](const Telegram& t, const char* with) { return t.text.rfind(with, 0) == 0; };
  const Telegram* last = newest(d, [&](const Telegram& t) {
    return begins(t, "$PTNTHTM,") || (field != Field::heading && begins(t, "$HCXDR,"));
  });
  if (!last) return false;
  const bool htm = begins(*last, "$PTNTHTM,");
  if (std::atof(field_of(last->text, htm ? 1 : 2).c_str()) <= (htm ? 360.0 : 90.0)) return false;
  const std::size_t n = field == Field::heading ? 1 : field == Field::pitch ? (htm ? 3 : 2) : htm ? 5 : 6;
  return std::to_string(std::lround(told_of(d).value.a)) == field_of(last->text, n);
}

/// Pitch in a sentence of its own: gpsd shows it beside the roll of before, we the pair once both are there.
bool half_attitude(const Difference& d) {
  const Field field = told_of(d).field;
  const std::size_t at = told_of(d).at;
  const Telegram& half = d.log.telegrams[at];
  if (field != Field::roll && field != Field::pitch) return false;
  if (half.kind != "XDR" || !half.facts.empty()) return false;
  for (std::size_t i = at + 1; i < d.log.telegrams.size(); ++i) {
    if (d.log.telegrams[i].kind != "XDR") continue;
    for (const auto& fact : d.log.telegrams[i].facts)
      if (const auto* attitude = std::get_if<Attitude>(&fact.message))
        return equal(field, {(field == Field::pitch ? attitude->pitch : attitude->roll).deg()},
                     told_of(d).value);
    return false;
  }
  const char* name = field == Field::pitch ? "PTCH" : "ROLL";  // the log ends before its other half
  return field_of(half.text, 4) == name &&
         equal(field, {std::atof(field_of(half.text, 2).c_str())}, told_of(d).value);
}

}  // namespace

const std::map<std::string, Rule>& rules() {
  static const std::map<std::string, Rule> all = {
      {"simulator", [](const Difference& d) { return gga_of_quality(d, {"8"}); }},
      {"no-fix",
       [](const Difference& d) {
         return gga_of_quality(d, {"0", ""});
       }},
      {"fewer-digits", fewer_digits},
      {"lesser-kind", lesser_kind},
      {"speed-of-positions", speed_of_positions},
      {"own-geoid", own_geoid},
      {"first-epoch", first_epoch},
      {"height-repeated", height_repeated},
      {"altimeter", altimeter},
      {"void-clock", void_clock},
      {"raw-units", raw_units},
      {"half-attitude", half_attitude},
  };
  return all;
}

std::vector<Row> read_rows(const std::string& path) {
  std::vector<Row> rows;
  std::istringstream in(read_text(path));
  for (std::string line; std::getline(in, line);) {
    if (line.rfind("| `", 0) != 0) continue;
    std::vector<std::string> cells;
    std::istringstream cells_in(line.substr(1));
    for (std::string cell; std::getline(cells_in, cell, '|');) {
      const auto begin = cell.find_first_not_of(" `"), end = cell.find_last_not_of(" `");
      cells.push_back(begin == std::string::npos ? "" : cell.substr(begin, end - begin + 1));
    }
    EXPECT_EQ(cells.size(), 6u) << line;
    if (cells.size() != 6) continue;
    const auto colon = cells[4].find(':');
    rows.push_back({cells[0], cells[1], cells[3], cells[2] == "no reading", cells[4].substr(0, colon),
                    std::atoi(cells[4].c_str() + colon + 1), cells[5]});
  }
  return rows;
}

}  // namespace leadline::test::gpsd
