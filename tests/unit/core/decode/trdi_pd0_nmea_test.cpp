// NMEA embedded in PD0 ensembles.

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "tests/unit/core/decode/trdi_pd0_samples.h"

namespace leadline::test {
namespace {

constexpr double kTiny = 1e-9;

template <class T>
void append(Bytes& bytes, T value) {
  const std::size_t at = bytes.size();
  bytes.resize(at + sizeof value);
  std::memcpy(bytes.data() + at, &value, sizeof value);
}
void append_text(Bytes& bytes, const std::string& text, std::size_t length) {
  bytes.insert(bytes.end(), text.begin(), text.end());
  bytes.resize(bytes.size() + length - text.size());
}

Bytes block(int id, double delta_s, const Bytes& body) {
  Bytes b = {0x22, 0x20};
  append_u16(b, id), append_u16(b, static_cast<int>(body.size()));
  append(b, delta_s);
  return std::move(b) + body;
}
Bytes gga(const std::string& utc, int quality = 2, double lat = 44.9, char ns = 'N', double lon = 66.9,
          char ew = 'W') {
  Bytes b;
  append_text(b, "$GPGGA", 7), append_text(b, utc, 10);
  append(b, lat), b.push_back(static_cast<std::uint8_t>(ns)), append(b, lon),
      b.push_back(static_cast<std::uint8_t>(ew));
  b.push_back(static_cast<std::uint8_t>(quality)), b.push_back(9);
  append(b, 1.3f), append(b, 9.25f), b.push_back('M'), append(b, -28.0f), b.push_back('M'), append(b, 4.0f),
      append_u16(b, 133);
  return b;
}
Bytes text(const std::string& sentence) { return {sentence.begin(), sentence.end()}; }
Bytes with_blocks(const std::vector<Bytes>& blocks) {
  auto types = types_of(pd0_sample());
  types.insert(types.end(), blocks.begin(), blocks.end());
  return compose(types);
}
std::vector<FrameReport> blocks_of(const Decoded& d) {
  std::vector<FrameReport> blocks;
  for (const auto& f : d.frames)
    if (f.block) blocks.push_back(f);
  return blocks;
}

TEST(Pd0Nmea, AFixHoldsAtTheEnsemblesTimeMinusItsDelay) {
  const Bytes bytes = with_blocks({block(104, -0.12, gga("163545.70"))});
  const Decoded d = decode_pd0(bytes);
  const auto* fix = d.first<GnssFix>();
  ASSERT_NE(fix, nullptr);
  EXPECT_EQ(fix->device_time, parse_iso8601("2026-11-22T12:35:19.620Z"));
  const GnssFix f = d.all<GnssFix>()[0];
  EXPECT_NEAR(f.position.lat.deg(), 44.9, kTiny);
  EXPECT_NEAR(f.position.lon.deg(), -66.9, kTiny);
  EXPECT_NEAR(f.height->m, 9.25 - 28.0, 1e-6);
  EXPECT_EQ(f.quality, GnssQuality::differential);
  EXPECT_EQ(f.satellites, 9);
  EXPECT_NEAR(*f.hdop, 1.3, 1e-6);
  const auto clocks = d.all<ClockReading>();
  ASSERT_EQ(clocks.size(), 2u);
  EXPECT_EQ(clocks[1].device_ns, fix->device_time->ns);
  EXPECT_EQ(clocks[1].reference_ns, parse_iso8601("2026-11-22T16:35:45.700Z")->ns)
      << "a local clock stays 4 h off";
  EXPECT_EQ(d.frames[0].length + d.frames[1].length, bytes.size());
  EXPECT_EQ(d.frames[1].length, 71u);
  EXPECT_EQ(d.frames[1].kind, "NMEA GGA");
  EXPECT_TRUE(d.frames[1].block);
}

TEST(Pd0Nmea, TheDayIsTheOneNearestToTheEnsemble) {
  auto types = types_of(with_blocks({block(104, 0.0, gga("000001.00"))}));
  types[1][4 + 3] = types[1][57 + 4] = 23;  // the ensemble at 23:35:19.50
  const auto clocks = decode_pd0(compose(types)).all<ClockReading>();
  ASSERT_EQ(clocks.size(), 2u);
  EXPECT_EQ(clocks[1].reference_ns, parse_iso8601("2026-11-23T00:00:01Z")->ns);
}

TEST(Pd0Nmea, OneFixIsToldOnceAndTheBinaryOneWins) {
  const std::string sentence =
      "$GPGGA,163545.70,4454.000000,N,06654.000000,W,2,9,1.3,9.2,M,-28.1,M,4.0,0133\r\n";
  Bytes older = {0x01, 0x21};
  append_u16(older, static_cast<int>(sentence.size()));
  older = std::move(older) + text(sentence);
  // Text stands first, then the binary form, then both once more in the next ensemble.
  const Bytes ensemble =
      with_blocks({older, block(4, -0.3, text(sentence)), block(104, 0.2, gga("163545.70"))});
  const Decoded d = decode_pd0(ensemble + ensemble);
  ASSERT_EQ(d.all<GnssFix>().size(), 1u);
  EXPECT_EQ(d.first<GnssFix>()->device_time, parse_iso8601("2026-11-22T12:35:19.300Z"));
  std::vector<ByteClass> classes;
  for (const auto& f : blocks_of(d)) classes.push_back(f.byte_class);
  using enum ByteClass;
  EXPECT_EQ(classes, (std::vector{unused, unused, decoded, unused, unused, unused}));
}

TEST(Pd0Nmea, ATextAloneIsAFix) {
  const std::string sentence = "$GPGGA,163545.7,4454.600000,S,06654.300000,E,1,,,9.2,M,,M,,\r\n";
  Bytes older = {0x01, 0x21};
  append_u16(older, static_cast<int>(sentence.size()));
  const Decoded d = decode_pd0(with_blocks({std::move(older) + text(sentence)}));
  ASSERT_EQ(d.all<GnssFix>().size(), 1u);
  const GnssFix f = d.all<GnssFix>()[0];
  EXPECT_NEAR(f.position.lat.deg(), -44.91, kTiny);
  EXPECT_NEAR(f.position.lon.deg(), 66.905, kTiny);
  EXPECT_FALSE(f.height);
  EXPECT_FALSE(f.satellites);
  EXPECT_EQ(d.all<ClockReading>().size(), 1u) << "this form does not say when it came";
}

TEST(Pd0Nmea, NoFixEstimatedManualAndSimulatedPositionsAreNoFix) {
  for (const int quality : {0, 6, 7, 8}) {
    const Decoded d = decode_pd0(with_blocks({block(104, 0.0, gga("163545.70", quality))}));
    EXPECT_EQ(d.all<GnssFix>().size(), 0u) << quality;
    EXPECT_EQ(blocks_of(d)[0].byte_class, ByteClass::unused);
  }
}

TEST(Pd0Nmea, DamagedBlocksAreRefusedAndTheEnsembleIsNot) {
  Bytes short_body = block(104, 0.0, gga("163545.70"));
  put_u16(short_body, 4, 500);
  const struct {
    Bytes block;
    const char* reason;
  } cases[] = {{block(104, 0.0, Bytes(57, 0)), "nmea body"},
               {block(104, 0.0, text("$GPVTG") + Bytes(51, 0)), "nmea body"},
               {short_body, "nmea size"},
               {block(104, 0.0, text("$GPGGA") + Bytes(20, 0)), "nmea size"},
               {block(104, 1e300, gga("163545.70")), "range"},
               {block(104, 0.0, gga("163545.70", 2, 91.0)), "range"},
               {block(104, 0.0, gga("163545.70", 2, std::nan(""))), "range"},
               {block(104, 0.0, gga("246060.00")), "range"},
               {block(4, 0.0, text("$GPGGA,201423.00,,,,,0,00,99.99,,,,,,*61\r\n")), "checksum"}};
  for (const auto& c : cases) {
    const Bytes bytes = with_blocks({c.block});
    const Decoded d = decode_pd0(bytes);
    ASSERT_EQ(d.frames.size(), 2u);
    EXPECT_EQ(d.frames[0].byte_class, ByteClass::decoded);
    EXPECT_EQ(d.frames[1].byte_class, ByteClass::refused);
    EXPECT_EQ(d.frames[1].reason, c.reason);
    EXPECT_TRUE(d.frames[1].block);
    EXPECT_EQ(d.frames[0].length + d.frames[1].length, bytes.size());
    EXPECT_EQ(d.all<GnssFix>().size(), 0u);
  }
}

TEST(Pd0Nmea, CourseAndDepthAreTakenFromTheirBlocks) {
  Bytes vtg, dbt;
  append_text(vtg, "$GPVTG", 7);
  for (const auto& [value, unit] : {std::pair{48.57f, 'T'}, {39.89f, 'M'}, {2.0f, 'N'}, {3.704f, 'K'}})
    append(vtg, value), vtg.push_back(static_cast<std::uint8_t>(unit));
  vtg.push_back('D');
  append_text(dbt, "$SDDBT", 7);
  for (const auto& [value, unit] : {std::pair{4.5f, 'f'}, {1.375f, 'M'}, {0.75f, 'F'}})
    append(dbt, value), dbt.push_back(static_cast<std::uint8_t>(unit));
  const Decoded d =
      decode_pd0(with_blocks({block(105, 0.5, vtg), block(106, 0.25, dbt), block(106, 0.25, dbt)}));
  ASSERT_EQ(d.all<Course>().size(), 1u);
  EXPECT_NEAR(d.all<Course>()[0].speed_mps, 2.0 * 1852.0 / 3600.0, kTiny);
  EXPECT_NEAR(d.all<Course>()[0].course->deg(), 48.57, 1e-5);
  EXPECT_EQ(d.first<Course>()->device_time, parse_iso8601("2026-11-22T12:35:19Z"));
  ASSERT_EQ(d.all<BottomDepth>().size(), 1u) << "the same depth at the same time is one";
  EXPECT_NEAR(d.all<BottomDepth>()[0].depth_m, 1.375, kTiny);
  EXPECT_EQ(d.all<BottomDepth>()[0].below, BottomDepth::Below::transducer);
}

}  // namespace
}  // namespace leadline::test
