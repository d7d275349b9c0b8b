#include "core/decode/trdi_pd6_lines.h"

#include <cmath>

#include "core/decode/number.h"

namespace leadline::decode {
namespace {

constexpr std::array<std::string_view, 12> kNames{"SA", "TS", "RA", "WI", "WS", "WE",
                                                  "WD", "BI", "BS", "BE", "BD", "HM"};
constexpr double kMissing_mmps = -32768.0;
constexpr double kFastest_mmps = 16'000.0;  ///< beyond any DVL: a digit was damaged
constexpr double kFarthest_m = 1e8;
constexpr double kDeepest_m = 12'000.0;

/// The fields of one line after its address, padding removed; the first fault is kept.
class Fields {
 public:
  explicit Fields(std::string_view text) : rest_(text) {}

  std::string_view text() {
    if (ended_) refuse("fields");
    const std::size_t comma = rest_.find(',');
    std::string_view field = rest_.substr(0, comma);
    ended_ = comma == std::string_view::npos;
    rest_ = ended_ ? std::string_view{} : rest_.substr(comma + 1);
    while (!field.empty() && field.front() == ' ') field.remove_prefix(1);
    while (!field.empty() && field.back() == ' ') field.remove_suffix(1);
    return field;
  }
  double number(double least, double most) {
    const auto value = parse_number(text());
    if (!value) refuse("fields");
    if (value && !(*value >= least && *value <= most)) refuse("range");
    return value.value_or(0.0);
  }
  char letter() {
    const std::string_view field = text();
    const bool is_letter = field.size() == 1 && field[0] >= 'A' && field[0] <= 'Z';
    if (!is_letter) refuse("fields");
    return is_letter ? field[0] : '\0';
  }
  void refuse(std::string_view reason) {
    if (refusal_ != "fields") refusal_ = reason;
  }
  /// To be asked when all fields are read: one more is one too many.
  std::string_view refusal() {
    if (!ended_) refuse("fields");
    return refusal_;
  }

