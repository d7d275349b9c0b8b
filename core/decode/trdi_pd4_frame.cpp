#include "core/decode/trdi_pd4_frame.h"

#include "core/decode/byte_order.h"
#include "core/decode/trdi_pd0_framing.h"

namespace leadline::decode {

int Pd4Frame::beams_low() const {
  int low = 0;
  for (int beam = 0; beam < 4; ++beam) low += (bottom_status >> 2 * beam & 3) != 0;
  return low;
}

Pd4Frame read_pd4_frame(std::span<const std::uint8_t> b) {
  Pd4Frame f;
  f.configuration = b[4];
  for (std::size_t i = 0; i < 4; ++i) {
    f.bottom_mmps[i] = le_i16(b, 5 + 2 * i);
    f.range_cm[i] = le_u16(b, 13 + 2 * i);
    f.water_mmps[i] = le_i16(b, 22 + 2 * i);
  }
  f.bottom_status = b[21];
  f.layer_start_dm = le_u16(b, 30), f.layer_end_dm = le_u16(b, 32);
  f.water_status = b[34];
  f.hour = b[35], f.minute = b[36], f.second = b[37], f.hundredths = b[38];
  f.built_in_test = le_u16(b, 39);
  f.sound_speed_mps = le_u16(b, 41);
  f.temperature_cdegc = le_i16(b, 43);
  if (b.size() == kPd5Bytes) {
    Pd4Frame::Attitude a;  // byte 45 is the salinity
    a.depth_dm = le_u16(b, 46);
    a.pitch_cdeg = le_i16(b, 48), a.roll_cdeg = le_i16(b, 50), a.heading_cdeg = le_u16(b, 52);
    f.attitude = a;
  }
  return f;
}

FrameStart pd4_start(std::span<const std::uint8_t> b) {
  using Is = FrameStart::Is;
  if (b[0] != 0x7D) return {};
  if (b.size() < 2) return {Is::unsettled, 0, {}, {}};
  if (b[1] > 1) return {};
  const std::string_view kind = b[1] == 0 ? "PD4" : "PD5";
  const std::size_t whole = b[1] == 0 ? kPd4Bytes : kPd5Bytes;
  if (b.size() >= 3 && (b[2] < whole - 2 || b[2] > whole)) return {};
  if (b.size() >= 4 && b[3] != 0) return {};
  if (b.size() < whole) return {Is::unsettled, 0, kind, {}};
  if (pd0_checksum(b.first(whole - 2)) != le_u16(b, whole - 2)) return {Is::broken, whole, kind, "checksum"};
  return {Is::frame, whole, kind, {}};
}

}  // namespace leadline::decode
