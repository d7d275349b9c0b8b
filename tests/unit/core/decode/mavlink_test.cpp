#include "core/decode/mavlink.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <map>

#include "core/decode/mavlink_frame.h"
#include "tests/support/files.h"
#include "tests/unit/core/decode/decoder_laws.h"

namespace leadline::test {
namespace {

constexpr Arrival kArrival{1'795'350'919'600'000'000};
constexpr std::uint64_t kStamp_us = 1'795'350'919'500'000;

std::unique_ptr<Decoder> make() { return decode::make_mavlink({}); }
Decoded decode_mavlink(const Bytes& b) { return decode_all(*make(), b, kArrival); }

/// A payload with values at their offsets.
struct Payload {
  Bytes bytes;
  explicit Payload(std::size_t size) : bytes(size) {}
  template <class T>
  Payload& put(std::size_t at, T value) {
    std::memcpy(bytes.data() + at, &value, sizeof value);
    return *this;
  }
};

struct Form {
  int version = 2;
  bool stamped = false, is_signed = false;
  std::uint8_t system = 1;
  std::uint64_t stamp_us = kStamp_us;
};

Bytes frame(std::uint32_t id, Bytes payload, Form form = {}) {
  if (form.version == 2)
    while (payload.size() > 1 && payload.back() == 0) payload.pop_back();
  Bytes b;
  const auto size = static_cast<std::uint8_t>(payload.size()), id0 = static_cast<std::uint8_t>(id);
  if (form.version == 1)
    b = {0xFE, size, 9, form.system, 1, id0};
  else
    b = {0xFD,
         size,
         static_cast<std::uint8_t>(form.is_signed),
         0,
         9,
         form.system,
         1,
         id0,
         static_cast<std::uint8_t>(id >> 8),
         static_cast<std::uint8_t>(id >> 16)};
  b.insert(b.end(), payload.begin(), payload.end());
  const auto* known = decode::find_mavlink(id);
  const std::uint16_t crc =
      decode::mavlink_checksum(std::span(b).subspan(1), known ? known->checksum_extra : std::uint8_t{0});
  b.push_back(static_cast<std::uint8_t>(crc)), b.push_back(static_cast<std::uint8_t>(crc >> 8));
  if (form.is_signed) b.insert(b.end(), 13, 0xAB);
  if (!form.stamped) return b;
  Bytes whole;
  for (int i = 7; i >= 0; --i) whole.push_back(static_cast<std::uint8_t>(form.stamp_us >> 8 * i));
  whole.insert(whole.end(), b.begin(), b.end());
  return whole;
}

Bytes attitude(Form form = {}) {
  return frame(30, Payload(28).put(4, 0.02F).put(8, -0.04F).put(12, -1.5F).put(24, 0.1F).bytes, form);
}
Payload gps_raw() {
  return Payload(52)
      .put(8, std::int32_t{592057612})
      .put(12, std::int32_t{52057612})
      .put(20, std::uint16_t{70})
      .put(24, std::uint16_t{150})
      .put(26, std::uint16_t{9000})
      .put(28, std::uint8_t{6})
      .put(29, std::uint8_t{14})
      .put(30, std::int32_t{85300});
}
Payload gps_input() {
  return Payload(65)
      .put(12, std::int32_t{592057612})
      .put(16, std::int32_t{52057612})
      .put(24, 1.5F)
      .put(32, 0.3F)
      .put(36, 0.4F)
      .put(40, 0.1F)
      .put(61, std::uint8_t{3})
      .put(62, std::uint8_t{9});
}

Bytes operator+(Bytes a, const Bytes& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

TEST(MavlinkFrames, TheChecksumIsX25) {
  // CRC-16/MCRF4XX of "123456789" is 0x6F91; the extra byte is one more.
  EXPECT_EQ(decode::mavlink_checksum(as_bytes("12345678"), '9'), 0x6F91);
}

TEST(MavlinkFrames, BothVersionsSignedBareAndStampedAreFound) {
  for (const int version : {1, 2})
    for (const bool is_signed : {false, true})
      for (const bool stamped : {false, true}) {
        if (version == 1 && is_signed) continue;
        const Bytes b = attitude({version, stamped, is_signed});
        const Decoded d = decode_mavlink(b + b);
        EXPECT_EQ(d.all<Attitude>().size(), 2u) << version << is_signed << stamped;
        EXPECT_EQ(d.frames.size(), stamped ? 4u : 2u);
        EXPECT_TRUE(covers(d, 2 * b.size()));
        EXPECT_EQ(d.ledger.bytes(ByteClass::stamp), stamped ? 16u : 0u);
        EXPECT_EQ(d.facts.back().device_time.has_value(), stamped);
      }
}

TEST(MavlinkFrames, InAStreamWithoutStampsNothingPassesForOne) {
  const Bytes false_stamp{0, 5, 0xD1, 0x30, 0, 0, 0, 0};  // of 2021
  const Decoded d = decode_mavlink(attitude() + attitude() + false_stamp + attitude());
  EXPECT_EQ(d.all<Attitude>().size(), 3u);
  EXPECT_TRUE(d.all<ClockReading>().empty());
  EXPECT_EQ(d.frames.at(2).byte_class, ByteClass::skipped);
}

TEST(MavlinkFrames, AnUnknownMessageNeedsAFrameBehindIt) {
  const Bytes unknown = frame(60'000, {1, 2, 3}, {.stamped = true});
  const Decoded d = decode_mavlink(unknown + attitude({.stamped = true}));
  EXPECT_EQ(d.frames.at(1).byte_class, ByteClass::unknown);
  EXPECT_EQ(d.frames.at(1).kind, "message");
  EXPECT_EQ(decode_mavlink(unknown + Bytes(20, 0x55)).ledger.frames(), 0u);
}

TEST(Mavlink, AttitudeIsHeadingRollPitchAndRate) {
  const Decoded d = decode_mavlink(attitude({.stamped = true}));
  EXPECT_NEAR(d.all<Heading>().at(0).heading.rad(), 2 * kPi - 1.5, 1e-7);
  EXPECT_EQ(d.all<Heading>()[0].reference, HeadingReference::true_north);
  EXPECT_NEAR(d.all<Attitude>().at(0).roll.rad(), 0.02, 1e-9);
  EXPECT_NEAR(d.all<Attitude>()[0].pitch.rad(), -0.04, 1e-9);
  EXPECT_NEAR(d.all<Rates>().at(0).rate_z_rps, 0.1, 1e-8);
  for (const auto& fact : d.facts)
    EXPECT_EQ(fact.device_time, Time{static_cast<std::int64_t>(kStamp_us) * 1000});
}

TEST(Mavlink, GpsRawIntIsAFixAndACourse) {
  const Decoded d = decode_mavlink(frame(24, gps_raw().bytes));
  const auto fix = d.all<GnssFix>().at(0);
  EXPECT_NEAR(fix.position.lat.deg(), 59.2057612, 1e-12);
  EXPECT_NEAR(fix.position.lon.deg(), 5.2057612, 1e-12);
  EXPECT_EQ(fix.quality, GnssQuality::rtk_fixed);
  EXPECT_EQ(fix.satellites, 14);
  EXPECT_NEAR(*fix.hdop, 0.7, 1e-12);
  EXPECT_NEAR(fix.height->m, 85.3, 1e-12);
  EXPECT_NEAR(d.all<Course>().at(0).speed_mps, 1.5, 1e-12);
  EXPECT_NEAR(d.all<Course>()[0].course->deg(), 90.0, 1e-12);
  const Decoded unknown =
      decode_mavlink(frame(24, gps_raw().put(20, std::uint16_t{65535}).put(24, std::uint16_t{65535}).bytes));
  EXPECT_FALSE(unknown.all<GnssFix>().at(0).hdop);
  EXPECT_TRUE(unknown.all<Course>().empty());
  for (const int type : {0, 1, 2, 7}) {
    const Decoded none = decode_mavlink(frame(24, gps_raw().put(28, static_cast<std::uint8_t>(type)).bytes));
    EXPECT_TRUE(none.facts.empty()) << type;
    EXPECT_EQ(none.frames.at(0).byte_class, ByteClass::unused);
  }
}

TEST(Mavlink, GpsInputAndItsRepeatAreOneReceiver) {
  const auto at = [](double s) {
    return Form{.stamped = true, .stamp_us = kStamp_us + static_cast<std::uint64_t>(s * 1e6)};
  };
  const Decoded d = decode_mavlink(frame(232, gps_input().bytes, at(0)) + frame(24, gps_raw().bytes, at(1)) +
                                   frame(24, gps_raw().bytes, at(6)));
  ASSERT_EQ(d.all<GnssFix>().size(), 2u) << "GPS_RAW_INT counts again after 5 s without GPS_INPUT";
  EXPECT_EQ(d.all<GnssFix>()[0].quality, GnssQuality::autonomous);
  EXPECT_NEAR(*d.all<GnssFix>()[0].hdop, 1.5, 1e-7);
  EXPECT_NEAR(d.all<Course>()[0].speed_mps, 0.5, 1e-7);
  EXPECT_NEAR(d.all<Course>()[0].course->deg(), 53.130102, 1e-5);
  EXPECT_NEAR(*d.all<Course>()[0].vel_down_mps, 0.1, 1e-8);
  const Decoded still = decode_mavlink(frame(232, gps_input().put(56, std::uint16_t{2 + 8 + 16}).bytes));
  EXPECT_EQ(still.all<GnssFix>().size(), 1u);
  EXPECT_FALSE(still.all<GnssFix>()[0].hdop);
  EXPECT_TRUE(still.all<Course>().empty()) << "velocity is to be ignored";
}

TEST(Mavlink, ScaledPressure2IsThePressureOfTheWater) {
  const Decoded d = decode_mavlink(frame(137, Payload(14).put(4, 2026.5F).bytes));
  EXPECT_NEAR(d.all<Pressure>().at(0).gauge_pa, 202'650.0 - 101'325.0, 1e-6);
  EXPECT_NEAR(d.all<DepthMeasured>().at(0).depth.m, 10.05, 0.02);
  decode::ProfileOptions lake;
  lake.mavlink_atmosphere_hpa = 950.0, lake.density_kgm3 = 1000.0;
  const Decoded fresh =
      decode_all(*decode::make_mavlink({}, lake), frame(137, Payload(14).put(4, 2026.5F).bytes));
  EXPECT_NEAR(fresh.all<DepthMeasured>().at(0).depth.m, 107'650.0 / 9806.2, 0.01);
}

TEST(Mavlink, NumbersThatAreNoneAreRefused) {
  const Bytes cases[] = {frame(30, Payload(28).put(4, NAN).bytes),
                         frame(30, Payload(28).put(12, 100.0F).bytes),
                         frame(30, Payload(28).put(24, INFINITY).bytes),
                         frame(24, gps_raw().put(8, std::int32_t{910000000}).bytes),
                         frame(24, gps_raw().put(8, std::int32_t{0}).put(12, std::int32_t{0}).bytes),
                         frame(232, gps_input().put(32, NAN).bytes),
                         frame(137, Payload(14).put(4, NAN).bytes),
                         frame(137, Payload(14).put(4, -1.0F).bytes)};
  for (const Bytes& b : cases) {
    const Decoded d = decode_mavlink(b);
    EXPECT_TRUE(d.facts.empty());
    EXPECT_EQ(d.frames.at(0).reason, "range");
  }
  EXPECT_EQ(decode_mavlink(frame(30, Bytes(20), {.version = 1})).frames.at(0).reason, "fields");
}

TEST(Mavlink, WhatTheVehiclesFilterMadeIsNotUsed) {
  for (const std::uint32_t id : {0u, 27u, 32u, 33u, 74u}) {
    const Decoded d = decode_mavlink(frame(id, Bytes(28, 1)));
    EXPECT_TRUE(d.facts.empty()) << id;
    EXPECT_EQ(d.frames.at(0).byte_class, ByteClass::unused) << id;
  }
}

TEST(Mavlink, AnAddressPicksOneVehicle) {
  DecoderSettings settings;
  settings.address = "2";
  const Bytes both = attitude() + attitude({.system = 2});
  const Decoded d = decode_all(*decode::make_mavlink(settings), both, kArrival);
  EXPECT_EQ(d.all<Attitude>().size(), 1u);
  EXPECT_EQ(d.frames.at(0).byte_class, ByteClass::unused);
}

TEST(MavlinkLog, EveryByteOfARealDiveLogIsFramed) {
  const Bytes log = read_bytes(data_path("ardusub_mavlink/small.tlog"));
  const Decoded d = decode_mavlink(log);
  EXPECT_TRUE(covers(d, log.size()));
  EXPECT_EQ(d.ledger.frames(), 35'916u);
  EXPECT_EQ(d.ledger.bytes(ByteClass::stamp), 8u * 35'916u);
  EXPECT_EQ(d.ledger.bytes(ByteClass::skipped) + d.ledger.bytes(ByteClass::refused), 0u);
  EXPECT_EQ(d.ledger.frames(ByteClass::unknown), 4u) << "camera messages, each sent once";
  EXPECT_EQ(d.ledger.checksums(ChecksumState::ok), 35'912u);
  std::map<std::string_view, std::uint64_t> counts;
  for (const auto& kind : d.ledger.kinds()) counts[kind.name] = kind.count;
  EXPECT_EQ(counts["ATTITUDE"], 5245u);
  EXPECT_EQ(counts["GPS_INPUT"], 1011u);
  EXPECT_EQ(counts["SCALED_PRESSURE2"], 635u);
  EXPECT_EQ(d.all<Attitude>().size(), 5245u);
  double least_pa = 1e9, most_pa = -1e9;
  for (const Pressure& p : d.all<Pressure>())
    least_pa = std::min(least_pa, p.gauge_pa), most_pa = std::max(most_pa, p.gauge_pa);
  EXPECT_NEAR(most_pa - least_pa, 260.0, 10.0) << "on deck";
  std::size_t places = 0;
  for (const GnssFix& f : d.all<GnssFix>()) places += !(f.position == d.all<GnssFix>()[0].position);
  EXPECT_EQ(places, 0u);
  EXPECT_NEAR(d.all<GnssFix>()[0].position.lat.deg(), 48.3861418, 1e-6);
  EXPECT_TRUE(same(d, decode_all(*make(), log, kArrival, 777)));
}

TEST(MavlinkLaws, Hold) {
  const Bytes three = attitude({.stamped = true}) + frame(60'000, {1, 2}, {.stamped = true}) +
                      frame(232, gps_input().bytes, {.stamped = true});
  expect_any_split_alike(make, three, kArrival);
  for (std::size_t size = 0; size < three.size(); ++size) {
    const Decoded d = decode_all(*make(), std::span(three).first(size), kArrival);
    ASSERT_TRUE(covers(d, size)) << size;
  }
  expect_byte_changes_harmless(make, attitude(), kArrival, true);
  expect_byte_changes_harmless(make, attitude({.version = 1}), kArrival, true);
  // A stamp is under no checksum: its frame is believed without it.
  expect_byte_changes_harmless(make, attitude({.stamped = true}), kArrival, false);
}

}  // namespace
}  // namespace leadline::test
