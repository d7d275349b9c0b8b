#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>

#include "core/types/expect.h"
#include "tests/support/decoder_harness.h"

namespace leadline::test {

/// The law of every decoder, on any bytes: fed at once and in two chunks it says the same facts and reports,
/// and the reports cover every byte once, in order.
inline void expect_decoder_law(std::span<const std::uint8_t> bytes, const DecoderMaker& make) {
  constexpr Arrival kArrival{1'795'350'919'600'000'000};
  const auto undivided = make();  // the kinds in its reports live as long as it does
  const Decoded whole = decode_all(*undivided, bytes, kArrival);
  const std::size_t split = bytes.empty() ? 0 : (bytes.front() * 257U + bytes.back()) % bytes.size();
  const auto decoder = make();
  Decoded parts;
  decoder->feed(bytes.first(split), kArrival, parts);
  decoder->feed(bytes.subspan(split), kArrival, parts);
  decoder->finish(parts);
  LL_EXPECT(same(whole, parts));
  // A telegram's blocks that are reported apart lie inside it: then only the sum is told.
  const bool blocks =
      std::any_of(whole.frames.begin(), whole.frames.end(), [](const auto& f) { return f.block; });
  std::uint64_t reported = 0;
  for (const FrameReport& f : whole.frames) {
    LL_EXPECT(blocks || (f.offset == reported && f.length > 0));
    reported += f.length;
  }
  LL_EXPECT(reported == bytes.size());
}

}  // namespace leadline::test
