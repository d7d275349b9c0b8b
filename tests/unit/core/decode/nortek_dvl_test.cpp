#include "core/decode/nortek_dvl.h"

#include <gtest/gtest.h>
#include <cmath>
#include <cstring>

#include "core/decode/nortek_dvl_ping.h"
#include "tests/support/files.h"
#include "tests/unit/core/decode/decoder_laws.h"

namespace leadline::test {
namespace {

constexpr Arrival kArrival{1'795'350'919'600'000'000};  // 2026-11-22T12:35:19.6Z
constexpr double kTiny = 1e-9, kSingle = 2e-7;

Bytes df21() { return read_bytes(data_path("wire-samples/nortek_df21.bin")); }

/// Puts both checksums of an edited record right again.
Bytes sealed(Bytes b) {
  const auto put = [&](std::size_t at, std::uint16_t v) {
    b[at] = static_cast<std::uint8_t>(v), b[at + 1] = static_cast<std::uint8_t>(v >> 8);
  };
  put(6, decode::nortek_checksum(std::span(b).subspan(decode::kNortekHeader)));
  put(8, decode::nortek_checksum(std::span(b).first(8)));
  return b;
}

void put_f32(Bytes& b, std::size_t at, float value) {
  std::memcpy(b.data() + decode::kNortekHeader + at, &value, sizeof value);
}
void put_status(Bytes& b, std::uint32_t value) {
  std::memcpy(b.data() + decode::kNortekHeader + 20, &value, sizeof value);
}

std::unique_ptr<Decoder> make() { return decode::make_nortek_dvl({}); }
Decoded decode_nortek(const Bytes& bytes) { return decode_all(*make(), bytes, kArrival); }

std::string sentence(const std::string& fields) {
  unsigned sum = 0;
  for (const char c : fields) sum ^= static_cast<std::uint8_t>(c);
  char end[8];
  std::snprintf(end, sizeof end, "*%02X\r\n", sum);
  return "$" + fields + end;
}
Decoded decode_text(const std::string& text, const DecoderSettings& settings = {}) {
  return decode_all(*decode::make_nortek_dvl(settings), as_bytes(text), kArrival);
}

TEST(NortekDvl, TheSampleGivesItsDocumentedValues) {
  const Decoded d = decode_nortek(df21());
  const Time trigger = *parse_iso8601("2026-11-22T12:35:19.500Z");
  ASSERT_EQ(d.all<ClockReading>().size(), 1u);
  EXPECT_EQ(d.all<ClockReading>()[0].device_ns, trigger.ns);
  for (const auto& fact : d.facts)
    EXPECT_NEAR(seconds(*fact.device_time - trigger), 0.012, 1e-6) << "valid at trigger + DT1";
  const auto v = d.all<DvlVelocity>().at(0);
  EXPECT_TRUE(v.valid);
  EXPECT_EQ(v.reference, DvlReference::bottom);
  EXPECT_EQ(v.frame, DvlFrame::instrument);
  EXPECT_NEAR(v.x_mps, 0.850, kSingle);
  EXPECT_NEAR(v.y_mps, 0.120, kSingle);
  EXPECT_NEAR(v.z_mps, -0.0305, kSingle) << "the mean of Z1 and Z2";
  EXPECT_NEAR(*v.sd_mps, 0.002, kSingle);
  const double ranges[] = {11.05, 11.10, 10.95, 11.00};
  for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(d.all<BeamRanges>()[0].range_m[i], ranges[i], 1e-6);
  EXPECT_NEAR(d.all<AltitudeAboveBottom>()[0].above_bottom_m, 11.025, 1e-6);
  EXPECT_NEAR(d.all<SoundSpeed>()[0].speed_mps, 1490.2, 1e-4);
  EXPECT_NEAR(d.all<Pressure>()[0].gauge_pa, 11.8e5, 0.1);
  ASSERT_EQ(d.frames.size(), 1u);
  EXPECT_EQ(d.frames[0].kind, "bottom track");
  EXPECT_EQ(d.frames[0].checksum, ChecksumState::ok);
  EXPECT_EQ(d.frames[0].length, 222u);
}

TEST(NortekDvl, TheStatusWordIsBelievedFirstThenTheMarkers) {
  const struct {
    const char* what;
    std::uint32_t cleared;
    std::size_t at;
    float value;
    bool valid;
    double z_mps;
  } cases[] = {{"X not vouched for", 1u << 12, 0, 0, false, 0},
               {"Y not vouched for", 1u << 13, 0, 0, false, 0},
               {"one Z is enough", 1u << 14, 0, 0, true, -0.031},
               {"the other Z is enough", 1u << 15, 0, 0, true, -0.030},
               {"neither Z", 3u << 14, 0, 0, false, 0},
               {"X by its marker", 0, 132, -32.768F, false, 0},
               {"Z1 by its marker", 0, 140, -32.768F, true, -0.031},
               {"a cleared bit hides even rubbish", 1u << 14, 140, NAN, true, -0.031}};
  for (const auto& c : cases) {
    Bytes b = df21();
    put_status(b, 0x000FFFFFu & ~c.cleared);
    if (c.at != 0) put_f32(b, c.at, c.value);
    const auto v = decode_nortek(sealed(b)).all<DvlVelocity>().at(0);
    EXPECT_EQ(v.valid, c.valid) << c.what;
    EXPECT_NEAR(v.z_mps, c.z_mps, kSingle) << c.what;
    if (!c.valid) {
      EXPECT_EQ(v.x_mps, 0.0) << c.what;
    }
  }
  Bytes no_fom = df21();
  put_status(no_fom, 0x000EFFFF);
  EXPECT_FALSE(decode_nortek(sealed(no_fom)).all<DvlVelocity>().at(0).sd_mps);
  Bytes no_beam = df21();
  put_status(no_beam, 0x000FFFEF);  // distance of beam 1
  const Decoded d = decode_nortek(sealed(no_beam));
  EXPECT_EQ(d.all<BeamRanges>()[0].range_m[0], 0.0);
  EXPECT_NEAR(d.all<AltitudeAboveBottom>()[0].above_bottom_m, 11.05, 1e-6) << "beams 2 and 4";
}

TEST(NortekDvl, WaterTrackIsThroughTheWaterAndHasNoAltitude) {
  Bytes b = df21();
  b[2] = decode::kNortekWaterTrack;
  Decoded d = decode_nortek(sealed(b));
  EXPECT_EQ(d.all<DvlVelocity>().at(0).reference, DvlReference::water);
  EXPECT_EQ(d.all<AltitudeAboveBottom>().size() + d.all<BeamRanges>().size(), 0u);
  put_status(b, 0);
  EXPECT_EQ(decode_nortek(sealed(b)).all<DvlVelocity>().size(), 0u);
}

TEST(NortekDvl, OtherRecordsAreKnownAndNotUsed) {
  const struct {
    std::uint8_t id;
    ByteClass byte_class;
    const char* kind;
  } cases[] = {{0x17, ByteClass::unused, "bottom track DF20"},
               {0x15, ByteClass::unused, "burst"},
               {0x16, ByteClass::unused, "profile"},
               {0x1C, ByteClass::unused, "echo sounder"},
               {0xA0, ByteClass::unused, "string"},
               {0x77, ByteClass::unknown, "AD2CP"}};
  for (const auto& c : cases) {
    Bytes b = df21();
    b.resize(61);  // of an odd length
    b[2] = c.id, b[4] = 51, b[5] = 0;
    const Decoded d = decode_nortek(sealed(b));
    ASSERT_EQ(d.frames.size(), 1u);
    EXPECT_EQ(d.frames[0].byte_class, c.byte_class);
    EXPECT_EQ(d.frames[0].kind, c.kind);
    EXPECT_TRUE(d.facts.empty());
  }
}

TEST(NortekDvl, NumbersThatAreNoneAreRefused) {
  const struct {
    std::size_t at;
    float value;
  } cases[] = {{24, NAN}, {32, INFINITY}, {132, NAN},   {140, INFINITY},
               {52, NAN}, {52, -1.0F},    {132, 99.0F}, {164, NAN}};
  for (const auto& c : cases) {
    Bytes b = df21();
    put_f32(b, c.at, c.value);
    const Decoded d = decode_nortek(sealed(b));
    EXPECT_TRUE(d.facts.empty()) << c.at;
    EXPECT_EQ(d.frames.at(0).reason, "range") << c.at;
  }
  Bytes odd_version = df21();
  odd_version[10] = 9;
  EXPECT_EQ(decode_nortek(sealed(odd_version)).frames.at(0).reason, "fields");
  Bytes no_clock = df21();
  no_clock[16] = 70;  // 1970
  EXPECT_FALSE(decode_nortek(sealed(no_clock)).facts.at(0).device_time);
}

TEST(NortekDvl, TheProfileTurnsTheSignOfTheBottom) {
  decode::ProfileOptions profile;
  profile.nortek_velocity = "bottom";
  const Decoded d = decode_all(*decode::make_nortek_dvl({}, profile), df21(), kArrival);
  EXPECT_NEAR(d.all<DvlVelocity>().at(0).x_mps, -0.850, kSingle);
}

TEST(NortekSentences, GiveTheirDocumentedValues) {
  const struct {
    const char* line;
    bool valid;
    double x, y, z, altitude_m;
    std::size_t pressures;
  } cases[] = {
      {"$PNORBT7,1795350919.5000,1.234,-1.234,0.8500,0.1200,-0.0300,0.00200,11.05,11.10,10.95,11.00*1E\r\n",
       true, 0.85, 0.12, -0.03, 11.025, 0},
      {"$PNORBT8,TIME=1795350919.5000,DT1=1.234,DT2=-1.234,VX=0.8500,VY=0.1200,VZ=-32.7680,FOM=10.00000,"
       "D1=0.00,D2=11.10,D3=10.95,D4=11.00,BATT=23.4,SS=1490.2,PRESS=11.8,TEMP=8.25,STAT=0x000F7FFE*41\r\n",
       false, 0, 0, 0, 11.05, 1},
      {"$PNORBT9,1452244916.7508,1.234,-1.234,0.1234,0.1234,0.1234,12.34,23.45,23.45,23.45,23.45,23.4,1567.8,"
       "1.2,12.3,0x000FFFFF*1E\r\n",
       true, 0.1234, 0.1234, 0.1234, 23.45, 1}};
  for (const auto& c : cases) {
    const Decoded d = decode_text(c.line);
    ASSERT_EQ(d.frames.size(), 1u) << c.line;
    EXPECT_EQ(d.frames[0].byte_class, ByteClass::decoded) << c.line;
    EXPECT_EQ(d.frames[0].kind, std::string_view(c.line).substr(1, 7));
    EXPECT_EQ(d.frames[0].checksum, ChecksumState::ok);
    const auto v = d.all<DvlVelocity>().at(0);
    EXPECT_EQ(v.valid, c.valid) << c.line;
    EXPECT_NEAR(v.x_mps, c.x, kTiny);
    EXPECT_NEAR(v.y_mps, c.y, kTiny);
    EXPECT_NEAR(v.z_mps, c.z, kTiny);
    EXPECT_NEAR(d.all<AltitudeAboveBottom>().at(0).above_bottom_m, c.altitude_m, kTiny);
    EXPECT_EQ(d.all<Pressure>().size(), c.pressures);
  }
  const Decoded d = decode_text(cases[0].line);
  EXPECT_NEAR(*d.all<DvlVelocity>()[0].sd_mps, 0.002, kTiny);
  EXPECT_NEAR(seconds(*d.first<DvlVelocity>()->device_time - from_unix(1795350919.5)), 0.001234, 1e-9);
}

TEST(NortekSentences, TheStatusWordTakesVelocityAndBeams) {
  const std::string body =
      "PNORBT9,1795350919.5,1.0,-1.0,0.85,0.12,-0.03,0.002,11.05,11.10,10.95,11.00,23.4,1490.2,11.8,8.25,";
  EXPECT_TRUE(decode_text(sentence(body + "0x000FFFFF")).all<DvlVelocity>()[0].valid);
  EXPECT_FALSE(decode_text(sentence(body + "0x000FEFFF")).all<DvlVelocity>()[0].valid);
  EXPECT_TRUE(decode_text(sentence(body + "0x000F7FFF")).all<DvlVelocity>()[0].valid) << "one Z is left";
  EXPECT_FALSE(decode_text(sentence(body + "0x000F3FFF")).all<DvlVelocity>()[0].valid);
  EXPECT_EQ(decode_text(sentence(body + "0x000FFFDF")).all<BeamRanges>()[0].range_m[1], 0.0);
  EXPECT_EQ(decode_text(sentence(body + "0x00FFG")).frames.at(0).reason, "fields");
}

TEST(NortekSentences, WhatIsNoVelocityIsKnownAndNotUsed) {
  const char* const kReal =
      "$PNORBT0,1,040721,131335.3341,23.961,-48.122,-32.76800,10.00000,0.00,0x00000000*48\r\n";
  const std::string lines[] = {kReal, sentence("PNORBT4,1.0,-1.0,0.5,12.0,0.01,11.0"),
                               sentence("PNORWT3,DT1=1.0,DT2=-1.0,SP=0.5,DIR=12.0,FOM=0.01,D=11.0"),
                               sentence("PNORS,102115,090715")};
  const char* const kinds[] = {"PNORBT0", "PNORBT4", "PNORWT3", "PNOR"};
  for (std::size_t i = 0; i < 4; ++i) {
    const Decoded d = decode_text(lines[i]);
    ASSERT_EQ(d.frames.size(), 1u) << lines[i];
    EXPECT_EQ(d.frames[0].byte_class, ByteClass::unused) << lines[i];
    EXPECT_EQ(d.frames[0].kind, kinds[i]);
    EXPECT_TRUE(d.facts.empty());
  }
  const auto water = decode_text(
      sentence("PNORWT6,TIME=1795350919.5,DT1=1,DT2=-1,VX=0.1,VY=0.2,VZ=0.3,FOM=0.01,D1=1,D2=1,D3=1,D4=1"));
  EXPECT_EQ(water.all<DvlVelocity>().at(0).reference, DvlReference::water);
}

TEST(NortekSentences, DamagedOnesAreRefusedWithTheirReason) {
  const std::string good = "PNORBT7,1795350919.5,1.234,-1.234,0.85,0.12,-0.03,0.002,11.05,11.10,10.95,11.00";
  const struct {
    std::string line;
    const char* reason;
  } cases[] = {
      {"$" + good + "*00\r\n", "checksum"},
      {"$" + good + "\r\n", "checksum absent"},
      {sentence(good + ",1"), "fields"},
      {sentence("PNORBT7,1795350919.5,1.234,-1.234,0.85,nan,-0.03,0.002,11.05,11.10,10.95,11.00"), "fields"},
      {sentence("PNORBT7,1795350919.5,1.234,-1.234,85,0.12,-0.03,0.002,11.05,11.10,10.95,11.00"), "range"},
      {sentence("PNORBT6,TIME=1,DT1=1,DT2=1,VX=1,VY=1,VW=1,FOM=1,D1=1,D2=1,D3=1,D4=1"), "fields"},
      {"$" + good.substr(0, 30) + sentence(good), "torn"},
      {"$" + good.substr(0, 30), "truncated"},
      {"$PNOR" + std::string(600, 'x') + "\r\n", "too long"}};
  for (const auto& c : cases) {
    const Decoded d = decode_text(c.line);
    EXPECT_EQ(d.frames.at(0).byte_class, ByteClass::refused) << c.line;
    EXPECT_EQ(d.frames.at(0).reason, c.reason) << c.line;
    EXPECT_TRUE(covers(d, c.line.size())) << c.line;
  }
  DecoderSettings lenient;
  lenient.checksum_required = false;
  EXPECT_EQ(decode_text("$" + good + "\n", lenient).all<DvlVelocity>().size(), 1u);
}

Bytes mixed() {
  Bytes b = df21();
  for (const char c :
       sentence("PNORBT7,1795350919.5,1.234,-1.234,0.85,0.12,-0.03,0.002,11.05,11.1,10.95,11.0"))
    b.push_back(static_cast<std::uint8_t>(c));
  const Bytes again = df21();
  b.insert(b.end(), again.begin(), again.end());
  return b;
}

TEST(NortekLaws, RecordsAndSentencesMixInOneStream) {
  const Decoded d = decode_nortek(mixed());
  EXPECT_EQ(d.all<DvlVelocity>().size(), 3u);
  EXPECT_EQ(d.frames.size(), 3u);
  expect_any_split_alike(make, mixed(), kArrival);
  expect_prefixes_accounted(make, mixed(), kArrival);
}

TEST(NortekLaws, EveryTurnedBitIsRefused) {
  for (std::size_t bit = 0; bit < 8 * 222; ++bit) {
    Bytes b = df21();
    b[bit / 8] = static_cast<std::uint8_t>(b[bit / 8] ^ 1 << bit % 8);
    const Decoded d = decode_nortek(b);
    ASSERT_TRUE(d.facts.empty()) << bit;
    ASSERT_TRUE(covers(d, 222)) << bit;
  }
}

TEST(NortekLaws, DamageCostsOnlyItself) {
  expect_byte_changes_harmless(make, df21(), kArrival, true);
  const std::string line =
      sentence("PNORBT7,1795350919.5,1.2,-1.2,0.85,0.12,-0.03,0.002,11.05,11.1,10.95,11.6");
  // Another case in the checksum or another end of the line is the same sentence.
  expect_byte_changes_harmless(make, Bytes(line.begin(), line.end()), kArrival, false);
  expect_found_in_rubbish(make, df21(), kArrival, 5);
}

}  // namespace
}  // namespace leadline::test
