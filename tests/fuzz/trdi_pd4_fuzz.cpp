// Any bytes, at once and in two chunks: the same facts and reports, and every byte reported once.

#include <cstddef>
#include <cstdint>

#include "core/decode/trdi_pd4.h"
#include "core/types/expect.h"
#include "tests/support/decoder_harness.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace leadline;
  constexpr Arrival kArrival{1'795'350'919'600'000'000};
  const std::span<const std::uint8_t> bytes(data, size);
  const test::Decoded whole = test::decode_all(*decode::make_trdi_pd4({}), bytes, kArrival);
  const std::size_t split = size == 0 ? 0 : (data[0] * 257u + data[size - 1]) % size;
  const auto decoder = decode::make_trdi_pd4({});
  test::Decoded parts;
  decoder->feed(bytes.first(split), kArrival, parts);
  decoder->feed(bytes.subspan(split), kArrival, parts);
  decoder->finish(parts);
  LL_EXPECT(test::same(whole, parts));
  std::uint64_t reported = 0;
  for (const FrameReport& f : whole.frames) {
    LL_EXPECT(f.offset == reported && f.length > 0);
    reported += f.length;
  }
  LL_EXPECT(reported == size);
  return 0;
}
