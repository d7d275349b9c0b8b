#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "core/decode/trdi_pd0.h"
#include "core/decode/trdi_pd0_ensemble.h"
#include "core/decode/trdi_pd0_framing.h"
#include "tests/support/decoder_harness.h"
#include "tests/support/files.h"

namespace leadline::test {

using Bytes = std::vector<std::uint8_t>;

// Where the fields of pd0_ship_bt.bin are that tests change.
inline constexpr std::size_t kSysConfig = 12 + 4, kCoordinates = 12 + 25, kSensorSource = 12 + 30,
                             kBeamAngle = 12 + 58;
inline constexpr std::size_t kVariable = 71, kBottom = 136, kVelocity = kBottom + 24,
                             kRangeHigh = kBottom + 77;
inline constexpr std::size_t kLayerFar = kBottom + 48, kLayerVelocity = kBottom + 50;

inline Bytes pd0_sample(const std::string& name = "pd0_ship_bt.bin") {
  return read_bytes(data_path("wire-samples/" + name));
}

inline void put_u16(Bytes& bytes, std::size_t at, int value) {
  bytes[at] = static_cast<std::uint8_t>(value), bytes[at + 1] = static_cast<std::uint8_t>(value >> 8);
}
inline void append_u16(Bytes& bytes, int value) {
  bytes.resize(bytes.size() + 2);
  put_u16(bytes, bytes.size() - 2, value);
}
inline Bytes operator+(Bytes a, const Bytes& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

/// Puts the checksum of an edited ensemble right again.
inline Bytes sealed(Bytes ensemble) {
  const std::size_t size = ensemble.size() - 2;
  put_u16(ensemble, size, decode::pd0_checksum({ensemble.data(), size}));
  return ensemble;
}

inline std::vector<Bytes> types_of(const Bytes& ensemble) {
  const auto e = decode::read_pd0_ensemble({ensemble.data(), ensemble.size() - 2});
  std::vector<Bytes> types;
  for (std::size_t i = 0; i < e.value().types(); ++i) {
    const auto t = e->type(i);
    types.emplace_back(t.begin(), t.end());
  }
  return types;
}

inline Bytes compose(const std::vector<Bytes>& types) {
  Bytes ensemble = {0x7F, 0x7F, 0, 0, 0, static_cast<std::uint8_t>(types.size())};
  std::size_t offset = 6 + 2 * types.size();
  for (const Bytes& t : types) append_u16(ensemble, static_cast<int>(offset)), offset += t.size();
  for (const Bytes& t : types) ensemble = std::move(ensemble) + t;
  put_u16(ensemble, 2, static_cast<int>(offset));
  append_u16(ensemble, 0);
  return sealed(std::move(ensemble));
}

inline Decoded decode_pd0(const Bytes& bytes, std::size_t chunk = 0, const DecoderSettings& settings = {}) {
  return decode_all(*decode::make_trdi_pd0(settings), bytes, {}, chunk);
}

struct PieceCount {
  std::uint64_t bytes = 0;
  std::size_t ensembles = 0, waves = 0, refused = 0, skipped = 0;
};
/// Counts the frames (blocks apart) and checks that the pieces follow one another without a gap.
inline PieceCount account(const Decoded& d) {
  PieceCount count;
  for (const FrameReport& f : d.frames) {
    count.bytes += f.length;
    if (f.block) continue;
    count.ensembles += f.byte_class == ByteClass::decoded;
    count.waves += f.kind == "waves" && f.byte_class == ByteClass::unused;
    count.refused += f.byte_class == ByteClass::refused;
    count.skipped += f.byte_class == ByteClass::skipped;
  }
  return count;
}

}  // namespace leadline::test
