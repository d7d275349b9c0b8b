#pragma once

// What holds for every decoder, whatever its format.

#include <gtest/gtest.h>

#include <random>
#include <vector>

#include "tests/support/decoder_harness.h"

namespace leadline::test {

using Bytes = std::vector<std::uint8_t>;

inline bool covers(const Decoded& d, std::size_t size) {
  std::uint64_t covered = 0;
  for (const FrameReport& f : d.frames) {
    if (f.offset != covered || f.length == 0) return false;
    covered += f.length;
  }
  return covered == size;
}

inline Decoded decode_in_two(Decoder& decoder, std::span<const std::uint8_t> bytes, std::size_t cut,
                             std::optional<Arrival> arrival) {
  Decoded out;
  decoder.feed(bytes.first(cut), arrival, out);
  decoder.feed(bytes.subspan(cut), arrival, out);
  decoder.finish(out);
  return out;
}

/// Cut anywhere, or byte by byte: the same facts and reports.
inline void expect_any_split_alike(const DecoderMaker& make, const Bytes& bytes, Arrival arrival) {
  const Decoded whole = decode_all(*make(), bytes, arrival);
  EXPECT_TRUE(covers(whole, bytes.size()));
  EXPECT_TRUE(same(whole, decode_all(*make(), bytes, arrival, 1)));
  for (std::size_t cut = 0; cut <= bytes.size(); ++cut)
    ASSERT_TRUE(same(whole, decode_in_two(*make(), bytes, cut, arrival))) << "cut at " << cut;
}

/// Every prefix is accounted for, and makes no fact that the whole does not.
inline void expect_prefixes_accounted(const DecoderMaker& make, const Bytes& bytes, Arrival arrival) {
  const Decoded whole = decode_all(*make(), bytes, arrival);
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    const Decoded d = decode_all(*make(), std::span(bytes).first(size), arrival);
    ASSERT_TRUE(covers(d, size)) << size;
    ASSERT_LE(d.facts.size(), whole.facts.size()) << size;
    ASSERT_TRUE(std::equal(d.facts.begin(), d.facts.end(), whole.facts.begin())) << size;
  }
}

/// A telegram with any one byte changed, and two good ones behind it: every byte is accounted for, and the
/// last is decoded like a telegram alone. refused: none of the changed ones makes a measurement.
inline void expect_byte_changes_harmless(const DecoderMaker& make, const Bytes& telegram, Arrival arrival,
                                         bool refused) {
  const auto decoded_at = [](const Decoded& d, std::uint64_t end) {
    for (const FrameReport& f : d.frames)
      if (f.byte_class == ByteClass::decoded && f.offset + f.length == end) return true;
    return false;
  };
  Bytes bytes;
  for (int i = 0; i < 3; ++i) bytes.insert(bytes.end(), telegram.begin(), telegram.end());
  const auto measured = [](const Decoded& d) {
    return d.facts.size() - d.all<ClockReading>().size() - d.all<Health>().size();
  };
  const std::size_t two_good = 2 * measured(decode_all(*make(), telegram, arrival));
  for (std::size_t at = 0; at < telegram.size(); ++at) {
    const std::uint8_t was = bytes[at];
    for (int change = 1; change < 256; ++change) {
      bytes[at] = static_cast<std::uint8_t>(was ^ change);
      const Decoded d = decode_all(*make(), bytes, arrival);
      ASSERT_TRUE(covers(d, bytes.size())) << at << " ^ " << change;
      ASSERT_TRUE(decoded_at(d, bytes.size())) << at << " ^ " << change;
      if (refused) {
        ASSERT_LE(measured(d), two_good) << at << " ^ " << change;
      }
    }
    bytes[at] = was;
  }
}

/// Telegrams among random bytes, some like the telegram's own: none is lost, nor any byte.
inline void expect_found_in_rubbish(const DecoderMaker& make, const Bytes& telegram, Arrival arrival,
                                    unsigned seed, int rounds = 30) {
  std::mt19937 random(seed);
  for (int round = 0; round < rounds; ++round) {
    Bytes bytes;
    std::size_t sent = 0, found = 0;
    while (bytes.size() < 20'000) {
      Bytes rubbish(random() % 300);
      for (auto& b : rubbish)
        b = random() % 4 == 0 ? telegram[random() % telegram.size()] : static_cast<std::uint8_t>(random());
      bytes.insert(bytes.end(), rubbish.begin(), rubbish.end());
      bytes.insert(bytes.end(), telegram.begin(), telegram.end());
      ++sent;
    }
    const Decoded d = decode_all(*make(), bytes, arrival);
    for (const FrameReport& f : d.frames) found += f.byte_class == ByteClass::decoded;
    ASSERT_TRUE(covers(d, bytes.size())) << round;
    ASSERT_EQ(found, sent) << round;
    ASSERT_TRUE(same(d, decode_all(*make(), bytes, arrival, 1 + random() % 5000))) << round;
  }
}

}  // namespace leadline::test
