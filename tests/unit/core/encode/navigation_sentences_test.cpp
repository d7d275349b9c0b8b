#include "core/encode/navigation_sentences.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "core/decode/nmea0183.h"
#include "tests/support/decoder_harness.h"

namespace leadline::encode {
namespace {

using test::Decoded;

Told underway() {
  Told told;
  told.now = *parse_iso8601("2026-11-22T12:35:19.700Z");
  told.valid = *parse_iso8601("2026-11-22T12:35:19.500Z");
  Solution s;
  s.position = {Angle::deg(-33.802056723456), Angle::deg(151.209463312345)};
  s.depth = Depth{41.5};
  s.heading = Angle::deg(271.237);
  s.vel_north_mps = 0.3, s.vel_east_mps = -1.4;
  s.var_north_m2 = 4.0, s.var_east_m2 = 1.0, s.cov_north_east_m2 = 0.5, s.sd_down_m = 0.25;
  s.mode = Mode::A, s.position_source = PositionSource::gnss;
  told.solution = s;
  told.below_transducer_m = 12.34;
  told.transducer_depth_m = 42.0;
  told.rate_z_rps = -0.01;
  return told;
}

std::string said(std::string_view name, const Told& told) {
  Telegrams out;
  EXPECT_TRUE(write_sentence(name, told, out)) << name;
  return out.bytes;
}

Decoded heard(std::string_view text) {
  return test::decode_all(*decode::make_nmea0183({}), test::as_bytes(text),
                          arrival_at(*parse_iso8601("2026-11-22T12:35:19.8Z")));
}

TEST(NavigationSentences, AreReadBackByOurOwnDecoder) {
  const Told told = underway();
  const Solution& s = *told.solution;
  for (const std::string name : {"GGA", "RMC", "GLL"}) {
    const auto d = heard(said(name, told));
    ASSERT_EQ(d.all<GnssFix>().size(), 1u) << said(name, told);
    const auto fix = d.all<GnssFix>()[0];
    EXPECT_NEAR(fix.position.lat.deg(), s.position.lat.deg(), 1e-9) << name;
    EXPECT_NEAR(fix.position.lon.deg(), s.position.lon.deg(), 1e-9) << name;
    EXPECT_EQ(d.first<GnssFix>()->device_time, told.valid) << name;
    EXPECT_FALSE(fix.height) << "a solution knows no geoid";
  }
  for (const std::string name : {"RMC", "VTG"}) {
    const auto course = heard(said(name, told)).all<Course>();
    ASSERT_EQ(course.size(), 1u) << name;
    EXPECT_NEAR(course[0].speed_mps, std::hypot(0.3, 1.4), 3e-4);
    EXPECT_NEAR(course[0].course->deg(), 360.0 - std::atan2(1.4, 0.3) * kDegPerRad, 0.0051);
  }
  for (const std::string name : {"HDT", "THS"}) {
    const auto heading = heard(said(name, told)).all<Heading>();
    ASSERT_EQ(heading.size(), 1u) << name;
    EXPECT_NEAR(heading[0].heading.deg(), 271.237, 0.0051);
  }
  EXPECT_NEAR(heard(said("ROT", told)).all<Rates>()[0].rate_z_rps, -0.01, 1e-5);
  EXPECT_EQ(heard(said("ZDA", told)).all<ClockReading>()[0].device_ns, told.now.ns);
  const auto bottom = heard(said("DPT", told)).all<BottomDepth>();
  ASSERT_EQ(bottom.size(), 1u);
  EXPECT_EQ(bottom[0].below, BottomDepth::Below::surface);
  EXPECT_NEAR(bottom[0].depth_m, 54.34, 1e-9) << "the vehicle's depth and the water below it";
  const auto fix = heard(said("GST", told) + said("GGA", told)).all<GnssFix>();
  ASSERT_EQ(fix.size(), 1u);
  EXPECT_NEAR(*fix[0].sd_north_m, 2.0, 1e-9);
  EXPECT_NEAR(*fix[0].sd_east_m, 1.0, 1e-9);
  EXPECT_NEAR(*fix[0].sd_down_m, 0.25, 1e-9);
}

TEST(NavigationSentences, SayThemselvesInFull) {
  const Told told = underway();
  const std::string gga = said("GGA", told);
  EXPECT_EQ(gga.substr(0, gga.find('*')), "$INGGA,123519.500,3348.1234034,S,15112.5677987,E,1,,,,M,,M,,")
      << gga;
  EXPECT_EQ(said("HDT", told).substr(0, 16), "$INHDT,271.24,T*");
  EXPECT_EQ(said("DPT", told).substr(0, 19), "$INDPT,12.34,42.00*");
  EXPECT_EQ(said("ZDA", told).substr(0, 35), "$INZDA,123519.700,22,11,2026,00,00*");
  const std::string gst = said("GST", told);  // the roots of x^2 - 5x + 3.75 are 4.0811 and 0.9189
  EXPECT_EQ(gst.substr(0, gst.find('*')), "$INGST,123519.500,,2.020,0.959,9.2,2.000,1.000,0.250");
}

TEST(NavigationSentences, QualityIsHonest) {
  const struct {
    std::optional<Mode> mode;
    PositionSource source;
    const char *gga, *rmc, *gll, *vtg;
  } cases[] = {
      {Mode::A, PositionSource::gnss, ",E,1,", ",A,A*", ",A,A*", ",K,A*"},
      {Mode::B, PositionSource::usbl, ",E,1,", "A", ",A,A*", ",K,A*"},
      {Mode::E1, PositionSource::usbl, ",E,6,", "V", ",V,E*", ",K,E*"},
      {Mode::E0, PositionSource::usbl, ",,,,,0,", "V", ",V,N*", ",K,N*"},
      {std::nullopt, PositionSource::gnss, ",E,1,", "A", ",A,A*", ",K,A*"},
      {std::nullopt, PositionSource::none, ",E,,", "V", ",V,E*", ",K,E*"},
  };
  for (const auto& c : cases) {
    Told told = underway();
    told.solution->mode = c.mode;
    told.solution->position_source = c.source;
    EXPECT_NE(said("GGA", told).find(c.gga), std::string::npos) << said("GGA", told);
    EXPECT_NE(said("GLL", told).find(c.gll), std::string::npos) << said("GLL", told);
    EXPECT_NE(said("VTG", told).find(c.vtg), std::string::npos) << said("VTG", told);
    EXPECT_EQ(said("RMC", told)[18], c.gll[1]) << said("RMC", told);
  }
}

TEST(NavigationSentences, WhatIsUnknownIsVoidAndNeverAFact) {
  Told told;
  told.now = told.valid = *parse_iso8601("2026-11-22T12:35:19.700Z");
  for (const std::string_view name : navigation_sentences()) {
    const auto d = heard(said(name, told));
    EXPECT_EQ(d.ledger.refusals().size(), 0u) << said(name, told);
    for (const auto& fact : d.facts)
      EXPECT_TRUE(std::holds_alternative<ClockReading>(fact.message)) << said(name, told);
  }
  EXPECT_EQ(said("RMC", told).substr(0, 20), "$INRMC,123519.700,V,");
  EXPECT_NE(said("GGA", told).find(",,,,,0,"), std::string::npos);
}

TEST(NavigationSentences, CourseAtRestIsUnknown) {
  Told told = underway();
  told.solution->vel_north_mps = 0.03, told.solution->vel_east_mps = -0.03;
  const auto course = heard(said("VTG", told)).all<Course>();
  ASSERT_EQ(course.size(), 1u);
  EXPECT_FALSE(course[0].course);
  Telegrams out;
  EXPECT_FALSE(write_sentence("XYZ", told, out));
  EXPECT_EQ(out.bytes, "");
}

}  // namespace
}  // namespace leadline::encode
