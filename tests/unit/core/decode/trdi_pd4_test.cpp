#include "core/decode/trdi_pd4.h"

#include <gtest/gtest.h>

#include <random>

#include "tests/unit/core/decode/trdi_pd0_samples.h"

namespace leadline::test {
namespace {

constexpr double kTiny = 1e-9;
constexpr Arrival kArrival{1'795'350'919'600'000'000};  // 2026-11-22T12:35:19.6Z
constexpr std::size_t kConfiguration = 4, kBottom4 = 5, kRange4 = 13, kStatus4 = 21, kWater4 = 22,
                      kLayerEnd4 = 32, kClock4 = 35, kTest4 = 39;

Bytes pd4() { return read_bytes(data_path("wire-samples/pd4.bin")); }

/// The PD4 sample as PD5, with depth 118.4 m, pitch -2.30, roll 1.40, heading 96.03.
Bytes pd5() {
  Bytes b = pd4();
  b.resize(45);
  b[1] = 1, b[2] = 86;
  b.push_back(35);
  append_u16(b, 1184), append_u16(b, -230), append_u16(b, 140), append_u16(b, 9603);
  b.resize(88);
  return sealed(b);
}

Decoded decode_pd4(const Bytes& bytes, std::size_t chunk = 0, std::optional<Arrival> arrival = kArrival) {
  return decode_all(*decode::make_trdi_pd4({}), bytes, arrival, chunk);
}

bool covers(const Decoded& d, std::size_t size) {
  std::uint64_t covered = 0;
  for (const FrameReport& f : d.frames) {
    if (f.offset != covered || f.length == 0) return false;
    covered += f.length;
  }
  return covered == size;
}

TEST(Pd4, TheSampleGivesTheVehiclesVelocity) {
  const Decoded d = decode_pd4(pd4());
  const Time time = *parse_iso8601("2026-11-22T12:35:19.500Z");
  for (const auto& fact : d.facts) EXPECT_EQ(fact.device_time, time);
  const auto all = d.all<DvlVelocity>();
  ASSERT_EQ(all.size(), 1u);
  EXPECT_TRUE(all[0].valid);
  EXPECT_EQ(all[0].frame, DvlFrame::ship);
  EXPECT_TRUE(all[0].tilt_applied);
  EXPECT_NEAR(all[0].x_mps, 0.850, kTiny);
  EXPECT_NEAR(all[0].y_mps, 0.120, kTiny);
  EXPECT_NEAR(all[0].z_mps, 0.030, kTiny);
  EXPECT_NEAR(*all[0].error_mps, 0.004, kTiny);
  EXPECT_NEAR(d.all<BeamRanges>()[0].range_m[2], 10.95, kTiny);
  EXPECT_NEAR(d.all<AltitudeAboveBottom>()[0].above_bottom_m, 11.025, kTiny);
  EXPECT_EQ(d.all<SoundSpeed>()[0].speed_mps, 1490.0);
  EXPECT_EQ(d.all<ClockReading>()[0].device_ns, time.ns);
  ASSERT_EQ(d.frames.size(), 1u);
  EXPECT_EQ(d.frames[0].kind, "PD4");
  EXPECT_EQ(d.frames[0].checksum, ChecksumState::ok);
  EXPECT_EQ(d.frames[0].length, 47u);
}

TEST(Pd4, TheConfigurationByteNamesTheFrame) {
  const struct {
    std::uint8_t configuration;
    DvlFrame frame;
    bool level, velocity;
  } cases[] = {{0x63, DvlFrame::instrument, false, true},
               {0x83, DvlFrame::ship, false, true},
               {0xA3, DvlFrame::ship, true, true},
               {0xE3, DvlFrame::earth, true, true},
               {0x23, DvlFrame::instrument, false, false}};
  for (const auto& c : cases) {
    Bytes b = pd4();
    b[kConfiguration] = c.configuration;
    const Decoded d = decode_pd4(sealed(b) + sealed(b));
    const auto all = d.all<DvlVelocity>();
    ASSERT_EQ(all.size(), c.velocity ? 2u : 0u);
    EXPECT_EQ(d.all<Health>().size(), c.velocity ? 0u : 1u) << "beam coordinates are told once";
    if (!c.velocity) continue;
    EXPECT_EQ(all[0].frame, c.frame);
    EXPECT_EQ(all[0].tilt_applied, c.level);
    EXPECT_NEAR(all[0].x_mps, 0.850, kTiny);
    EXPECT_NEAR(all[0].y_mps, 0.120, kTiny);
  }
}

TEST(Pd4, WithoutLockTheVelocityIsNotValid) {
  Bytes missing = pd4();
  put_u16(missing, kBottom4 + 4, -32768);
  Bytes two_beams = pd4();
  two_beams[kStatus4] = 0x81;  // beam 4 low echo, beam 1 low correlation
  Bytes three_beams = pd4();
  three_beams[kStatus4] = 0xC0;
  put_u16(three_beams, kBottom4 + 6, -32768);
  EXPECT_FALSE(decode_pd4(sealed(missing)).all<DvlVelocity>()[0].valid);
  EXPECT_FALSE(decode_pd4(sealed(two_beams)).all<DvlVelocity>()[0].valid);
  EXPECT_EQ(decode_pd4(sealed(two_beams)).all<DvlVelocity>()[0].x_mps, 0.0);
  const auto three = decode_pd4(sealed(three_beams)).all<DvlVelocity>()[0];
  EXPECT_TRUE(three.valid);
  EXPECT_FALSE(three.error_mps);
  Bytes no_range = pd4();
  for (std::size_t i = 0; i < 4; ++i) put_u16(no_range, kRange4 + 2 * i, 0);
  EXPECT_EQ(decode_pd4(sealed(no_range)).all<AltitudeAboveBottom>().size(), 0u);
}

TEST(Pd4, WaterVelocityNeedsALayer) {
  Bytes b = pd4();
  put_u16(b, kWater4, 100), put_u16(b, kWater4 + 2, 800), put_u16(b, kWater4 + 4, -10);
  EXPECT_EQ(decode_pd4(sealed(b)).all<DvlVelocity>().size(), 1u);
  put_u16(b, kLayerEnd4, 150);
  const auto all = decode_pd4(sealed(b)).all<DvlVelocity>();
  ASSERT_EQ(all.size(), 2u);
  EXPECT_EQ(all[1].reference, DvlReference::water);
  EXPECT_NEAR(all[1].x_mps, 0.8, kTiny);
}

TEST(Pd4, ItsTimeOfDayIsDatedByTheHost) {
  const Arrival just_after_midnight{parse_iso8601("2026-11-23T00:00:00.2Z")->ns};
  Bytes b = pd4();
  b[kClock4] = 23, b[kClock4 + 1] = 59, b[kClock4 + 2] = 59, b[kClock4 + 3] = 90;
  const Decoded d = decode_pd4(sealed(b), 0, just_after_midnight);
  EXPECT_EQ(d.facts[0].device_time, parse_iso8601("2026-11-22T23:59:59.9Z"));
  for (std::size_t i = 0; i < 4; ++i) b[kClock4 + i] = 0;
  EXPECT_FALSE(decode_pd4(sealed(b)).facts[0].device_time) << "zero is no clock";
  b[kClock4] = 24;
  EXPECT_FALSE(decode_pd4(sealed(b)).facts[0].device_time);
  EXPECT_FALSE(decode_pd4(pd4(), 0, {}).facts[0].device_time) << "nobody knows the day";
}

TEST(Pd4, ABuiltInTestThatFailsIsToldOnce) {
  Bytes b = pd4();
  b[kTest4] = 8;
  EXPECT_EQ(decode_pd4(sealed(b) + sealed(b)).all<Health>().size(), 1u);
}

TEST(Pd5, AddsDepthAndAttitude) {
  const Decoded d = decode_pd4(pd5());
  ASSERT_EQ(d.frames.size(), 1u);
  EXPECT_EQ(d.frames[0].kind, "PD5");
  EXPECT_NEAR(d.all<DepthMeasured>()[0].depth.m, 118.4, kTiny);
  EXPECT_NEAR(d.all<Heading>()[0].heading.deg(), 96.03, kTiny);
  EXPECT_NEAR(d.all<Attitude>()[0].pitch.deg(), -2.30, kTiny);
  EXPECT_NEAR(d.all<Attitude>()[0].roll.deg(), 1.40, kTiny);
  EXPECT_NEAR(d.all<DvlVelocity>()[0].x_mps, 0.850, kTiny);
}

TEST(Pd4Framing, TheSizeFieldMayCountTheChecksum) {
  for (int size = 44; size <= 48; ++size) {
    Bytes b = pd4();
    b[2] = static_cast<std::uint8_t>(size);
    EXPECT_EQ(decode_pd4(sealed(b)).all<DvlVelocity>().size(), size >= 45 && size <= 47 ? 1u : 0u) << size;
  }
}

TEST(Pd4Framing, DamageCostsOnlyItself) {
  Bytes broken = pd4();
  broken[10] ^= 1;
  Bytes torn = pd4();
  torn.resize(20);
  const Bytes bytes = Bytes{1, 2, 0x7D} + broken + pd4() + torn + pd5() + torn;
  const Decoded d = decode_pd4(bytes);
  EXPECT_TRUE(covers(d, bytes.size()));
  ASSERT_EQ(d.frames.size(), 6u);
  EXPECT_EQ(d.frames[0].byte_class, ByteClass::skipped);
  EXPECT_EQ(d.frames[1].reason, "checksum");
  EXPECT_EQ(d.frames[1].checksum, ChecksumState::bad);
  EXPECT_EQ(d.frames[1].length, 47u);
  EXPECT_EQ(d.frames[2].byte_class, ByteClass::decoded);
  EXPECT_EQ(d.frames[3].reason, "checksum");
  EXPECT_EQ(d.frames[3].length, 20u);
  EXPECT_EQ(d.frames[4].kind, "PD5");
  EXPECT_EQ(d.frames[5].reason, "truncated");
  for (std::size_t cut = 1; cut < bytes.size(); ++cut) {
    const auto decoder = decode::make_trdi_pd4({});
    Decoded parts;
    const std::span<const std::uint8_t> all(bytes);
    decoder->feed(all.first(cut), kArrival, parts);
    decoder->feed(all.subspan(cut), kArrival, parts);
    decoder->finish(parts);
    ASSERT_TRUE(same(d, parts)) << cut;
  }
}

TEST(Pd4Framing, EveryTurnedBitIsRefused) {
  for (std::size_t bit = 0; bit < 8 * 47; ++bit) {
    Bytes b = pd4();
    b[bit / 8] = static_cast<std::uint8_t>(b[bit / 8] ^ 1 << bit % 8);
    const Decoded d = decode_pd4(b + pd4());
    ASSERT_EQ(d.all<DvlVelocity>().size(), 1u) << bit;
    ASSERT_TRUE(covers(d, 94)) << bit;
  }
}

TEST(Pd4Framing, RubbishOfAnySizeLosesNoFrameAndNoByte) {
  std::mt19937 random(3);
  for (int round = 0; round < 100; ++round) {
    Bytes bytes;
    std::size_t frames = 0;
    while (bytes.size() < 20'000) {
      Bytes rubbish(random() % 300);
      for (auto& b : rubbish) b = static_cast<std::uint8_t>(random() % 8 == 0 ? 0x7D : random() % 3);
      bytes = bytes + rubbish + (random() % 2 == 0 ? pd4() : pd5());
      ++frames;
    }
    const Decoded d = decode_pd4(bytes);
    ASSERT_TRUE(covers(d, bytes.size())) << round;
    ASSERT_EQ(d.all<DvlVelocity>().size(), frames) << round;
    ASSERT_TRUE(same(d, decode_pd4(bytes, 1 + random() % 5000))) << round;
  }
  const Decoded long_run = decode_pd4(Bytes(200'000, 0));
  EXPECT_EQ(long_run.frames.size(), 4u);
  EXPECT_TRUE(covers(long_run, 200'000));
}

}  // namespace
}  // namespace leadline::test
