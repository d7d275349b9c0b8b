#include "core/decode/mavlink.h"
#include "tests/fuzz/decoder_law.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  leadline::test::expect_decoder_law({data, size}, [] { return leadline::decode::make_mavlink({}); });
  return 0;
}
