#include "core/sim/telegrams/pd0_writer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "core/decode/trdi_pd0_ensemble.h"
#include "core/sim/telegrams/sentence.h"

namespace leadline::sim {
namespace {

using decode::kPd0Missing;
using decode::Pd0Coordinates;
using Four = std::array<std::optional<double>, 4>;

/// One data type of an ensemble, zero where nothing is put.
template <std::size_t N>
struct Block {
  std::array<std::uint8_t, N> bytes{};

  void u8(std::size_t at, std::int64_t value) { bytes[at] = static_cast<std::uint8_t>(value); }
  void u16(std::size_t at, std::int64_t value) { u8(at, value & 0xFF), u8(at + 1, value >> 8 & 0xFF); }
  void u32(std::size_t at, std::int64_t value) { u16(at, value & 0xFFFF), u16(at + 2, value >> 16 & 0xFFFF); }
  void clock(std::size_t at, const Civil& c) {
    const int fields[] = {
        c.year % 100, c.month, c.day, c.hour, c.minute, c.second, c.nanosecond / 10'000'000};
    for (const int field : fields) u8(at++, field);
  }
};

Pd0Coordinates coordinates_of(const std::string& name) {
  return name == "beam"    ? Pd0Coordinates::beam
         : name == "ship"  ? Pd0Coordinates::ship
         : name == "earth" ? Pd0Coordinates::earth
                           : Pd0Coordinates::instrument;
}

/// A velocity of the vehicle as PD0 gives it: of the bottom past the device, x to starboard (east), y forward
/// (north), z up.
Four components(const DvlOptions& o, const DvlMeasurement& m, const Eigen::Vector3d& v_s, bool all_beams) {
  const auto coordinates = coordinates_of(o.coordinates);
  if (coordinates == Pd0Coordinates::beam) {
    // Towards the transducer along each beam; the vehicle's velocity is minus the bottom's.
    const auto beams = beam_directions(o.beam_angle_deg * kRadPerDeg);
    // PD0's x runs from beam 1 to 2 and is starboard: beam 1 looks to port.
    const std::array<std::size_t, 4> looks{1, 0, 2, 3};
    Four radial;
    for (std::size_t i = 0; i < 4; ++i)
      if (all_beams || m.beam[i]) radial[i] = v_s.dot(beams[looks[i]]);
    return radial;
  }
  Eigen::Vector3d v = v_s;
  if (coordinates == Pd0Coordinates::ship) v = m.C_bs * v_s;
  if (coordinates == Pd0Coordinates::earth) v = Rotation<Ned, Instrument>::zyx(m.attitude).matrix() * v_s;
  const bool four = all_beams || std::all_of(m.beam.begin(), m.beam.end(), [](bool b) { return b; });
  return {-v.y(), -v.x(), v.z(), four ? std::optional(0.0) : std::nullopt};
}

std::int64_t in_mmps(const std::optional<double>& mps) {
  if (!mps) return kPd0Missing;
  return std::clamp<std::int64_t>(std::llround(*mps * 1e3), -32767, 32767);
}

Block<59> fixed_leader(const DvlOptions& o) {
  Block<59> b;
  b.u8(2, 56), b.u8(3, 1);
  b.u16(4, 0x0008 | (o.beam_angle_deg == 20.0 ? 0x0100 : 0x0200));  // convex, looking down
  b.u8(8, 4);
  b.u16(10, 1);
  const auto coordinates = static_cast<std::int64_t>(coordinates_of(o.coordinates));
  b.u8(25, coordinates << 3 | (o.coordinates == "earth" ? 0x04 : 0) | 0x02);
  const int sensors = 0x1D | (o.depth_told ? decode::kPd0DepthSensor : 0);
  b.u8(30, sensors), b.u8(31, sensors);
  b.u8(58, std::llround(o.beam_angle_deg));
  return b;
}

Block<65> variable_leader(const DvlOptions& o, const Civil& c, const DvlMeasurement& m) {
  Block<65> b;
  b.u16(0, 0x0080);
  b.u16(2, m.number & 0xFFFF), b.u8(11, m.number >> 16);
  b.clock(4, c);
  b.u16(14, std::llround(m.sound_speed_mps));
  b.u16(16, o.depth_told ? std::clamp<std::int64_t>(std::llround(m.depth_m * 10.0), 0, 65535) : 0);
  b.u16(18, o.attitude_told ? std::llround(m.attitude.heading.wrapped_2pi().deg() * 100.0) % 36000 : 0xFFFF);
  b.u16(20, o.attitude_told ? std::llround(m.attitude.pitch.deg() * 100.0) : kPd0Missing);
  b.u16(22, o.attitude_told ? std::llround(m.attitude.roll.deg() * 100.0) : kPd0Missing);
  b.u16(24, 35), b.u16(26, 1000);
  b.u8(57, c.year / 100);
  b.clock(58, c);
  return b;
}

Block<81> bottom_track(const DvlMeasurement& m, const Four& bottom, const Four& water) {
  constexpr std::array<std::size_t, 4> kLooks{1, 0, 2, 3};
  Block<81> b;
  b.u16(0, 0x0600);
  b.u16(2, 1);
  for (std::size_t i = 0; i < 4; ++i) {
    const std::int64_t range_cm = std::llround(m.range_m[kLooks[i]] * 100.0);
    b.u16(16 + 2 * i, range_cm & 0xFFFF), b.u8(77 + i, range_cm >> 16);
    b.u16(24 + 2 * i, in_mmps(bottom[i]));
    b.u8(32 + i, bottom[i] ? 255 : 0), b.u8(40 + i, bottom[i] ? 100 : 0);
    if (m.water_s) b.u16(50 + 2 * i, in_mmps(water[i])), b.u8(66 + i, 100);
  }
  if (m.water_s) b.u16(44, 10), b.u16(46, 50), b.u16(48, 150);
  return b;
}

Block<18> high_resolution(const Four& bottom) {
  Block<18> b;
  b.u16(0, 0x5803);
  for (std::size_t i = 0; i < 4; ++i)
    b.u32(2 + 4 * i, bottom[i] ? std::llround(*bottom[i] * 1e5) : std::int64_t{kPd0Missing} * 100);
  return b;
}

class Ensemble {
 public:
  Ensemble(std::string& bytes, std::size_t types) : bytes_(bytes), begin_(bytes.size()) {
    bytes_.append({'\x7F', '\x7F', '\0', '\0', '\0', static_cast<char>(types)});
    bytes_.append(2 * types, '\0');
  }
  template <std::size_t N>
  void add(const Block<N>& block) {
    put(6 + 2 * next_++, bytes_.size() - begin_);
    bytes_.append(reinterpret_cast<const char*>(block.bytes.data()), N);
  }
  void seal() {
    put(2, bytes_.size() - begin_);
    std::uint32_t sum = 0;
    for (std::size_t i = begin_; i < bytes_.size(); ++i) sum += static_cast<std::uint8_t>(bytes_[i]);
    bytes_.append(2, '\0');
    put(bytes_.size() - begin_ - 2, sum);
  }

 private:
  void put(std::size_t at, std::size_t value) {
    bytes_[begin_ + at] = static_cast<char>(value & 0xFF);
    bytes_[begin_ + at + 1] = static_cast<char>(value >> 8 & 0xFF);
  }
  std::string& bytes_;
  std::size_t begin_, next_ = 0;
};

}  // namespace

void write_pd0(const DvlOptions& o, Time device, const DvlMeasurement& m, Telegrams& out) {
  const Four none{};
  const Four bottom = m.bottom || o.coordinates == "beam" ? components(o, m, m.v_s, false) : none;
  const Four water = m.water_s ? components(o, m, *m.water_s, true) : none;
  Ensemble ensemble(out.bytes, o.high_resolution ? 4 : 3);
  ensemble.add(fixed_leader(o));
  ensemble.add(variable_leader(o, to_civil(rounded(device, 2)), m));
  ensemble.add(bottom_track(m, bottom, water));
  if (o.high_resolution) ensemble.add(high_resolution(bottom));
  ensemble.seal();
  out.end();
}

}  // namespace leadline::sim
