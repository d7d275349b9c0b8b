#include <array>
#include <charconv>
#include <cmath>

#include "core/decode/nortek_dvl_ping.h"
#include "core/decode/number.h"

namespace leadline::decode {
namespace {

constexpr std::size_t kMost = 16;
constexpr double kFastest_mps = 30.0, kFarthest_m = 12000.0;
// The maker's examples have DT1 = 23.961 for a ping of 24 ms: milliseconds, where the binary record has
// seconds.
constexpr double kDelayUnit_s = 1e-3, kLongestDelay = 30'000.0;

using Values = std::array<std::string_view, kMost>;
constexpr Values kPingKeys = {"TIME", "DT1", "DT2", "VX",   "VY", "VZ",    "FOM",  "D1",
                              "D2",   "D3",  "D4",  "BATT", "SS", "PRESS", "TEMP", "STAT"};

/// The values in the order of their fields; in a tagged sentence each has its key before it. False: another
/// number of fields, or other keys.
bool split(std::string_view fields, std::size_t count, bool tagged, Values& values) {
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t comma = fields.find(',');
    if ((comma == std::string_view::npos) != (i + 1 == count)) return false;
    std::string_view field = fields.substr(0, comma);
    if (tagged) {
      const std::size_t equals = field.find('=');
      if (equals == std::string_view::npos || field.substr(0, equals) != kPingKeys[i]) return false;
      field.remove_prefix(equals + 1);
    }
    values[i] = field;
    if (comma != std::string_view::npos) fields.remove_prefix(comma + 1);
  }
  return true;
}

/// The numbers of one sentence; the first that is none or out of range refuses it.
class Numbers {
 public:
  explicit Numbers(const Values& values) : values_(values) {}

  double number(std::size_t i, double lowest, double highest) {
    const auto value = parse_number(values_[i]);
    if (!value) refuse("fields");
    if (value && (*value < lowest || *value > highest)) refuse("range");
    return value.value_or(0.0);
  }
  /// Empty when it is the marker of an invalid one.
  std::optional<double> unless(double marker, std::size_t i, double lowest, double highest) {
    const auto value = parse_number(values_[i]);
    if (value && std::abs(*value - marker) < 1e-4) return std::nullopt;
    return number(i, lowest, highest);
  }
  std::uint32_t hex(std::size_t i) {
    std::string_view text = values_[i];
    std::uint32_t value = 0;
    if (text.substr(0, 2) == "0x" || text.substr(0, 2) == "0X") text.remove_prefix(2);
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value, 16);
    if (text.empty() || error != std::errc() || end != text.data() + text.size()) refuse("fields");
    return value;
  }
  [[nodiscard]] std::string_view refusal() const { return refusal_; }

 private:
  void refuse(std::string_view reason) {
    if (refusal_.empty()) refusal_ = reason;
  }
  const Values& values_;
  std::string_view refusal_;
};

NortekVerdict read_ping(const Values& v, bool water, bool full) {
  NortekVerdict verdict{ByteClass::decoded, {}};
  NortekPing& ping = verdict.ping;
  ping.water = water;
  Numbers n(v);
  constexpr double kFirst_s = 946'684'800.0, kLast_s = 9e9;  // before 2000 its clock was never set
  const double unix_s = n.number(0, 0.0, kLast_s);
  if (unix_s >= kFirst_s && unix_s <= kLast_s) ping.trigger = from_unix(unix_s);
  ping.delay_s = n.number(1, -kLongestDelay, kLongestDelay) * kDelayUnit_s;
  (void)n.number(2, -kLongestDelay, kLongestDelay);
  const auto x = n.unless(-32.768, 3, -kFastest_mps, kFastest_mps),
             y = n.unless(-32.768, 4, -kFastest_mps, kFastest_mps),
             z = n.unless(-32.768, 5, -kFastest_mps, kFastest_mps);
  const auto fom = n.unless(10.0, 6, 0.0, 1000.0);
  for (std::size_t i = 0; i < 4; ++i) ping.distance_m[i] = n.number(7 + i, 0.0, kFarthest_m);
  std::uint32_t status = 0xFFFFFFFF;
  if (full) {
    (void)n.number(11, 0.0, 1000.0);
    ping.sound_speed_mps = n.number(12, 0.0, 10'000.0);
    ping.pressure_bar = n.number(13, -10.0, 2000.0);
    (void)n.number(14, -100.0, 200.0);
    status = n.hex(15);
  }
  if (!n.refusal().empty()) return {ByteClass::refused, n.refusal()};
  for (int beam = 0; beam < 4; ++beam)
    if ((status >> (4 + beam) & 1) == 0) ping.distance_m[static_cast<std::size_t>(beam)] = 0.0;
  const bool vouched = (status >> 12 & 3) == 3 && (status >> 14 & 3) != 0;
  if (x && y && z && vouched) ping.velocity = {*x, *y, *z};
  if (ping.velocity && (status >> 16 & 3) == 3) ping.sd_mps = fom;
  return verdict;
}

}  // namespace

NortekVerdict read_nortek_sentence(std::string_view fields) {
  const std::string_view address = fields.substr(0, fields.find(','));
  const bool bottom = address.substr(0, 6) == "PNORBT", water = address.substr(0, 6) == "PNORWT";
  if ((!bottom && !water) || address.size() != 7 || address.size() == fields.size())
    return {ByteClass::unused, {}};
  const char form = address[6];
  const bool tagged = form == '6' || form == '8', full = form == '8' || form == '9';
  // 0 and 1 tell one beam, 3 and 4 a speed without its third component: neither is a velocity.
  if (form < '6' || form > '9') return {ByteClass::unused, {}};
  Values values{};
  if (!split(fields.substr(8), full ? 16 : 11, tagged, values)) return {ByteClass::refused, "fields"};
  return read_ping(values, water, full);
}

}  // namespace leadline::decode
