#include "core/decode/valeport.h"

#include <gtest/gtest.h>

#include "core/decode/nmea0183.h"
#include "tests/support/files.h"
#include "tests/unit/core/decode/stream_laws.h"

namespace leadline::test {
namespace {

Decoded decode(std::string_view text, const decode::ProfileOptions& profile = {}, bool checksum = true) {
  return decode_all(*decode::make_valeport({.checksum_required = checksum}, profile), as_bytes(text), kHeard);
}

struct Case {
  std::string text;
  std::string expected;
  std::optional<double> depth_m, pressure_pa, sound_mps;
};

void expect(const Case& c, const Decoded& d) {
  EXPECT_EQ(classes(d), c.expected) << c.text;
  EXPECT_TRUE(covers(d, c.text.size())) << c.text;
  ASSERT_EQ(d.all<DepthMeasured>().size(), c.depth_m ? 1u : 0u) << c.text;
  ASSERT_EQ(d.all<Pressure>().size(), c.pressure_pa ? 1u : 0u) << c.text;
  ASSERT_EQ(d.all<SoundSpeed>().size(), c.sound_mps ? 1u : 0u) << c.text;
  if (c.depth_m) {
    EXPECT_NEAR(d.all<DepthMeasured>()[0].depth.m, *c.depth_m, 5e-4) << c.text;
  }
  if (c.pressure_pa) {
    EXPECT_NEAR(d.all<Pressure>()[0].gauge_pa, *c.pressure_pa, 1e-6) << c.text;
  }
  if (c.sound_mps) {
    EXPECT_NEAR(d.all<SoundSpeed>()[0].speed_mps, *c.sound_mps, 1e-9) << c.text;
  }
}

TEST(Valeport, EveryFormHasItsDocumentedValues) {
  // 10 dbar in a standard ocean at 45 degrees are 9.918 m.
  const Case cases[] = {
      {"$PVIPS2,01,45687,10.996,d,10.988,M*61\r\n", "PVIPS2", 10.988, 109'960.0, {}},
      {"$PVIPS2,01,45687,10.996,d,10.988,*2c\r\n", "PVIPS2", 10.988, 109'960.0, {}},
      {"$PVIPS2,01,45687,120.335,d,118.400,M*64\r\n", "PVIPS2", 118.4, 1'203'350.0, {}},
      {"0009.996,M\r\n", "value", 9.996, {}, {}},
      {"0010.000,d\r\n", "value", 9.9186, 100'000.0, {}},
      {"0010.000;D\n", "value", 9.9186, 100'000.0, {}},
      {"0010.000\r", "value", 9.9186, 100'000.0, {}},
      {"00/00/00, 00:00:00, 0010.0,0.0,0.00\r\n", "legacy", 9.9186, 100'000.0, {}},
      {" 10.000 21.488 1506.739\r\n", "row", 9.9186, 100'000.0, 1506.739},
      {"\t10.000\t21.488\t1506.739\r\n", "row", 9.9186, 100'000.0, 1506.739},
      {" 00.000 21.488 0000.000\r\n", "row", 0.0, 0.0, {}},
      {"# note\r\n\r\n", "comment comment", {}, {}, {}},
  };
  for (const Case& c : cases) expect(c, decode(c.text));
}

TEST(Valeport, TheProfileSaysUnitColumnsAndAtmosphere) {
  expect({"0009.996\r\n", "value", 9.996, {}, {}}, decode("0009.996\r\n", {.valeport_unit = "m"}));
  expect({"1506739\r\n", "row", {}, {}, 1506.739},
         decode("1506739\r\n", {.valeport_columns = {"sound_speed_mmps"}}));
  expect({"3.9 12.5 118.4\r\n", "row", 118.4, {}, {}},
         decode("3.9 12.5 118.4\r\n", {.valeport_columns = {"-", "-", "depth_m"}}));
  expect({"20.1325,d\r\n", "value", 9.9186, 100'000.0, {}},
         decode("20.1325,d\r\n", {.valeport_atmosphere_hpa = 1013.25}));
}

TEST(Valeport, TheFormulaIsToldOnceAndOnlyWhereItIsUsed) {
  EXPECT_EQ(decode("0010.0,d\r\n0011.0,d\r\n").all<Health>().size(), 1u);
  EXPECT_NE(decode("0010.0,d\r\n").all<Health>().at(0).text.view().find("UNESCO"), std::string_view::npos);
  EXPECT_EQ(decode("0010.0,M\r\n$PVIPS2,01,45687,10.996,d,10.988,M*61\r\n").all<Health>().size(), 0u);
}

TEST(Valeport, WhatIsDamagedOrImpossibleIsRefused) {
  const std::string good = "0009.996,M\r\n";
  const struct {
    std::string text, expected;
  } cases[] = {
      {"$PVIPS2,01,45687,10.996,d,10.989,M*61\r\n", "PVIPS2!checksum"},
      {"$PVIPS2,01,45687,10.996,d,10.988,M\r\n", "PVIPS2!checksum absent"},
      {"$PVIPS2,01,45687,10.996,x,10.988,M*7d\r\n", "PVIPS2!fields"},
      {"$PVIPS2,01,456", "PVIPS2!truncated"},
      {"$PIPS,1,2*19\r\n", "?line"},
      {"0009.996,X\r\n", "value!fields"},
      {"0009.9?6,M\r\n", "value!fields"},
      {"99999.0,d\r\n", "value!range"},
      {"nan,M\r\n", "value!fields"},
      {"1 2 3 4\r\n", "row!fields"},
      {"1 2\r\n", "row!fields"},
      {"1 2 9999\r\n", "row!range"},
      {"1 x 1500\r\n", "row!fields"},
      {"1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16 17 18\r\n", "row!fields"},
      {"0009.996,M", "line!truncated"},
      {"\x01"
       "0009.996,M\r\n",
       "line!not printable"},
      {std::string(300, '1') + "\r\n", "line!too long skipped"},
  };
  for (const auto& c : cases) {
    const Decoded d = decode(c.text);
    EXPECT_EQ(classes(d), c.expected) << c.text;
    EXPECT_EQ(d.facts.size(), 0u) << c.text;
    EXPECT_TRUE(covers(d, c.text.size())) << c.text;
    EXPECT_EQ(decode(c.text + "\r\n" + good).frames.back().byte_class, ByteClass::decoded)
        << "the next is whole: " << c.text;
  }
  EXPECT_EQ(classes(decode("$PVIPS2,01,45687,10.996,d,10.988,M\r\n", {}, false)), "PVIPS2");
}

TEST(Valeport, Nmea0183ReadsItsSentenceToo) {
  const Decoded d =
      decode_all(*decode::make_nmea0183({}), as_bytes("$PVIPS2,01,45687,120.335,d,118.400,M*64\r\n"));
  EXPECT_EQ(d.all<DepthMeasured>().at(0).depth.m, 118.4);
  EXPECT_NEAR(d.all<Pressure>().at(0).gauge_pa, 1'203'350.0, 1e-6);
  EXPECT_NE(read_text(data_path("wire-samples/nmea.txt")).find("$PVIPS2,01,45687,120.335,d,118.400,M*64"),
            std::string::npos);
}

TEST(Valeport, ObeysTheLawsOfStreams) {
  expect_stream_laws(
      [] { return decode::make_valeport({}); },
      "996,M\r\n0009.996,M\r\n\r10.000 21.488 1506.739\n\n\x01\x02\r00/00/00, 00:00:00, 0010.0,0.0,0.00\r\n"
      "# note\r\nxx$PVIPS2,01,45687,10.996,d,10.988,M*61\r\n" +
          std::string(300, '7') + "\r\n$PVIPS2,01,45687,10.996,d,10.988,*2c\r\n0009.9");
}

}  // namespace
}  // namespace leadline::test
