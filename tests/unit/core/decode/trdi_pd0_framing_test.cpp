#include "core/decode/trdi_pd0_framing.h"

#include <gtest/gtest.h>

#include <random>

#include "tests/unit/core/decode/trdi_pd0_samples.h"

namespace leadline::test {
namespace {

Bytes head_of(const std::string& file, std::size_t ensembles) {
  const Bytes all = read_bytes(data_path(file));
  std::size_t end = 0;
  for (std::size_t i = 0; i < ensembles; ++i) end += all[end + 2] + 256u * all[end + 3] + 2;
  return {all.begin(), all.begin() + static_cast<std::ptrdiff_t>(end)};
}

/// Reports in the order of the bytes, each byte once: blocks lie inside their ensemble's span.
void expect_accounted(const Decoded& d, std::size_t bytes) {
  std::uint64_t total = 0, span_end = 0;
  for (std::size_t i = 0; i < d.frames.size(); ++i) {
    if (d.frames[i].block) continue;
    ASSERT_EQ(d.frames[i].offset, span_end);
    span_end += d.frames[i].length;
    for (std::size_t j = i + 1; j < d.frames.size() && d.frames[j].block; ++j) span_end += d.frames[j].length;
  }
  for (const auto& f : d.frames) total += f.length;
  ASSERT_EQ(total, bytes);
  ASSERT_EQ(span_end, bytes);
}

TEST(Pd0Framing, AnySplitOfThreeRealEnsemblesGivesTheSame) {
  const Bytes bytes = head_of("dvl_pd0_adcp/winriver01.PD0", 3);
  const Decoded whole = decode_pd0(bytes);
  ASSERT_EQ(account(whole).ensembles, 3u);
  for (std::size_t split = 1; split < bytes.size(); split += 97) {
    const auto decoder = decode::make_trdi_pd0({});
    Decoded parts;
    decoder->feed({bytes.data(), split}, {}, parts);
    decoder->feed({bytes.data() + split, bytes.size() - split}, {}, parts);
    decoder->finish(parts);
    ASSERT_TRUE(same(whole, parts)) << "split at " << split;
  }
  EXPECT_TRUE(same(whole, decode_pd0(bytes, 1)));
}

TEST(Pd0Framing, ASmallEnsembleMayBeSplitAnywhere) {
  const Bytes bytes = Bytes{1, 0x7F, 3} + pd0_sample() + Bytes{0x7F, 0x7F, 0x7F} + pd0_sample() + Bytes{0x7F};
  const Decoded whole = decode_pd0(bytes);
  ASSERT_EQ(account(whole).ensembles, 2u);
  for (std::size_t split = 1; split < bytes.size(); ++split) {
    const auto decoder = decode::make_trdi_pd0({});
    Decoded parts;
    decoder->feed({bytes.data(), split}, {}, parts);
    decoder->feed({bytes.data() + split, bytes.size() - split}, {}, parts);
    decoder->finish(parts);
    ASSERT_TRUE(same(whole, parts)) << "split at " << split;
  }
}

TEST(Pd0Framing, RiverProInChunksOf777BytesGivesTheSame) {
  const Bytes bytes = read_bytes(data_path("dvl_pd0_adcp/RiverPro_test01.PD0"));
  EXPECT_TRUE(same(decode_pd0(bytes), decode_pd0(bytes, 777)));
}

TEST(Pd0Framing, AnEnsembleIsTakenAtItsLastByte) {
  const Bytes bytes = pd0_sample();
  const auto decoder = decode::make_trdi_pd0({});
  Decoded out;
  decoder->feed({bytes.data(), bytes.size() - 1}, {}, out);
  EXPECT_TRUE(out.frames.empty());
  decoder->feed({bytes.data() + bytes.size() - 1, 1}, {}, out);
  EXPECT_EQ(out.frames.size(), 1u);
}

TEST(Pd0Framing, ThreeSyncBytesDoNotHideTheEnsemble) {
  const Decoded d = decode_pd0(Bytes{0x7F} + pd0_sample());
  EXPECT_EQ(account(d).ensembles, 1u);
}

TEST(Pd0Framing, GarbageBeforeAHeaderIsOneSkippedRun) {
  const Decoded d = decode_pd0(Bytes(300, 0x55) + pd0_sample());
  ASSERT_EQ(d.frames.size(), 2u);
  EXPECT_EQ(d.frames[0].byte_class, ByteClass::skipped);
  EXPECT_EQ(d.frames[0].length, 300u);
  EXPECT_EQ(d.frames[1].byte_class, ByteClass::decoded);
}

TEST(Pd0Framing, ALongRunIsToldEvery64KiB) {
  const Decoded d = decode_pd0(Bytes(150'000, 0x55), 1000);
  ASSERT_EQ(d.frames.size(), 3u);
  EXPECT_EQ(d.frames[0].length, 65536u);
  EXPECT_EQ(d.frames[2].length, 150'000u - 2 * 65536u);
}

TEST(Pd0Framing, ABrokenEnsembleIsOneRefusalUpToTheNextGoodOne) {
  Bytes broken = pd0_sample();
  broken[100] ^= 0x10;
  const Decoded d = decode_pd0(pd0_sample() + broken + Bytes{9, 9, 9} + pd0_sample());
  ASSERT_EQ(d.frames.size(), 3u);
  EXPECT_EQ(d.frames[1].byte_class, ByteClass::refused);
  EXPECT_EQ(d.frames[1].reason, "checksum");
  EXPECT_EQ(d.frames[1].checksum, ChecksumState::bad);
  EXPECT_EQ(d.frames[1].offset, 223u);
  EXPECT_EQ(d.frames[1].length, 226u);
}

TEST(Pd0Framing, TwoBrokenEnsemblesAreTwoRefusals) {
  Bytes broken = pd0_sample();
  broken[100] ^= 0x10;
  const Decoded d = decode_pd0(broken + broken + pd0_sample());
  ASSERT_EQ(d.frames.size(), 3u);
  EXPECT_EQ(d.frames[0].length, 223u);
  EXPECT_EQ(d.frames[1].length, 223u);
}

TEST(Pd0Framing, AnEnsembleCutByTheEndIsOneTruncation) {
  const Bytes sample = pd0_sample();
  for (std::size_t cut = 2; cut < sample.size(); ++cut) {
    const Decoded d =
        decode_pd0(sample + Bytes(sample.begin(), sample.begin() + static_cast<std::ptrdiff_t>(cut)));
    ASSERT_EQ(d.frames.size(), 2u) << cut;
    EXPECT_EQ(d.frames[1].reason, "truncated");
    EXPECT_EQ(d.frames[1].length, cut);
  }
}

TEST(Pd0Framing, ASizeThatPromisesTooMuchDoesNotDelayTheNextEnsemble) {
  Bytes broken = pd0_sample();
  broken[3] = 0x3E;  // announces 16 093 bytes
  const Bytes bytes = broken + pd0_sample();
  const auto decoder = decode::make_trdi_pd0({});
  Decoded out;
  decoder->feed(bytes, {}, out);
  ASSERT_EQ(out.frames.size(), 2u) << "without waiting for 16 KiB";
  EXPECT_EQ(out.frames[0].reason, "checksum");
  EXPECT_EQ(out.frames[0].length, 223u);
  EXPECT_EQ(out.frames[1].byte_class, ByteClass::decoded);
}

TEST(Pd0Framing, ImpossibleSizesAreRefused) {
  for (const int size : {0, 11, 0x4001, 0xFFFF}) {  // below 6 + 2 x 3, above the ceiling
    Bytes broken = pd0_sample();
    put_u16(broken, 2, size);
    const Decoded d = decode_pd0(broken + pd0_sample());
    ASSERT_EQ(d.frames.size(), 2u) << size;
    EXPECT_EQ(d.frames[0].reason, "size");
    EXPECT_EQ(d.frames[0].length, 223u);
  }
}

TEST(Pd0Framing, ABrokenLayoutUnderAGoodChecksumIsRefused) {
  Bytes decreasing = pd0_sample();
  put_u16(decreasing, 8, 0x0088), put_u16(decreasing, 10, 0x0047);
  Bytes outside = pd0_sample();
  put_u16(outside, 10, 221);
  Bytes into_table = pd0_sample();
  put_u16(into_table, 6, 11);
  auto types = types_of(pd0_sample());
  const Bytes no_fixed = compose({types[1], types[2]}), no_variable = compose({types[0], types[2]});
  const Bytes short_bottom = compose({types[0], types[1], Bytes(types[2].begin(), types[2].begin() + 80)});
  for (const Bytes& bad :
       {sealed(decreasing), sealed(outside), sealed(into_table), no_fixed, no_variable, short_bottom}) {
    const Decoded d = decode_pd0(bad + pd0_sample());
    ASSERT_EQ(d.frames.size(), 2u);
    EXPECT_EQ(d.frames[0].reason, "layout");
    EXPECT_EQ(d.frames[0].length, bad.size());
    EXPECT_EQ(account(d).ensembles, 1u);
  }
}

TEST(Pd0Framing, WavesPacketsAreKnownAndUnused) {
  const Bytes bytes = read_bytes(data_path("dvl_pd0_adcp/RDI_7f79.000"));
  const Decoded d = decode_pd0(bytes, 100);
  expect_accounted(d, 50000);
  EXPECT_EQ(account(d).ensembles, 60u);
  EXPECT_EQ(account(d).waves, 122u);
  std::uint64_t waves_bytes = 0;
  for (const auto& f : d.frames) waves_bytes += f.kind == "waves" ? f.length : 0;
  EXPECT_EQ(waves_bytes, 122u * 80u + 8u);
}

TEST(Pd0Framing, EveryFlippedBitIsCaughtAndTheNextEnsembleRead) {
  const Bytes good = pd0_sample();
  const Decoded alone = decode_pd0(good);
  for (std::size_t bit = 0; bit < 8 * good.size(); ++bit) {
    Bytes broken = good;
    broken[bit / 8] = static_cast<std::uint8_t>(broken[bit / 8] ^ 1u << bit % 8);
    const Decoded d = decode_pd0(broken + good);
    ASSERT_EQ(account(d).ensembles, 1u) << "bit " << bit;
    ASSERT_EQ(d.facts, alone.facts) << "bit " << bit;
    expect_accounted(d, 2 * good.size());
    ASSERT_LE(d.frames.size(), 3u) << "bit " << bit;
    ASSERT_EQ(d.frames.back().offset, good.size());
  }
}

TEST(Pd0Framing, EveryPrefixIsAccountedFor) {
  const Bytes bytes = head_of("dvl_pd0_adcp/RiverPro_test01.PD0", 2);
  for (std::size_t n = 0; n <= bytes.size(); n += 3)
    expect_accounted(decode_pd0(Bytes(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(n))), n);
}

TEST(Pd0Framing, DamagedStreamsAreAccountedForHoweverTheyAreCut) {
  std::mt19937 random(20261122);
  const Bytes sources[] = {head_of("dvl_pd0_adcp/RiverPro_test01.PD0", 8),
                           head_of("dvl_pd0_remus600/adcp_auv_51.pd0", 20)};
  for (int round = 0; round < 40; ++round) {
    Bytes bytes = sources[round % 2];
    // 2 % of the bytes in the even rounds, one in 500 later: enough to break some ensembles and leave others.
    const std::size_t edits = bytes.size() / (round % 4 < 2 ? 50 : 500);
    for (std::size_t i = 0; i < edits; ++i) {
      const std::size_t at = random() % bytes.size();
      switch (random() % 4) {
        case 0:
          bytes.erase(bytes.begin() + static_cast<std::ptrdiff_t>(at));
          break;
        case 1:
          bytes.insert(bytes.begin() + static_cast<std::ptrdiff_t>(at), 0x7F);
          break;
        default:
          bytes[at] = static_cast<std::uint8_t>(random());
      }
    }
    const Decoded whole = decode_pd0(bytes);
    expect_accounted(whole, bytes.size());
    ASSERT_TRUE(same(whole, decode_pd0(bytes, 1 + random() % 300))) << "round " << round;
  }
}

TEST(Pd0Framing, AStreamOfHeadersIsAccountedForHoweverItIsCut) {
  std::mt19937 random(7);
  for (int round = 0; round < 30; ++round) {
    Bytes bytes;
    while (bytes.size() < 3000) {
      if (random() % 3 == 0)
        bytes = std::move(bytes) + Bytes{0x7F, 0x7F, static_cast<std::uint8_t>(random() % 64), 0, 0, 1};
      if (random() % 8 == 0) bytes = std::move(bytes) + Bytes{0x7F, 0x79, 8, 0, 0, 1, 8, 0, 0x07, 0x01};
      bytes.push_back(random() % 2 ? 0x7F : 0x00);
      if (random() % 100 == 0) bytes = std::move(bytes) + pd0_sample();
    }
    const Decoded whole = decode_pd0(bytes);
    expect_accounted(whole, bytes.size());
    ASSERT_TRUE(same(whole, decode_pd0(bytes, 1))) << "round " << round;
    ASSERT_TRUE(same(whole, decode_pd0(bytes, 1 + random() % 50))) << "round " << round;
  }
}

}  // namespace
}  // namespace leadline::test
