// USBL transceivers: PSIMSSB (Kongsberg), PTSAG and PTSAX (iXblue).

#include <bit>

#include "core/decode/nmea0183_sentences.h"
#include "core/decode/number.h"

namespace leadline::decode::nmea0183 {
namespace {

constexpr double kNoSensor_m = 9999.0;
constexpr double kFarthest_m = 1e5;

std::optional<double> positive(std::optional<double> sigma) {
  return sigma && *sigma > 0.0 ? sigma : std::nullopt;
}

std::optional<Depth> depth_of(std::optional<double> m) { return m ? std::optional(Depth{*m}) : std::nullopt; }

/// What PTSAG and PTSAX say after the place: hydrophones, calculated depth, which depth holds, sensor depth.
struct IxblueTail {
  bool usable = false;
  std::optional<double> depth_m;
};

IxblueTail read_tail(Fields& f, int n, std::int64_t fewest_hydrophones) {
  IxblueTail tail;
  const std::string_view hydrophones = f.text(n);
  const auto bits = hydrophones.size() == 1
                        ? parse_hex_byte(std::string_view(std::array{'0', hydrophones[0]}.data(), 2))
                        : std::nullopt;
  if (!bits) f.refuse(kReasonFields);
  tail.usable = bits && std::popcount(*bits) >= fewest_hydrophones;
  const auto calculated = f.number(n + 1);
  const auto kind = f.digits(n + 2, 2);
  auto sensor = f.number(n + 3);
  if (sensor == kNoSensor_m) sensor.reset();
  if (kind == 1u) tail.depth_m = calculated;
  if (kind == 2u) tail.depth_m = sensor ? sensor : calculated;
  return tail;
}

/// The transponder: 0 is the ship itself, below 0 unknown; empty with the refusal noted when malformed.
std::optional<int> read_id(Fields& f, int n) {
  const std::string_view text = f.text(n);
  const bool negative = !text.empty() && text[0] == '-';
  const auto digits = parse_digits(negative ? text.substr(1) : text);
  if (!digits) {
    f.refuse(kReasonFields);
    return std::nullopt;
  }
  if (*digits > 9999) f.refuse(kReasonRange);
  return negative ? -static_cast<int>(*digits) : static_cast<int>(*digits);
}

/// As the telegrams and the configuration may write it: "7", "07".
bool is_wanted(const DecoderSettings& settings, int id) {
  if (id <= 0) return false;
  const auto wanted = parse_digits(settings.address);
  return settings.address.empty() || (wanted && static_cast<int>(*wanted) == id);
}

Text<8> transponder_name(int id) {
  std::array<char, 8> digits{};
  std::size_t first = digits.size();
  for (; id > 0 && first > 0; id /= 10) digits[--first] = static_cast<char>('0' + id % 10);
  return Text<8>(std::string_view(digits.data() + first, digits.size() - first));
}

/// hhmmss.sss,dd,mm,yyyy in four fields from 2.
std::optional<Time> read_date_and_time(Fields& f) {
  const auto utc = f.time_of_day(2);
  const auto day = f.digits(3, 31), month = f.digits(4, 12), year = f.digits(5, 9999);
  if (!utc || !day || !month || !year) {
    f.refuse(kReasonFields);
    return std::nullopt;
  }
  const auto midnight = from_civil(
      {.year = static_cast<int>(*year), .month = static_cast<int>(*month), .day = static_cast<int>(*day)});
  if (!midnight) {
    f.refuse(kReasonRange);
    return std::nullopt;
  }
  return *midnight + Duration(*utc);
}

/// A PSIMSSB place in metres or radians as its letters say; of R and U x is latitude or northing.
struct SimradPlace {
  std::optional<double> x, y, depth_m, sd_m;
};

/// Does x of R and U come second? Northing is first, but Tritech's U,E is easting first.
bool easting_first(const ProfileOptions& profile, char coordinates, char orientation) {
  if (profile.usbl_order != "auto") return profile.usbl_order == "easting-first";
  return coordinates == 'U' && orientation == 'E';
}

void tell_place(Reading& r, std::optional<Time> time, std::string_view name, char coordinates,
                char orientation, const SimradPlace& p) {
  if (!p.x || !p.y) return;
  switch (coordinates) {
    case 'C':
      if (orientation == 'H')  // x starboard, y forward
        r.out.fact(time, UsblRelative{name, UsblAxes::head_up, *p.y, *p.x, p.depth_m, p.sd_m});
      else if (orientation == 'N')
        r.out.fact(time, UsblRelative{name, UsblAxes::north_up, *p.x, *p.y, p.depth_m, p.sd_m});
      else if (orientation == 'E')
        r.out.fact(time, UsblRelative{name, UsblAxes::north_up, *p.y, *p.x, p.depth_m, p.sd_m});
      break;
    case 'R':
      r.out.fact(time, UsblGeographic{name,
                                      {Angle::rad(*p.x), Angle::rad(*p.y >= kPi ? *p.y - 2.0 * kPi : *p.y)},
                                      depth_of(p.depth_m),
                                      p.sd_m});
      break;
    case 'U':
      r.out.fact(time, UsblGrid{name, *p.y, *p.x, depth_of(p.depth_m), p.sd_m});
      break;
    default:
      break;  // polar: which angle is meant is not public
  }
}

SimradPlace read_place(Fields& f, char coordinates, bool easting_first) {
  const bool radians = coordinates == 'R', grid = coordinates == 'U';
  const int x = easting_first && (radians || grid) ? 9 : 8;
  const double x_limit = radians ? kPi / 2.0 : grid ? 1e7 : kFarthest_m;
  const double y_limit = radians ? kPi : grid ? 1e7 : kFarthest_m;
  return {f.number(x, -x_limit, x_limit), f.number(17 - x, -y_limit, y_limit),
          f.number(10, -kFarthest_m, kFarthest_m), positive(f.number(11))};
}

}  // namespace

Verdict read_psimssb(Fields& f, Reading& r) {
  f.require(11);
  const auto utc = f.time_of_day(1);
  const std::string_view name = f.text(2);
  const char status = f.letter(3), coordinates = f.letter(5), orientation = f.letter(6), filter = f.letter(7);
  const SimradPlace place = read_place(f, coordinates, easting_first(r.profile, coordinates, orientation));
  if (!f.refusal().empty()) return refused(f.refusal());
  if (!r.settings.address.empty() && name != r.settings.address) return unused();
  const auto time = r.profile.usbl_clock == "local" ? std::nullopt : r.dated(utc);
  const bool measured =
      status == 'A' && f.text(4).empty() && (filter == 'M' || (filter == 'F' && r.profile.usbl_filtered));
  if (measured) tell_place(r, time, name, coordinates, orientation, place);
  return decoded();
}

Verdict read_ptsag(Fields& f, Reading& r) {
  f.require(14);
  const auto full = read_date_and_time(f);
  const auto id = read_id(f, 6);
  const auto position = f.position(7);
  const IxblueTail tail = read_tail(f, 11, r.profile.usbl_hydrophones);
  if (!f.refusal().empty()) return refused(f.refusal());
  if (!is_wanted(r.settings, *id)) return unused();
  const auto time = r.learn("PTSAG", *full);
  if (tail.usable && position)
    r.out.fact(time, UsblGeographic{transponder_name(*id), *position, depth_of(tail.depth_m), {}});
  return decoded();
}

Verdict read_ptsax(Fields& f, Reading& r) {
  const bool legacy = f.text(1).substr(0, 1) != "#";  // no frame number, no time
  const int first = legacy ? 1 : 6;
  f.require(first + 6);
  const auto full = legacy ? std::nullopt : read_date_and_time(f);
  const auto id = read_id(f, first);
  const auto x = f.number(first + 1, -kFarthest_m, kFarthest_m),
             y = f.number(first + 2, -kFarthest_m, kFarthest_m);
  const IxblueTail tail = read_tail(f, first + 3, r.profile.usbl_hydrophones);
  if (!f.refusal().empty()) return refused(f.refusal());
  if (!is_wanted(r.settings, *id)) return unused();
  const auto time = full ? r.learn("PTSAX", *full) : std::nullopt;
  if (tail.usable && x && y)
    r.out.fact(time, UsblRelative{transponder_name(*id), UsblAxes::head_up, *x, *y, tail.depth_m, {}});
  return decoded();
}

}  // namespace leadline::decode::nmea0183
