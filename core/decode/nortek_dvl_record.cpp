#include <algorithm>
#include <cmath>
#include <cstring>

#include "core/decode/byte_order.h"
#include "core/decode/nortek_dvl_ping.h"

namespace leadline::decode {
namespace {

using Is = FrameStart::Is;
using Bytes = std::span<const std::uint8_t>;

constexpr std::uint8_t kSync = 0xA5, kFamily = 0x10;
constexpr std::size_t kLongestRecord = 32 * 1024;
constexpr std::size_t kLongestSentence = 512;
constexpr double kFastest_mps = 30.0, kFarthest_m = 12000.0, kLongestDelay_s = 30.0;

struct Known {
  std::uint8_t id;
  std::string_view kind;
};
constexpr Known kKnown[] = {{kNortekBottomTrack, "bottom track"},
                            {kNortekWaterTrack, "water track"},
                            {0x15, "burst"},
                            {0x16, "profile"},
                            {0x17, "bottom track DF20"},
                            {0x1C, "echo sounder"},
                            {0xA0, "string"}};

std::string_view kind_of(std::uint8_t id) {
  for (const Known& known : kKnown)
    if (known.id == id) return known.kind;
  return "AD2CP";
}

FrameStart record_start(Bytes b) {
  if (b.size() >= 2 && b[1] != kNortekHeader) return {};
  if (b.size() >= 4 && b[3] != kFamily) return {};
  const std::string_view kind = b.size() >= 3 ? kind_of(b[2]) : "";
  if (b.size() < kNortekHeader) return {Is::unsettled, 0, kind, {}};
  const std::size_t size = le_u16(b, 4), whole = kNortekHeader + size;
  if (nortek_checksum(b.first(8)) != le_u16(b, 8)) return {Is::broken, whole, kind, "checksum"};
  if (size > kLongestRecord) return {Is::broken, whole, kind, "too long"};
  if (b.size() < whole) return {Is::unsettled, 0, kind, {}};
  if (nortek_checksum(b.subspan(kNortekHeader, size)) != le_u16(b, 6))
    return {Is::broken, whole, kind, "checksum"};
  return {Is::frame, whole, kind, {}};
}

/// A line, with its terminator where it has one.
FrameStart sentence_start(Bytes b, bool ended) {
  constexpr std::string_view kStart = "$PNOR", kKind = "sentence";
  const std::string_view text(reinterpret_cast<const char*>(b.data()), std::min(b.size(), kLongestSentence));
  const std::size_t shown = std::min(text.size(), kStart.size());
  if (text.substr(0, shown) != kStart.substr(0, shown)) return {};
  if (shown < kStart.size()) return {Is::unsettled, 0, {}, {}};
  for (std::size_t i = shown; i < text.size(); ++i) {
    const char c = text[i];
    if (c == '\n') return {Is::frame, i + 1, kKind, {}};
    if (c == '\r') {
      if (i + 1 == b.size() && !ended) return {Is::unsettled, 0, kKind, {}};
      return {Is::frame, i + 1 + (i + 1 < b.size() && b[i + 1] == '\n'), kKind, {}};
    }
    if (c == '$' || c < 0x20 || c > 0x7E) return {Is::broken, i, kKind, "torn"};
  }
  if (text.size() == kLongestSentence) return {Is::broken, kLongestSentence, kKind, "too long"};
  const bool whole = text.size() > 3 && text[text.size() - 3] == '*';
  if (ended && whole) return {Is::frame, text.size(), kKind, {}};
  return {Is::unsettled, 0, kKind, {}};
}

std::optional<Time> trigger_of(Bytes r) {
  const std::int32_t ns = le_u16(r, 12) * 100'000;
  if (ns >= 1'000'000'000 || 1900 + r[6] < 2000) return std::nullopt;  // its clock was never set
  return from_civil({1900 + r[6], r[7] + 1, r[8], r[9], r[10], r[11], ns});
}

/// The fields that a DF21 record's status word vouches for.
class Fields {
 public:
  Fields(Bytes record, std::size_t data) : r_(record), data_(data), status_(le_u32(record, 20)) {}

  /// at: as in a record whose data starts at 36. Empty: not vouched for, or its marker says invalid.
  std::optional<double> valid(int bit, std::size_t at, double marker) {
    if ((status_ >> bit & 1) == 0) return std::nullopt;
    const double value = number(at);
    return std::abs(value - marker) < 1e-4 ? std::nullopt : std::optional(value);
  }
  double number(std::size_t at) {
    const double value = le_f32(r_, data_ + at - kNortekDataStart);
    if (!std::isfinite(value)) sound_ = false;
    return value;
  }
  void require(bool in_range) { sound_ = sound_ && in_range; }
  [[nodiscard]] bool sound() const { return sound_; }

 private:
  Bytes r_;
  std::size_t data_;
  std::uint32_t status_;
  bool sound_ = true;
};

void read_velocity(Fields& f, NortekPing& ping) {
  constexpr double kNoVelocity = -32.768, kNoFom = 10.0;
  const auto x = f.valid(12, 132, kNoVelocity), y = f.valid(13, 136, kNoVelocity);
  const auto z1 = f.valid(14, 140, kNoVelocity), z2 = f.valid(15, 144, kNoVelocity);
  for (const auto& v : {x, y, z1, z2}) f.require(!v || std::abs(*v) <= kFastest_mps);
  if (!x || !y || (!z1 && !z2)) return;
  ping.velocity = {*x, *y, z1 && z2 ? 0.5 * (*z1 + *z2) : z1 ? *z1 : *z2};
  const auto sd_x = f.valid(16, 148, kNoFom), sd_y = f.valid(17, 152, kNoFom);
  if (sd_x && sd_y) ping.sd_mps = std::max(*sd_x, *sd_y);
  f.require(!ping.sd_mps || *ping.sd_mps >= 0.0);
  ping.delay_s = 0.5 * (f.number(164) + f.number(168));
}

}  // namespace

std::uint16_t nortek_checksum(Bytes bytes) {
  // Four words at a time: the sums of even and odd words cannot run over in so short a record.
  const std::uint8_t* p = bytes.data();
  std::size_t left = bytes.size();
  std::uint64_t even = 0, odd = 0;
  for (; left >= 8; p += 8, left -= 8) {
    constexpr std::uint64_t kEven = 0x0000'FFFF'0000'FFFF;
    std::uint64_t w = 0;
    std::memcpy(&w, p, sizeof w);
    even += w & kEven, odd += w >> 16 & kEven;
  }
  std::uint64_t sum = 0xB58C + (even & 0xFFFF'FFFF) + (even >> 32) + (odd & 0xFFFF'FFFF) + (odd >> 32);
  for (; left >= 2; p += 2, left -= 2) sum += static_cast<std::uint64_t>(p[0] | p[1] << 8);
  if (left == 1) sum += static_cast<std::uint64_t>(p[0]) << 8;
  return static_cast<std::uint16_t>(sum);
}

FrameStart nortek_start(Bytes rest, bool ended) {
  if (rest[0] == kSync) return record_start(rest);
  if (rest[0] == '$') return sentence_start(rest, ended);
  return {};
}

NortekVerdict read_nortek_record(Bytes frame) {
  const std::uint8_t id = frame[2];
  if (id != kNortekBottomTrack && id != kNortekWaterTrack)
    return {kind_of(id) == "AD2CP" ? ByteClass::unknown : ByteClass::unused, {}};
  const Bytes r = frame.subspan(kNortekHeader);
  if (r.size() < kNortekRecord || r[0] != 1) return {ByteClass::refused, "fields"};
  const std::size_t data = r[1];
  if (data < kNortekDataStart || data + kNortekRecord - kNortekDataStart > r.size())
    return {ByteClass::refused, "fields"};

  NortekVerdict verdict{ByteClass::decoded, {}};
  NortekPing& ping = verdict.ping;
  ping.water = id == kNortekWaterTrack;
  ping.trigger = trigger_of(r);
  Fields f(r, data);
  read_velocity(f, ping);
  for (int beam = 0; beam < 4; ++beam) {
    const auto i = static_cast<std::size_t>(beam);
    ping.distance_m[i] = f.valid(4 + beam, 52 + 4 * i, 0.0).value_or(0.0);
    f.require(ping.distance_m[i] >= 0.0 && ping.distance_m[i] <= kFarthest_m);
  }
  const double sound_speed_mps = le_f32(r, 24), pressure_bar = le_f32(r, 32);
  f.require(std::isfinite(sound_speed_mps) && std::isfinite(pressure_bar));
  f.require(std::abs(ping.delay_s) <= kLongestDelay_s);
  if (!f.sound()) return {ByteClass::refused, "range"};
  ping.sound_speed_mps = sound_speed_mps;
  ping.pressure_bar = pressure_bar;
  return verdict;
}

}  // namespace leadline::decode