 private:
  std::string_view rest_, refusal_;
  bool ended_ = false;
};

Pd6Velocity read_velocity(Fields& f, bool with_error) {
  Pd6Velocity v;
  bool whole = true;
  const auto component = [&]() -> std::optional<double> {
    const double mmps = f.number(kMissing_mmps, -kMissing_mmps);
    if (mmps == kMissing_mmps) return std::nullopt;
    if (std::abs(mmps) > kFastest_mmps) f.refuse("range");
    return mmps;
  };
  for (double& axis : v.mmps) {
    const auto mmps = component();
    whole = whole && mmps;
    axis = mmps.value_or(0.0);
  }
  if (with_error) v.error_mmps = component();
  v.good = f.letter() == 'A' && whole;
  return v;
}

int two_digits(std::string_view text, std::size_t at) { return (text[at] - '0') * 10 + (text[at + 1] - '0'); }

/// YYMMDDHHmmsshh; all zero: no clock.
std::optional<Civil> read_clock(Fields& f) {
  const std::string_view t = f.text();
  const bool digits = t.size() == 14 && t.find_first_not_of("0123456789") == std::string_view::npos;
  if (!digits) f.refuse("fields");
  if (!digits || t.find_first_not_of('0') == std::string_view::npos) return std::nullopt;
  Civil c;
  c.year = two_digits(t, 0), c.month = two_digits(t, 2), c.day = two_digits(t, 4);
  c.hour = two_digits(t, 6), c.minute = two_digits(t, 8), c.second = two_digits(t, 10);
  c.nanosecond = two_digits(t, 12) * 10'000'000;
  if (c.month < 1 || c.month > 12 || c.day < 1 || c.day > 31 || c.hour > 23 || c.minute > 59 || c.second > 60)
    f.refuse("range");
  return c;
}

Pd6Ping::Timing read_timing(Fields& f) {
  Pd6Ping::Timing t;
  t.clock = read_clock(f);
  (void)f.number(0.0, 100.0);   // salinity
  (void)f.number(-20.0, 80.0);  // temperature
  t.depth_m = f.number(-100.0, kDeepest_m);
  t.sound_speed_mps = f.number(0.0, 2000.0);
  const auto test = parse_digits(f.text());
  if (!test) f.refuse("fields");
  t.built_in_test = test.value_or(0);
  return t;
}

Pd6Ping::Distance read_distance(Fields& f) {
  for (int axis = 0; axis < 3; ++axis) (void)f.number(-kFarthest_m, kFarthest_m);
  Pd6Ping::Distance d;
  d.range_m = f.number(0.0, kDeepest_m);
  d.since_good_s = f.number(0.0, kFarthest_m);
  return d;
}

/// The value read, if its line holds.
template <class T>
std::string_view put(Fields& f, const T& value, std::optional<T>& into) {
  const std::string_view refusal = f.refusal();
  if (refusal.empty()) into = value;
  return refusal;
}

std::string_view read_health(Fields& f, Pd6Ping& ping) {
  const char a = f.letter(), b = f.letter();
  for (int i = 0; i < 2; ++i) (void)f.text();  // the sensors' counts, hexadecimal
  for (int i = 0; i < 3; ++i) (void)f.number(-1e6, 1e6);
  if (f.refusal().empty()) ping.leak = {a, b};
  return f.refusal();
}

}  // namespace

double Pd6Velocity::size_mmps() const { return std::hypot(mmps[0], mmps[1], mmps[2]); }

std::string_view pd6_name(Pd6Line line) { return kNames[static_cast<std::size_t>(line)]; }

std::optional<Pd6Line> pd6_line(std::string_view text) {
  if (text.size() < 4 || text[0] != ':' || text[3] != ',') return std::nullopt;
  const std::string_view name = text.substr(1, 2);
  for (std::size_t i = 0; i < kNames.size(); ++i)
    if (kNames[i] == name) return static_cast<Pd6Line>(i);
  return std::nullopt;
}

std::string_view read_pd6_line(Pd6Line line, std::string_view text, Pd6Ping& ping) {
  Fields f(text.substr(4));
  switch (line) {
    case Pd6Line::SA: {
      Pd6Ping::Attitude a;
      a.pitch_deg = f.number(-90.0, 90.0);
      a.roll_deg = f.number(-180.0, 180.0);
      a.heading_deg = f.number(0.0, 360.0);
      return put(f, a, ping.attitude);
    }
    case Pd6Line::TS: {
      const auto timing = read_timing(f);
      return put(f, timing, ping.timing);
    }
    case Pd6Line::RA: {
      Pd6Ping::Ranges r;
      r.pressure_kpa = f.number(-1e4, 1e6);
      for (double& range_dm : r.range_dm) range_dm = f.number(0.0, 10.0 * kDeepest_m);
      return put(f, r, ping.ranges);
    }
    case Pd6Line::WI:
    case Pd6Line::WS:
    case Pd6Line::WE: {
      const auto v = read_velocity(f, line == Pd6Line::WI);
      return put(f, v, ping.water[static_cast<std::size_t>(line) - static_cast<std::size_t>(Pd6Line::WI)]);
    }
    case Pd6Line::BI:
    case Pd6Line::BS:
    case Pd6Line::BE: {
      const auto v = read_velocity(f, line == Pd6Line::BI);
      return put(f, v, ping.bottom[static_cast<std::size_t>(line) - static_cast<std::size_t>(Pd6Line::BI)]);
    }
    case Pd6Line::WD: {  // distance through the water: nobody asks for it
      std::optional<Pd6Ping::Distance> through_water;
      const auto distance = read_distance(f);
      return put(f, distance, through_water);
    }
    case Pd6Line::BD: {
      const auto distance = read_distance(f);
      return put(f, distance, ping.distance);
    }
    case Pd6Line::HM:
      break;
  }
  return read_health(f, ping);
}

}  // namespace leadline::decode
