#include "core/decode/pni_tcm.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>

#include "tests/support/files.h"
#include "tests/unit/core/decode/decoder_laws.h"

namespace leadline::test {
namespace {

constexpr Arrival kArrival{1'795'350'919'600'000'000};

Bytes sample() { return read_bytes(data_path("wire-samples/pni_data.bin")); }
std::unique_ptr<Decoder> make() { return decode::make_pni_tcm({}); }
Decoded decode_pni(const Bytes& b) { return decode_all(*make(), b, kArrival); }

Bytes frame(std::uint8_t id, const Bytes& payload) {
  Bytes b{0, static_cast<std::uint8_t>(payload.size() + 5), id};
  b.insert(b.end(), payload.begin(), payload.end());
  const std::uint16_t crc = decode::crc16_xmodem(b);
  b.push_back(static_cast<std::uint8_t>(crc >> 8)), b.push_back(static_cast<std::uint8_t>(crc));
  return b;
}
void append_f32(Bytes& b, float value, bool little = false) {
  const auto word = std::bit_cast<std::uint32_t>(value);
  for (int i = 0; i < 4; ++i) b.push_back(static_cast<std::uint8_t>(word >> 8 * (little ? i : 3 - i)));
}
Bytes heading(float deg) {
  Bytes b{1, 5};
  append_f32(b, deg);
  return frame(5, b);
}

TEST(PniTcm, TheChecksumIsXmodems) { EXPECT_EQ(decode::crc16_xmodem(as_bytes("123456789")), 0x31C3); }

TEST(PniTcm, TheSampleGivesItsDocumentedValues) {
  const Decoded d = decode_pni(sample());
  ASSERT_EQ(d.frames.size(), 1u);
  EXPECT_EQ(d.frames[0].kind, "kGetDataResp");
  EXPECT_EQ(d.frames[0].checksum, ChecksumState::ok);
  EXPECT_NEAR(d.all<Heading>().at(0).heading.deg(), 96.03, 1e-5);
  EXPECT_EQ(d.all<Heading>()[0].reference, HeadingReference::magnetic_north);
  EXPECT_NEAR(d.all<Attitude>().at(0).pitch.deg(), -2.30, 1e-6);
  EXPECT_NEAR(d.all<Attitude>()[0].roll.deg(), 1.40, 1e-6);
  EXPECT_TRUE(d.all<Health>().empty()) << "not distorted";
  for (const auto& fact : d.facts) EXPECT_FALSE(fact.device_time) << "the device has no clock";
}

TEST(PniTcm, PublishedCommandsAreKnownAndNotUsed) {
  const struct {
    Bytes bytes;
    const char* kind;
  } cases[] = {{{0x00, 0x05, 0x01, 0xef, 0xd4}, "kGetModInfo"},
               {{0x00, 0x05, 0x04, 0xbf, 0x71}, "kGetData"},
               {{0x00, 0x0a, 0x03, 0x04, 0x05, 0x18, 0x19, 0x08, 0xda, 0xcc}, "kSetDataComponents"}};
  for (const auto& c : cases) {
    const Decoded d = decode_pni(c.bytes);
    ASSERT_EQ(d.frames.size(), 1u) << c.kind;
    EXPECT_EQ(d.frames[0].byte_class, ByteClass::unused) << c.kind;
    EXPECT_EQ(d.frames[0].kind, c.kind);
  }
  EXPECT_EQ(decode_pni(frame(99, {1, 2})).frames.at(0).byte_class, ByteClass::unknown);
}

TEST(PniTcm, TheProfileTellsTheByteOrder) {
  decode::ProfileOptions little;
  little.pni_byte_order = "little";
  Bytes payload{1, 5};
  append_f32(payload, 96.03F, true);
  const Decoded d = decode_all(*decode::make_pni_tcm({}, little), frame(5, payload), kArrival);
  EXPECT_NEAR(d.all<Heading>().at(0).heading.deg(), 96.03, 1e-5);
  EXPECT_TRUE(decode_pni(frame(5, payload)).all<Heading>().empty()) << "big-endian it is out of range";
}

TEST(PniTcm, AnUnknownComponentHidesWhatFollows) {
  Bytes payload{3, 5};
  append_f32(payload, 10.0F);
  payload.push_back(200);
  append_f32(payload, 1.0F);
  payload.push_back(24);
  append_f32(payload, 1.0F);
  const Decoded d = decode_pni(frame(5, payload));
  EXPECT_EQ(d.all<Heading>().size(), 1u);
  EXPECT_TRUE(d.all<Attitude>().empty());
}

TEST(PniTcm, WhatIsNoSampleIsRefused) {
  for (const float bad : {NAN, INFINITY, -0.5F, 360.5F}) {
    const Decoded d = decode_pni(heading(bad));
    EXPECT_TRUE(d.facts.empty()) << bad;
    EXPECT_EQ(d.frames.at(0).reason, "range") << bad;
  }
  Bytes cut{2, 5};
  append_f32(cut, 10.0F);
  cut.push_back(24), cut.push_back(0);
  EXPECT_EQ(decode_pni(frame(5, cut)).frames.at(0).reason, "fields");
  EXPECT_EQ(decode_pni(heading(360.0F)).all<Heading>().at(0).heading.rad(), 0.0);
}

TEST(PniTcm, ADistortedFieldIsToldOnceAndAgainWhenItReturns) {
  Bytes all;
  for (const int distorted : {1, 1, 0, 1}) {
    Bytes payload{2, 5};
    append_f32(payload, 10.0F);
    payload.push_back(8), payload.push_back(static_cast<std::uint8_t>(distorted));
    const Bytes f = frame(5, payload);
    all.insert(all.end(), f.begin(), f.end());
  }
  const Decoded d = decode_pni(all);
  EXPECT_EQ(d.all<Health>().size(), 2u);
  EXPECT_EQ(d.all<Heading>().size(), 4u);
}

TEST(PniTcm, ASilenceEndsWhatWasPending) {
  const Bytes torn{0x01, 0xFF, 0x09, 0x00}, good = sample();  // announces 511 bytes
  for (const int silence_ms : {99, 100}) {
    const auto decoder = make();
    Decoded d;
    decoder->feed(torn, kArrival, d);
    decoder->feed(good, kArrival + std::chrono::milliseconds(silence_ms), d);
    EXPECT_EQ(d.all<Heading>().size(), silence_ms == 100 ? 1u : 0u) << silence_ms;
    decoder->finish(d);
    EXPECT_EQ(d.all<Heading>().size(), 1u);
    EXPECT_TRUE(covers(d, torn.size() + good.size()));
    EXPECT_EQ(d.frames.at(0).reason, "truncated");
  }
}

TEST(PniTcmLaws, Hold) {
  Bytes three = sample();
  for (const Bytes& more : {frame(4, {}), heading(12.0F)})
    three.insert(three.end(), more.begin(), more.end());
  expect_any_split_alike(make, three, kArrival);
  expect_prefixes_accounted(make, three, kArrival);
  expect_byte_changes_harmless(make, sample(), kArrival, true);
}

}  // namespace
}  // namespace leadline::test
