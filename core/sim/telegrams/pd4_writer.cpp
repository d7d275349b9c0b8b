#include "core/sim/telegrams/pd4_writer.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/decode/trdi_pd4_frame.h"
#include "core/sim/telegrams/sentence.h"
#include "core/types/rotation.h"

namespace leadline::sim {
namespace {

class Frame {
 public:
  explicit Frame(std::string& bytes) : bytes_(bytes), begin_(bytes.size()) {}
  void u8(std::int64_t value) { bytes_.push_back(static_cast<char>(value & 0xFF)); }
  void u16(std::int64_t value) { u8(value), u8(value >> 8); }
  void mmps(double mps) { u16(std::clamp<std::int64_t>(std::llround(mps * 1e3), -32767, 32767)); }
  void seal() {
    std::uint32_t sum = 0;
    for (std::size_t i = begin_; i < bytes_.size(); ++i) sum += static_cast<std::uint8_t>(bytes_[i]);
    u16(sum & 0xFFFF);
  }

 private:
  std::string& bytes_;
  std::size_t begin_;
};

void put_velocity(Frame& f, const DvlOptions& o, const DvlMeasurement& m, const Eigen::Vector3d& v_s,
                  bool good, bool all_beams) {
  Eigen::Vector3d v = v_s;
  if (o.coordinates == "ship") v = m.C_bs * v_s;
  if (o.coordinates == "earth") v = Rotation<Ned, Instrument>::zyx(m.attitude).matrix() * v_s;
  if (good)
    f.mmps(v.y()), f.mmps(v.x()), f.mmps(-v.z());
  else
    for (int axis = 0; axis < 3; ++axis) f.u16(decode::kPd0Missing);
  f.u16(good && all_beams ? 0 : decode::kPd0Missing);
}

}  // namespace

void write_pd4(const DvlOptions& o, Time device, const DvlMeasurement& m, Telegrams& out) {
  constexpr std::array<std::size_t, 4> kLooks{1, 0, 2, 3};  // beam 1 looks to port
  const bool pd5 = o.attitude_told || o.depth_told;
  Frame f(out.bytes);
  f.u8(0x7D), f.u8(pd5), f.u16((pd5 ? decode::kPd5Bytes : decode::kPd4Bytes) - 2);
  const int coordinates = o.coordinates == "earth" ? 3 : o.coordinates == "ship" ? 2 : 1;
  f.u8(coordinates << 6 | (coordinates == 3 ? 0x20 : 0) | 0x10 | 0x03);
  const bool all_beams = std::all_of(m.beam.begin(), m.beam.end(), [](bool b) { return b; });
  put_velocity(f, o, m, m.v_s, m.bottom, all_beams);
  int low = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    f.u16(std::clamp<std::int64_t>(std::llround(m.range_m[kLooks[i]] * 100.0), 0, 65535));
    if (!m.beam[kLooks[i]]) low |= 2 << 2 * i;
  }
  f.u8(low);
  put_velocity(f, o, m, m.water_s.value_or(Eigen::Vector3d::Zero()), m.water_s.has_value(), true);
  f.u16(m.water_s ? 50 : 0), f.u16(m.water_s ? 150 : 0), f.u8(0);
  const Civil c = to_civil(rounded(device, 2));
  f.u8(c.hour), f.u8(c.minute), f.u8(c.second), f.u8(c.nanosecond / 10'000'000);
  f.u16(0), f.u16(std::llround(m.sound_speed_mps)), f.u16(1000);
  if (pd5) {
    f.u8(35);
    f.u16(o.depth_told ? std::clamp<std::int64_t>(std::llround(m.depth_m * 10.0), 0, 65535) : 0);
    const auto cdeg = [&](Angle a) { return o.attitude_told ? std::llround(a.deg() * 100.0) : 0; };
    f.u16(cdeg(m.attitude.pitch)), f.u16(cdeg(m.attitude.roll));
    f.u16(cdeg(m.attitude.heading.wrapped_2pi()) % 36000);
    for (int distance = 0; distance < 8; ++distance) f.u16(0), f.u16(0);
  }
  f.seal();
  out.end();
}

}  // namespace leadline::sim
