#include "core/sim/telegrams/pni_writer.h"

#include "core/decode/pni_tcm.h"
#include "core/sim/telegrams/binary_writer.h"

namespace leadline::sim {

void write_pni(const CompassMeasurement& m, Telegrams& out) {
  constexpr std::uint8_t kData = 5, kHeading = 5, kDistortion = 8;
  BinaryWriter w(out, BinaryWriter::Order::big);
  w.u16(0), w.u8(kData), w.u8(2);
  w.u8(kHeading), w.f32(m.heading.wrapped_2pi().deg());
  w.u8(kDistortion), w.u8(0);
  w.patch_u16(0, static_cast<std::uint16_t>(w.written().size() + 2));
  w.u16(decode::crc16_xmodem(w.written()));
  out.end();
}

}  // namespace leadline::sim
