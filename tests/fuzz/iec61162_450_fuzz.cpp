#include "core/decode/iec61162_450.h"
#include "tests/fuzz/decoder_law.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  leadline::decode::ProfileOptions profile;
  if (size > 0 && data[size - 1] % 2 == 1) profile.udpbc_header = "optional";
  leadline::test::expect_decoder_law({data, size},
                                     [&] { return leadline::decode::make_iec61162_450({}, profile); });
  return 0;
}
