#include "core/decode/trdi_pd0_nmea.h"

#include <array>
#include <cmath>

#include "core/decode/byte_order.h"
#include "core/decode/number.h"

namespace leadline::decode {
namespace {

using Bytes = std::span<const std::uint8_t>;

constexpr std::size_t kHeaderBytes = 14;    // id, specific id, size, delta time
constexpr std::size_t kOldHeaderBytes = 4;  // id, size
constexpr double kLongestDelay_s = 3600.0;  // beyond it the delta time is garbage
constexpr double kMpsPerKnot = 1852.0 / 3600.0;
constexpr std::int64_t kNsPerS = 1'000'000'000;

void refuse(Pd0Nmea& block, std::string_view reason) {
  block.byte_class = ByteClass::refused;
  block.reason = reason;
}

std::string_view text_of(Bytes b) {
  const std::string_view text(reinterpret_cast<const char*>(b.data()), b.size());
  return text.substr(0, text.find_first_of(std::string_view("\0\r\n", 3)));
}

std::string_view formatter_of(std::string_view sentence) {
  return sentence.size() >= 6 ? sentence.substr(3, 3) : "";
}

std::optional<std::int64_t> utc_of_day_ns(std::string_view text) {
  if (text.size() < 6) return std::nullopt;
  const auto h = parse_digits(text.substr(0, 2)), m = parse_digits(text.substr(2, 2)),
             s = parse_digits(text.substr(4, 2));
  if (!h || !m || !s || *h > 23 || *m > 59 || *s > 59) return std::nullopt;
  std::int64_t ns = (*h * 3600 + *m * 60 + *s) * kNsPerS;
  if (text.size() == 6) return ns;
  const auto fraction = parse_digits(text.substr(7));
  if (text[6] != '.' || !fraction) return std::nullopt;
  std::int64_t unit = kNsPerS;
  for (std::size_t i = 7; i < text.size(); ++i) unit /= 10;
  return ns + *fraction * unit;
}

/// IEC 61162-1 GGA: 0 is no fix, 6 estimated, 7 manual, 8 simulated.
std::optional<GnssQuality> usable_quality(unsigned quality) {
  if (quality < 1 || quality > 5) return std::nullopt;
  return static_cast<GnssQuality>(quality);
}

/// What both forms of a GGA say, in degrees without sign.
struct Gga {
  std::optional<std::int64_t> utc_of_day_ns;
  double lat_deg, lon_deg;
  char north_south, east_west;
  GnssQuality quality;
  std::optional<double> satellites, hdop, altitude_m, geoid_m;
};

void take_gga(const Gga& g, Pd0Nmea& block) {
  const bool in_range = g.utc_of_day_ns && g.lat_deg >= 0.0 && g.lat_deg <= 90.0 && g.lon_deg >= 0.0 &&
                        g.lon_deg <= 180.0 && (g.north_south == 'N' || g.north_south == 'S') &&
                        (g.east_west == 'E' || g.east_west == 'W');
  if (!in_range) return refuse(block, "range");
  GnssFix fix;
  const double lon_deg = g.east_west == 'E' ? g.lon_deg : -g.lon_deg;
  fix.position = {Angle::deg(g.north_south == 'N' ? g.lat_deg : -g.lat_deg),
                  Angle::deg(lon_deg == 180.0 ? -180.0 : lon_deg)};
  fix.quality = g.quality;
  if (g.altitude_m && g.geoid_m && std::isfinite(*g.altitude_m + *g.geoid_m))
    fix.height = EllipsoidHeight{*g.altitude_m + *g.geoid_m};
  if (g.satellites && *g.satellites >= 0.0 && *g.satellites <= 255.0)
    fix.satellites = static_cast<std::uint8_t>(*g.satellites);
  if (g.hdop && std::isfinite(*g.hdop) && *g.hdop > 0.0) fix.hdop = *g.hdop;
  block.utc_of_day_ns = g.utc_of_day_ns;
  block.fix = fix;
  block.byte_class = ByteClass::decoded;
}

void take_vtg(std::optional<double> course_deg, double speed_kn, Pd0Nmea& block) {
  if (!(speed_kn >= 0.0 && speed_kn < 1000.0)) return refuse(block, "range");
  if (course_deg && !(*course_deg >= 0.0 && *course_deg <= 360.0)) return refuse(block, "range");
  Course course;
  course.speed_mps = speed_kn * kMpsPerKnot;
  if (course_deg) course.course = Angle::deg(*course_deg).wrapped_2pi();
  block.course = course;
  block.byte_class = ByteClass::decoded;
}

void take_dbt(double depth_m, Pd0Nmea& block) {
  if (!(depth_m > 0.0 && depth_m <= 12000.0)) return refuse(block, "range");
  block.depth = BottomDepth{depth_m, BottomDepth::Below::transducer};
  block.byte_class = ByteClass::decoded;
}

void read_binary_gga(Bytes b, Pd0Nmea& block) {
  if (b.size() < 57) return refuse(block, "nmea size");
  block.byte_class = ByteClass::unused;
  const auto quality = usable_quality(b[35]);
  if (!quality) return;
  Gga g{};
  g.utc_of_day_ns = utc_of_day_ns(text_of(b.subspan(7, 10)));
  g.lat_deg = le_f64(b, 17), g.north_south = static_cast<char>(b[25]);
  g.lon_deg = le_f64(b, 26), g.east_west = static_cast<char>(b[34]);
  g.quality = *quality;
  g.satellites = b[36], g.hdop = le_f32(b, 37);
  if (b[45] == 'M') g.altitude_m = le_f32(b, 41);
  if (b[50] == 'M') g.geoid_m = le_f32(b, 46);
  take_gga(g, block);
}

void read_binary_vtg(Bytes b, Pd0Nmea& block) {
  if (b.size() < 28) return refuse(block, "nmea size");
  block.byte_class = ByteClass::unused;
  if (b[27] == 'N' || b[21] != 'N') return;  // mode "not valid", or no speed in knots
  const std::optional<double> course_deg = b[11] == 'T' ? std::optional<double>(le_f32(b, 7)) : std::nullopt;
  take_vtg(course_deg, le_f32(b, 17), block);
}

void read_binary_dbt(Bytes b, Pd0Nmea& block) {
  if (b.size() < 22) return refuse(block, "nmea size");
  block.byte_class = ByteClass::unused;
  if (b[16] == 'M') take_dbt(le_f32(b, 12), block);
}

constexpr std::size_t kFields = 16;
using Fields = std::array<std::string_view, kFields>;

Fields split(std::string_view sentence) {
  Fields fields{};
  for (std::size_t i = 0; i < kFields; ++i) {
    const std::size_t comma = sentence.find(',');
    fields[i] = sentence.substr(0, comma);
    if (comma == std::string_view::npos) break;
    sentence.remove_prefix(comma + 1);
  }
  return fields;
}

char letter(std::string_view field) { return field.size() == 1 ? field[0] : '\0'; }

/// ddmm.mm or dddmm.mm.
std::optional<double> degrees(std::string_view field, std::size_t degree_digits) {
  if (field.size() < degree_digits + 2) return std::nullopt;
  const auto d = parse_digits(field.substr(0, degree_digits));
  const auto m = parse_number(field.substr(degree_digits));
  if (!d || !m || *m < 0.0 || *m >= 60.0) return std::nullopt;
  return *d + *m / 60.0;
}

void read_text_gga(const Fields& f, Pd0Nmea& block) {
  block.byte_class = ByteClass::unused;
  const auto quality = usable_quality(parse_digits(f[6]).value_or(0));
  if (!quality) return;
  const auto lat = degrees(f[2], 2), lon = degrees(f[4], 3);
  if (!lat || !lon) return refuse(block, "range");
  Gga g{};
  g.utc_of_day_ns = utc_of_day_ns(f[1]);
  g.lat_deg = *lat, g.north_south = letter(f[3]);
  g.lon_deg = *lon, g.east_west = letter(f[5]);
  g.quality = *quality;
  g.satellites = parse_number(f[7]), g.hdop = parse_number(f[8]);
  if (letter(f[10]) == 'M') g.altitude_m = parse_number(f[9]);
  if (letter(f[12]) == 'M') g.geoid_m = parse_number(f[11]);
  take_gga(g, block);
}

void read_text_vtg(const Fields& f, Pd0Nmea& block) {
  block.byte_class = ByteClass::unused;
  const auto speed_kn = parse_number(f[5]);
  if (!speed_kn || letter(f[9]) == 'N') return;
  take_vtg(parse_number(f[1]), *speed_kn, block);
}

void read_text_dbt(const Fields& f, Pd0Nmea& block) {
  block.byte_class = ByteClass::unused;
  if (const auto depth_m = parse_number(f[3])) take_dbt(*depth_m, block);
}

void read_text(Bytes body, Pd0Nmea& block) {
  std::string_view sentence = text_of(body);
  // Some loggers cut the checksum off; the ensemble's own covers such a sentence.
  if (const std::size_t star = sentence.find('*'); star != std::string_view::npos) {
    std::uint8_t sum = 0;
    for (const char c : sentence.substr(1, star - 1))
      sum = static_cast<std::uint8_t>(sum ^ static_cast<std::uint8_t>(c));
    if (parse_hex_byte(sentence.substr(star + 1)) != sum) return refuse(block, "checksum");
    sentence = sentence.substr(0, star);
  }
  const std::string_view formatter = formatter_of(sentence);
  const Fields fields = split(sentence);
  if (formatter == "GGA") return read_text_gga(fields, block);
  if (formatter == "VTG") return read_text_vtg(fields, block);
  if (formatter == "DBT") return read_text_dbt(fields, block);
  block.byte_class = ByteClass::unknown;
}

struct BinaryForm {
  int id;
  std::string_view kind, formatter;
  void (*read)(Bytes, Pd0Nmea&);
};
constexpr std::array<BinaryForm, 3> kBinaryForms = {{{104, "NMEA GGA", "GGA", read_binary_gga},
                                                     {105, "NMEA VTG", "VTG", read_binary_vtg},
                                                     {106, "NMEA DBT", "DBT", read_binary_dbt}}};

/// Header in hand: checks that the body is there and begins as a sentence does, else refuses it for
/// `no_sentence`.
bool open_body(Bytes type, std::size_t header, int size, std::string_view no_sentence, Pd0Nmea& block,
               Bytes& body) {
  block.length = type.size();
  if (size <= 0 || header + static_cast<std::size_t>(size) > type.size()) {
    refuse(block, "nmea size");
    return false;
  }
  body = type.subspan(header, static_cast<std::size_t>(size));
  block.length = header + body.size();
  if (body[0] == '$') return true;
  refuse(block, no_sentence);
  return false;
}

Pd0Nmea read_winriver2(Bytes type) {
  Pd0Nmea block;
  block.kind = "NMEA other";
  Bytes body;
  if (type.size() < kHeaderBytes) {
    block.length = type.size();
    refuse(block, "nmea size");
    return block;
  }
  const int id = le_i16(type, 2);
  const bool text = id >= 4 && id <= 6;
  const BinaryForm* form = nullptr;
  for (const BinaryForm& f : kBinaryForms)
    if (f.id == id) form = &f;
  if (text) block.kind = "NMEA text";
  if (form) block.kind = form->kind, block.binary = true;
  if (!open_body(type, kHeaderBytes, le_i16(type, 4), "nmea body", block, body)) return block;
  if (!text && !form) {
    block.byte_class = ByteClass::unknown;
    return block;
  }
  const double delta_s = le_f64(type, 6);
  if (!(std::abs(delta_s) <= kLongestDelay_s)) {
    refuse(block, "range");
    return block;
  }
  block.delta = duration(delta_s);
  if (text)
    read_text(body, block);
  else if (formatter_of(text_of(body)) == form->formatter)
    form->read(body, block);
  else
    refuse(block, "nmea body");
  return block;
}

Pd0Nmea read_older(Bytes type) {
  Pd0Nmea block;
  block.kind = "NMEA text";
  Bytes body;
  const int size = type.size() < kOldHeaderBytes ? 0 : le_i16(type, 2);
  if (open_body(type, kOldHeaderBytes, size, "nmea text", block, body)) read_text(body, block);
  return block;
}

}  // namespace

std::optional<Pd0Nmea> read_pd0_nmea(Bytes type) {
  if (type.size() < 2) return std::nullopt;
  switch (le_u16(type, 0)) {
    case 0x2022:
      return read_winriver2(type);
    case 0x2100:
    case 0x2101:
    case 0x2102:
      return read_older(type);
    default:
      return std::nullopt;
  }
}

}  // namespace leadline::decode
