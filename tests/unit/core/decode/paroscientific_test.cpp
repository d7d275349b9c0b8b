#include "core/decode/paroscientific.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/decode/pressure_depth.h"
#include "tests/support/files.h"
#include "tests/unit/core/decode/stream_laws.h"

namespace leadline::test {
namespace {

constexpr double kPaPerPsi = 6894.757293168;
const decode::ProfileOptions kHpa{.paroscientific_unit = "hpa"};

Decoded decode(std::string_view text, const decode::ProfileOptions& profile = {},
               std::string_view address = {}) {
  return decode_all(*decode::make_paroscientific({.address = address}, profile), as_bytes(text), kHeard);
}

/// Lines heard at these seconds, in hPa.
Decoded timed(const std::vector<std::pair<double, std::string>>& lines) {
  const auto decoder = decode::make_paroscientific({}, kHpa);
  Decoded out;
  for (const auto& [s, text] : lines) decoder->feed(as_bytes(text + "\r\n"), kHeard + duration(s), out);
  decoder->finish(out);
  return out;
}

TEST(PressureDepth, AgreesWithUnescosCheckValue) {
  EXPECT_NEAR(decode::depth_of_pressure_m(1e8, Angle::deg(30.0)), 9712.653, 5e-4);
  EXPECT_NEAR(decode::depth_of_pressure_m(1e8, Angle::deg(-30.0)), 9712.653, 5e-4);
  // Further rows of the same table: 500 dbar and 5000 dbar at 0 and 30 degrees, 10000 at 90.
  EXPECT_NEAR(decode::depth_of_pressure_m(5e6, Angle::deg(0.0)), 496.65, 5e-3);
  EXPECT_NEAR(decode::depth_of_pressure_m(5e7, Angle::deg(30.0)), 4908.56, 5e-3);
  EXPECT_NEAR(decode::depth_of_pressure_m(1e8, Angle::deg(90.0)), 9674.23, 5e-3);
  EXPECT_EQ(decode::depth_of_pressure_m(0.0, Angle::deg(10.0)), 0.0);
}

TEST(PressureDepth, OfAKnownDensityIsTheColumnsWeight) {
  EXPECT_NEAR(decode::depth_of_pressure_m(1000.0 * 9.780318 * 10.0, Angle::deg(0.0), 1000.0), 10.0, 1e-9);
  decode::PressureDepth lake(0.0, 1000.0);
  EXPECT_NE(lake.note()->text.view().find("1000.000 kg/m3"), std::string_view::npos);
  EXPECT_FALSE(lake.note());
}

TEST(Paroscientific, TakesExactlyFourDigitsOfAddress) {
  const Decoded hpa = decode("*00011013.2471\r\n", kHpa);
  EXPECT_EQ(classes(hpa), "pressure");
  EXPECT_NEAR(hpa.all<Pressure>().at(0).gauge_pa, 101'324.71 - 101'325.0, 1e-6);
  EXPECT_NEAR(hpa.all<DepthMeasured>().at(0).depth.m, 0.0, 1e-4);
  const Decoded psi = decode("*0001174.63512\r\n");
  EXPECT_NEAR(psi.all<Pressure>().at(0).gauge_pa, 174.63512 * kPaPerPsi - 101'325.0, 1e-6);
  EXPECT_NEAR(psi.all<DepthMeasured>().at(0).depth.m,
              decode::depth_of_pressure_m(174.63512 * kPaPerPsi - 101'325.0, Angle::deg(45.0)), 1e-9);
  const std::string all = read_text(data_path("wire-samples/ALL.txt"));
  EXPECT_NE(all.find("*00011013.2471"), std::string::npos);
  EXPECT_NE(all.find("*0001174.63512"), std::string::npos);
}

TEST(Paroscientific, EveryUnitIsTheSamePressure) {
  const struct {
    const char *unit, *value;
  } cases[] = {{"psi", "29.008"}, {"hpa", "2000"},   {"mbar", "2000"},    {"bar", "2"},   {"kpa", "200"},
               {"mpa", "0.2"},    {"inhg", "59.06"}, {"mmhg", "1500.12"}, {"m", "20.394"}};
  for (const auto& c : cases) {
    const Decoded d = decode("*0001" + std::string(c.value) + "\r\n", {.paroscientific_unit = c.unit});
    ASSERT_EQ(d.all<Pressure>().size(), 1u) << c.unit;
    EXPECT_NEAR(d.all<Pressure>()[0].gauge_pa, 98'675.0, 10.0) << c.unit;
  }
}

TEST(Paroscientific, TheProfileSaysAtmosphereLatitudeAndDensity) {
  decode::ProfileOptions high = kHpa;
  high.paroscientific_atmosphere_hpa = 900.0;
  high.density_kgm3 = 1000.0;
  high.latitude_deg = 0.0;
  const Decoded d = decode("*00011878.0318\r\n", high);
  EXPECT_NEAR(d.all<DepthMeasured>().at(0).depth.m, 10.0, 1e-9);
  EXPECT_EQ(d.all<Health>().size(), 1u);
}

TEST(Paroscientific, CommandsAnswersAndOtherDevicesAreNoReadings) {
  EXPECT_EQ(classes(decode("*0100P3\r\n*0001UN=1\r\n*0001SN=101\r\n*99001013.2\r\n")),
            "-command -command -command -command");
  EXPECT_EQ(classes(decode("*00021013.2\r\n*00011013.2\r\n", kHpa, "1")), "-pressure pressure");
  EXPECT_EQ(classes(decode("*00021013.2\r\n*00011013.2\r\n", kHpa, "02")), "pressure -pressure");
  EXPECT_EQ(classes(decode("hello\r\n# note\r\n")), "?text comment");
}

TEST(Paroscientific, WhatIsDamagedOrImpossibleIsRefused) {
  const std::string good = "*00011013.2\r\n";
  const struct {
    std::string text, expected;
  } cases[] = {{"*0\r\n", "line!fields"},
               {"*000x1013\r\n", "line!fields"},
               {"*0001\r\n", "pressure!fields"},
               {"*00011013.2.4\r\n", "pressure!fields"},
               {"*00011 13.2\r\n", "pressure!fields"},
               {"*0001-9999\r\n", "pressure!range"},
               {"*00019999999\r\n", "pressure!range"},
               {"*00011013.2", "line!truncated"},
               {"*0001\x01\r\n", "line!not printable"},
               {std::string(200, '*') + "\r\n", "line!too long skipped"}};
  for (const auto& c : cases) {
    const Decoded d = decode(c.text, kHpa);
    EXPECT_EQ(classes(d), c.expected) << c.text;
    EXPECT_EQ(d.facts.size(), 0u) << c.text;
    EXPECT_TRUE(covers(d, c.text.size()));
    EXPECT_EQ(decode(c.text + "\r\n" + good, kHpa).frames.back().byte_class, ByteClass::decoded) << c.text;
  }
  EXPECT_EQ(classes(decode("13.2*00011013.2\r\n", kHpa)), "skipped pressure");
}

TEST(Paroscientific, AJumpNoVehicleMakesIsRefusedUnlessItStays) {
  // 100 hPa are 0.99 m.
  const std::string at_10m = "*00012013.25", at_20m = "*00013013.25", at_14m = "*00012413.25";
  EXPECT_EQ(classes(timed({{0, at_10m}, {1, at_14m}})), "pressure pressure");
  EXPECT_EQ(classes(timed({{0, at_10m}, {1, at_20m}, {2, at_10m}})), "pressure pressure!rate pressure");
  EXPECT_EQ(classes(timed({{0, at_10m}, {1, at_20m}, {2, at_20m}})), "pressure pressure!rate pressure");
  EXPECT_EQ(classes(timed({{0, at_10m}, {3, at_20m}})), "pressure pressure");
  EXPECT_EQ(classes(timed({{0, at_10m}, {0, at_20m}})), "pressure pressure")
      << "at one instant there is no rate";
  EXPECT_EQ(classes(timed({{0, at_10m}, {1, "*00023013.25"}})), "pressure pressure") << "another device";
}

TEST(Paroscientific, ObeysTheLawsOfStreams) {
  expect_stream_laws(
      [] { return decode::make_paroscientific({}, kHpa); },
      "3.2471\r\n*00011013.2471\r\n*0100P3\r*0001UN=1\n\n# note\n*0001101\x02\n*00*00011013.9\r\n" +
          std::string(150, '*') + "\r\n*00021500.1\r\n*000110");
}

}  // namespace
}  // namespace leadline::test
