// Any bytes, at once and in two chunks: the same facts and reports, and every byte reported once.

#include <cstddef>
#include <cstdint>

#include "core/decode/trdi_pd0.h"
#include "core/types/expect.h"
#include "tests/support/decoder_harness.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace leadline;
  const std::span<const std::uint8_t> bytes(data, size);
  const test::Decoded whole = test::decode_all(*decode::make_trdi_pd0({}), bytes);
  const std::size_t split = size == 0 ? 0 : (data[0] * 257u + data[size - 1]) % size;
  const auto decoder = decode::make_trdi_pd0({});
  test::Decoded parts;
  decoder->feed(bytes.first(split), {}, parts);
  decoder->feed(bytes.subspan(split), {}, parts);
  decoder->finish(parts);
  LL_EXPECT(test::same(whole, parts));
  std::uint64_t reported = 0;
  for (const FrameReport& f : whole.frames) reported += f.length;
  LL_EXPECT(reported == size);
  return 0;
}
