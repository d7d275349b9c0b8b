#include "core/sim/telegrams/nortek_writer.h"

#include <array>

#include "core/decode/nortek_dvl_ping.h"
#include "core/encode/sentence.h"
#include "core/sim/telegrams/binary_writer.h"

namespace leadline::sim {
namespace {

constexpr std::array<std::size_t, 4> kLooks{2, 0, 3, 1};
constexpr double kDelay_s = 0.004, kNoVelocity = -32.768, kNoFom = 10.0;

std::uint32_t status_of(const DvlMeasurement& m, bool valid) {
  std::uint32_t status = valid ? 0x000FF000 : 0;
  for (unsigned beam = 0; beam < 4; ++beam)
    if (m.beam[kLooks[beam]]) status |= 1u << (4 + beam);
  return status;
}

void write_record(std::uint8_t id, Time device, const DvlMeasurement& m, const Eigen::Vector3d& v, bool valid,
                  double sd_mps, Telegrams& out) {
  BinaryWriter w(out, BinaryWriter::Order::little);
  w.u8(0xA5), w.u8(decode::kNortekHeader), w.u8(id), w.u8(0x10);
  w.u16(decode::kNortekRecord), w.u16(0), w.u16(0);
  const Civil c = to_civil(encode::rounded(device - duration(kDelay_s), 4));
  w.u8(1), w.u8(decode::kNortekDataStart), w.u32(102'345);
  w.u8(static_cast<std::uint64_t>(c.year - 1900)), w.u8(static_cast<std::uint64_t>(c.month - 1));
  for (const int v8 : {c.day, c.hour, c.minute, c.second}) w.u8(static_cast<std::uint64_t>(v8));
  w.u16(static_cast<std::uint64_t>(c.nanosecond / 100'000)), w.u16(4), w.u32(0), w.u32(status_of(m, valid));
  w.f32(m.sound_speed_mps), w.f32(10.0), w.f32(0.1 * m.depth_m);
  const auto four = [&](double value) {
    for (int i = 0; i < 4; ++i) w.f32(value);
  };
  four(kNoVelocity);
  for (const std::size_t beam : kLooks) w.f32(m.beam[beam] ? m.range_m[beam] : 0.0);
  four(kNoFom), four(kDelay_s), four(-0.1), four(0.02);
  if (valid)
    w.f32(v.x()), w.f32(v.y()), w.f32(v.z()), w.f32(v.z());
  else
    four(kNoVelocity);
  four(valid ? sd_mps : kNoFom), four(kDelay_s), four(-0.1), four(0.02);
  w.patch_u16(6, decode::nortek_checksum(w.written(decode::kNortekHeader)));
  w.patch_u16(8, decode::nortek_checksum(w.written().first(8)));
  out.end();
}

}  // namespace

void write_nortek(const DvlOptions& o, Time device, const DvlMeasurement& m, Telegrams& out) {
  write_record(decode::kNortekBottomTrack, device, m, m.v_s, m.bottom, o.noise_mps, out);
  if (m.water_s) write_record(decode::kNortekWaterTrack, device, m, *m.water_s, true, o.water_noise_mps, out);
}

}  // namespace leadline::sim
