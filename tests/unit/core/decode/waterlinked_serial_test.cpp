#include "core/decode/waterlinked_serial.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <sstream>

#include "tests/support/files.h"
#include "tests/unit/core/decode/stream_laws.h"

namespace leadline::test {
namespace {

constexpr double kTiny = 1e-9;

const std::string kBottom =
    "wrz,0.850,0.120,0.030,y,11.02,0.002,4e-06;0;0;0;4e-06;0;0;0;1e-06,1795350919480000,1795350919500000,"
    "120.00,0*91\r\n";
const std::string kHot =
    "wrz,0.000,0.000,0.000,n,-1.00,2.707,0;0;0;0;0;0;0;0;0,1795350920480000,1795350920500000,980.00,1*04\r\n";
const std::string kPlace = "wrp,1795350919.500,12.41,-3.15,1.23,0.4,1.4,-2.3,96.0,0*d8\r\n";
const std::string kBeam2 = "wru,2,0.000,-1.00,-80,-96*f2\r\n";
const std::string kReal =
    "wrz,0.120,-0.400,2.000,y,1.30,1.855,1e-07;0;1.4;0;1.2;0;0.2;0;1e+09,7,14,123.00,1*50\r\n";
const std::string kOld = "wrx,112.83,0.007,0.017,0.006,0.000,0.93,y,0*d2\r\n";

Decoded decode(std::string_view text, std::optional<Arrival> arrival = kHeard,
               const DecoderSettings& settings = {}) {
  return decode_all(*decode::make_waterlinked_serial(settings), as_bytes(text), arrival);
}

/// A made line with its CRC.
std::string sealed(const std::string& text) {
  std::ostringstream line;
  line << text << '*' << std::hex << (decode::waterlinked_crc(text) >> 4)
       << (decode::waterlinked_crc(text) & 15) << "\r\n";
  return line.str();
}

TEST(WaterLinkedSerial, EverySampleHasItsDocumentedValues) {
  const Decoded bottom = decode(kBottom);
  const auto v = bottom.all<DvlVelocity>().at(0);
  EXPECT_EQ(v.reference, DvlReference::bottom);
  EXPECT_EQ(v.frame, DvlFrame::instrument);
  EXPECT_TRUE(v.valid);
  EXPECT_EQ(v.x_mps, 0.850);
  EXPECT_EQ(v.y_mps, 0.120);
  EXPECT_EQ(v.z_mps, 0.030);
  EXPECT_NEAR(*v.sd_mps, 0.002, kTiny);
  EXPECT_EQ(bottom.all<AltitudeAboveBottom>().at(0).above_bottom_m, 11.02);
  EXPECT_EQ(bottom.first<DvlVelocity>()->device_time, parse_iso8601("2026-11-22T12:35:19.480Z"));
  EXPECT_EQ(bottom.all<ClockReading>().at(0).device_ns, parse_iso8601("2026-11-22T12:35:19.500Z")->ns);

  const Decoded hot = decode(kHot);
  EXPECT_FALSE(hot.all<DvlVelocity>().at(0).valid);
  EXPECT_EQ(hot.all<AltitudeAboveBottom>().size(), 0u);
  EXPECT_EQ(hot.all<Health>().at(0).level, Health::Level::warning);

  const auto tilt = decode(kPlace).all<Attitude>().at(0);
  EXPECT_NEAR(tilt.roll.deg(), 1.4, kTiny);
  EXPECT_NEAR(tilt.pitch.deg(), -2.3, kTiny);
  EXPECT_EQ(decode(kPlace).all<Heading>().size(), 0u) << "its yaw has no north";
  EXPECT_EQ(decode(kPlace).facts[0].device_time, parse_iso8601("2026-11-22T12:35:19.500Z"));
  EXPECT_EQ(decode(kBeam2).facts.size(), 0u) << "one beam of four";

  const auto real = decode(kReal).all<DvlVelocity>().at(0);
  EXPECT_EQ(real.y_mps, -0.4);
  EXPECT_NEAR(*real.sd_mps, std::sqrt(1.2), kTiny);
  const auto old = decode(kOld).all<DvlVelocity>().at(0);
  EXPECT_EQ(old.y_mps, 0.017);
  EXPECT_FALSE(old.sd_mps) << "a figure of merit of 0 is none";
  EXPECT_EQ(decode(kOld).all<AltitudeAboveBottom>().at(0).above_bottom_m, 0.93);
  EXPECT_EQ(
      classes(decode("wru,0,0.070,1.10,-40,-95*9c\nwrp,49056.809,0.41,0.15,1.23,0.4,53.9,13.0,19.3,0*de\r")),
      "wru wrp");
}

TEST(WaterLinkedSerial, TheSampleFileHoldsTheseLines) {
  const std::string all = read_text(data_path("wire-samples/ALL.txt"));
  for (const std::string& line : {kBottom, kHot, kPlace, kBeam2})
    EXPECT_NE(all.find("WL " + line.substr(0, line.size() - 2) + "\n"), std::string::npos) << line;
}

TEST(WaterLinkedSerial, WaterTrackAndTimeAnswerAreToldApart) {
  const std::string water =
      sealed("wrs,0.120,-0.400,2.000,y,1.855,1e-07;0;1.4;0;1.2;0;0.2;0;1e+09,7,14,123.00,1");
  const auto v = decode(water).all<DvlVelocity>().at(0);
  EXPECT_EQ(v.reference, DvlReference::water);
  EXPECT_EQ(v.x_mps, 0.12);
  const Decoded unset = decode(sealed("wrs,1795350919400000,n,pool.ntp.org,8") + kBottom);
  EXPECT_EQ(classes(unset), "wrs time wrz");
  EXPECT_FALSE(unset.first<DvlVelocity>()->device_time) << "it says itself that its clock is not set";
  EXPECT_TRUE(
      decode(sealed("wrs,1,n,x,8") + sealed("wrs,1,y,x,8") + kBottom).first<DvlVelocity>()->device_time);
}

TEST(WaterLinkedSerial, AClockThatIsNotSetIsNotGoneByAndToldOnce) {
  const Decoded d = decode(kReal + kReal);
  EXPECT_FALSE(d.first<DvlVelocity>()->device_time);
  EXPECT_EQ(d.all<ClockReading>().size(), 0u);
  EXPECT_EQ(d.all<Health>().size(), 2u) << "the clock and the heat, once each";
  const Decoded late = decode(kBottom, Arrival{kHeard.ns + 10'000'000'000});
  EXPECT_FALSE(late.first<DvlVelocity>()->device_time);
  EXPECT_TRUE(decode(kBottom, std::nullopt).first<DvlVelocity>()->device_time) << "nothing to judge it by";
  EXPECT_FALSE(decode(kReal, std::nullopt).first<DvlVelocity>()->device_time) << "1970";
}

TEST(WaterLinkedSerial, HeatIsToldWhenItBegins) {
  EXPECT_EQ(decode(kHot + kHot).all<Health>().size(), 1u);
  EXPECT_EQ(decode(kHot + kBottom + kHot).all<Health>().size(), 2u);
}

TEST(WaterLinkedSerial, FourBeamsMakeTheRanges) {
  std::string beams;
  for (const char* each : {"0,0.070,1.10", "1,0.1,1.20", "2,0.000,-1.00", "3,0.1,1.40"})
    beams += sealed("wru," + std::string(each) + ",-40,-95");
  const Decoded d = decode(kBottom + beams);
  ASSERT_EQ(d.all<BeamRanges>().size(), 1u);
  EXPECT_EQ(d.all<BeamRanges>()[0].range_m, (std::array<double, 4>{1.10, 1.20, 0.0, 1.40}));
  EXPECT_NEAR(d.all<BeamRanges>()[0].beam_angle.deg(), 22.5, kTiny);
  EXPECT_EQ(d.first<BeamRanges>()->device_time, parse_iso8601("2026-11-22T12:35:19.480Z"));
  EXPECT_EQ(decode(beams.substr(beams.find("wru,1")) + beams).all<BeamRanges>().size(), 1u)
      << "a ping whose first beam is lost is none";
  EXPECT_EQ(decode(sealed("wrt,1.1,1.2,-1.00,1.4")).all<BeamRanges>().at(0).range_m[2], 0.0);
}

TEST(WaterLinkedSerial, WhatIsDamagedOrImpossibleIsRefused) {
  const struct {
    std::string text, expected;
  } cases[] = {
      {"wrz,0.851" + kBottom.substr(9), "wrz!x"},
      {kBottom.substr(0, 60), "line!truncated"},
      {kBottom.substr(0, 60) + "\r\n", "line!checksum absent"},
      {kBottom.substr(0, kBottom.size() - 2), "wrz"},
      {sealed("wrz,0.850,0.120,0.030,y,11.02"), "wrz!fields"},
      {sealed("wrz,nan,0.120,0.030,y,11.02,0.002,0;0;0;0;0;0;0;0;0,1,2,3,0"), "wrz!fields"},
      {sealed("wrz,99,0.120,0.030,y,11.02,0.002,0;0;0;0;0;0;0;0;0,1,2,3,0"), "wrz!range"},
      {sealed("wrz,1,0.120,0.030,y,11.02,0.002,0;0;0;0;0;0;0;0,1,2,3,0"), "wrz!fields"},
      {sealed("wrz,1,0.120,0.030,Y,11.02,0.002,0;0;0;0;0;0;0;0;0,1,2,3,0"), "wrz!fields"},
      {sealed("wrs,1,2,3,4,5"), "wrs!fields"},
      {sealed("wru,4,0.070,1.10,-40,-95"), "wru!range"},
      {sealed("wrp,1,0,0,0,0,1.4,-92.3,96.0,0"), "wrp!range"},
      {sealed("wra") + sealed("wrn") + sealed("wr?") + sealed("wr!") + sealed("wrv,2.2,2.6.1,0x1,n,10.1.1.2"),
       "-reply -reply -reply -reply -reply"},
      {sealed("wcr"), "-command"},
      {sealed("wxyz"), "?line"},
      {"hello\r\n\r\n# note\n", "?text comment comment"},
      {"\x01\x02\r\n", "line!not printable"},
      {std::string(600, 'w') + "\r\n" + kOld, "line!too long skipped wrx"},
  };
  for (const auto& c : cases) {
    const Decoded d = decode(c.text);
    EXPECT_TRUE(covers(d, c.text.size())) << c.text;
    if (c.expected == "wrz!x")
      EXPECT_EQ(classes(d), "line!checksum");
    else
      EXPECT_EQ(classes(d), c.expected) << c.text;
    const Decoded after = decode(c.text + "\r\n" + kOld);
    EXPECT_EQ(after.frames.back().kind, "wrx") << c.text;
  }
  const DecoderSettings lenient{.checksum_required = false};
  EXPECT_EQ(classes(decode("wrx,112.83,0.007,0.017,0.006,0.000,0.93,y,0\n", kHeard, lenient)), "wrx");
}

TEST(WaterLinkedSerial, ALineBehindATornOneOrRubbishIsFound) {
  const std::string text = kBottom.substr(0, 40) + "\x7e~~ wr" + kOld;
  const Decoded d = decode(text);
  EXPECT_EQ(classes(d), "skipped wrx");
  EXPECT_EQ(d.all<DvlVelocity>().size(), 1u);
  EXPECT_TRUE(covers(d, text.size()));
}

TEST(WaterLinkedSerial, EverySingleBitFlipIsRefused) {
  const std::string line = kBottom;
  for (std::size_t at = 0; at < line.size() - 2; ++at)
    for (int bit = 0; bit < 7; ++bit) {
      std::string changed = line;
      changed[at] = static_cast<char>(changed[at] ^ (1 << bit));
      if (at + 4 >= line.size() && std::tolower(changed[at]) == line[at]) continue;  // hex of either case
      ASSERT_EQ(decode(changed).all<DvlVelocity>().size(), 0u) << at << " " << bit;
    }
}

TEST(WaterLinkedSerial, ObeysTheLawsOfStreams) {
  expect_stream_laws([] { return decode::make_waterlinked_serial({}); },
                     "tail*00\r\n" + kBottom + kHot + "\n# note\r" + kPlace + kBeam2 + "\x01\r" + kOld +
                         kBottom.substr(0, 30) + kReal + kOld.substr(0, 20));
}

}  // namespace
}  // namespace leadline::test
