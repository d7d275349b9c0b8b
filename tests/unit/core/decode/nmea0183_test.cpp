#include "core/decode/nmea0183.h"

#include <gtest/gtest.h>

#include <sstream>
#include <string>

#include "tests/support/decoder_harness.h"
#include "tests/support/files.h"

namespace leadline::decode {
namespace {

using test::Decoded;

std::string sentence(const std::string& body) {
  unsigned sum = 0;
  for (const char c : body) sum ^= static_cast<unsigned char>(c);
  const char* const hex = "0123456789ABCDEF";
  return "$" + body + "*" + hex[sum >> 4] + hex[sum & 15] + "\r\n";
}

const Time kNoon = *parse_iso8601("2026-11-22T12:35:00Z");

/// Names of unknown sentences live in their decoder, so it outlives what it reported.
Decoder& kept_decoder(const DecoderSettings& settings) {
  static std::vector<std::unique_ptr<Decoder>> kept;
  return *kept.emplace_back(make_nmea0183(settings));
}

Decoded decode(const std::string& text, const DecoderSettings& settings = {},
               std::optional<Arrival> arrival = arrival_at(kNoon)) {
  return test::decode_all(kept_decoder(settings), test::as_bytes(text), arrival);
}

template <class T>
T only(const std::string& text, const DecoderSettings& settings = {}) {
  const auto found = decode(text, settings).all<T>();
  EXPECT_EQ(found.size(), 1u) << text;
  return found.empty() ? T{} : found[0];
}

template <class T>
std::optional<Time> time_of(const std::string& text) {
  const Decoded all = decode(text);
  const auto* fact = all.first<T>();
  EXPECT_NE(fact, nullptr) << text;
  return fact ? fact->device_time : std::nullopt;
}

std::string refusal(const std::string& text, const DecoderSettings& settings = {}) {
  const Decoded all = decode(text, settings);
  EXPECT_EQ(all.frames.size(), 1u) << text;
  if (all.frames.empty() || all.frames[0].byte_class != ByteClass::refused) return "not refused";
  EXPECT_TRUE(all.facts.empty()) << text;
  return std::string(all.frames[0].reason);
}

bool decoded_without_fact(const std::string& text) {
  const Decoded all = decode(text);
  return all.facts.empty() && all.frames.size() == 1 && all.frames[0].byte_class == ByteClass::decoded;
}

constexpr double kKnot = 1852.0 / 3600.0;

TEST(Nmea0183Gga, HoldsPositionHeightAndQuality) {
  const auto fix =
      only<GnssFix>("$GPGGA,123519.50,5912.34567,N,00512.34567,E,4,14,0.7,41.20,M,44.10,M,1.2,0123*71\r\n");
  EXPECT_NEAR(fix.position.lat.deg(), 59.2057612, 1e-7);
  EXPECT_NEAR(fix.position.lon.deg(), 5.2057612, 1e-7);
  EXPECT_NEAR(fix.height->m, 85.30, 1e-9);
  EXPECT_EQ(fix.quality, GnssQuality::rtk_fixed);
  EXPECT_EQ(fix.satellites, 14);
  EXPECT_EQ(fix.hdop, 0.7);
  EXPECT_FALSE(fix.sd_north_m);
}

TEST(Nmea0183Gga, TakesTheDayFromTheArrival) {
  EXPECT_EQ(time_of<GnssFix>(
                "$GPGGA,123519.50,5912.34567,N,00512.34567,E,4,14,0.7,41.20,M,44.10,M,1.2,0123*71\r\n"),
            parse_iso8601("2026-11-22T12:35:19.5Z"));
}

TEST(Nmea0183Gga, WestAndSouthAreNegative) {
  const auto fix =
      only<GnssFix>("$GNGGA,001043.00,4404.14036,N,12118.85961,W,1,12,0.98,1113.0,M,-21.3,M,,*47\r\n");
  EXPECT_NEAR(fix.position.lat.deg(), 44.0690060, 1e-7);
  EXPECT_NEAR(fix.position.lon.deg(), -121.3143268, 1e-7);
  EXPECT_NEAR(fix.height->m, 1091.7, 1e-9);
  EXPECT_LT(only<GnssFix>(sentence("GPGGA,001043,0130.0,S,00130.0,W,1,,,,M,,M,,")).position.lat.deg(), 0.0);
}

TEST(Nmea0183Gga, WithoutFixHasNoFact) {
  EXPECT_TRUE(decoded_without_fact("$GPGGA,123520.00,,,,,0,00,99.99,,M,,M,,*61\r\n"));
  EXPECT_TRUE(decoded_without_fact(sentence("GPGGA,123520.00,0000.0,N,00000.0,E,0,00,99.99,,M,,M,,")));
  EXPECT_TRUE(
      decoded_without_fact(sentence("GPGGA,235946.005,8960.000000,N,00000.0,E,0,0,,137.0,M,13.0,M,,")))
      << "placeholders of a sentence that calls itself invalid are not judged";
  for (const char* quality : {"6", "7", "8", ""})
    EXPECT_TRUE(decoded_without_fact(
        sentence(std::string("GPGGA,123520,5912.3,N,00512.3,E,") + quality + ",10,1.0,1.0,M,1.0,M,,")))
        << quality;
}

TEST(Nmea0183Gga, HeightNeedsAltitudeAndSeparation) {
  EXPECT_FALSE(only<GnssFix>(sentence("GPGGA,123520,5912.3,N,00512.3,E,1,10,99.99,1.0,M,,M,,")).height);
  EXPECT_FALSE(only<GnssFix>(sentence("GPGGA,123520,5912.3,N,00512.3,E,1,10,99.99,,M,1.0,M,,")).height);
  EXPECT_FALSE(only<GnssFix>(sentence("GPGGA,123520,5912.3,N,00512.3,E,1,10,99.99,1.0,M,,M,,")).hdop);
}

TEST(Nmea0183Rmc, HoldsPositionSpeedCourseAndClock) {
  const std::string text = "$GNRMC,123519.50,A,3348.1234,S,15112.5678,E,4.20,271.4,221126,11.5,E,D,S*41\r\n";
  const auto fix = only<GnssFix>(text);
  EXPECT_NEAR(fix.position.lat.deg(), -33.8020567, 1e-7);
  EXPECT_NEAR(fix.position.lon.deg(), 151.2094633, 1e-7);
  EXPECT_EQ(fix.quality, GnssQuality::differential);
  const auto course = only<Course>(text);
  EXPECT_NEAR(course.speed_mps, 2.161, 5e-4);
  EXPECT_NEAR(course.course->deg(), 271.4, 1e-9);
  const Time expected = *parse_iso8601("2026-11-22T12:35:19.5Z");
  EXPECT_EQ(only<ClockReading>(text).device_ns, expected.ns);
  EXPECT_EQ(only<ClockReading>(text).telegram.view(), "RMC");
  EXPECT_EQ(time_of<Course>(text), expected);
}

TEST(Nmea0183Rmc, CourseIsEmptyAtRest) {
  const auto course = only<Course>("$GNRMC,001031.00,A,4404.13993,N,12118.86023,W,0.146,,100117,,,A*7B\r\n");
  EXPECT_FALSE(course.course);
  EXPECT_NEAR(course.speed_mps, 0.146 * kKnot, 1e-12);
}

TEST(Nmea0183Rmc, InvalidStatusAndModesMakeNoFact) {
  EXPECT_TRUE(decoded_without_fact(sentence("GPRMC,123519,V,5912.3,N,00512.3,E,4.2,271.4,221126,,,A")));
  EXPECT_TRUE(decoded_without_fact(sentence("GPRMC,235946.005,V,8960.0,N,00000.0,E,0.0,0.0,050180,,,N")));
  for (const char* mode : {"E", "M", "S", "N"})
    EXPECT_TRUE(decoded_without_fact(
        sentence(std::string("GPRMC,123519,A,5912.3,N,00512.3,E,4.2,271.4,221126,,,") + mode)))
        << mode;
}

TEST(Nmea0183Gll, GivesAFixWithAndWithoutTime) {
  EXPECT_EQ(time_of<GnssFix>("$GPGLL,5912.3457,N,00512.3457,E,123519.50,A,D*6D\r\n"),
            parse_iso8601("2026-11-22T12:35:19.5Z"));
  EXPECT_EQ(time_of<GnssFix>(sentence("GPGLL,2200.097,S,01756.346,W")), std::nullopt);
  EXPECT_TRUE(decoded_without_fact(sentence("GPGLL,5912.3457,N,00512.3457,E,123519.50,V,N")));
}

TEST(Nmea0183Gns, TakesTheBestSystemAndRefusesNone) {
  EXPECT_EQ(only<GnssFix>(sentence("GNGNS,123519,5912.3,N,00512.3,E,ADN,14,0.7,41.2,44.1,,")).quality,
            GnssQuality::differential);
  EXPECT_NEAR(only<GnssFix>(sentence("GNGNS,123519,5912.3,N,00512.3,E,RAN,14,0.7,41.2,44.1,,")).height->m,
              85.3, 1e-9);
  EXPECT_TRUE(decoded_without_fact(sentence("GNGNS,123519,5912.3,N,00512.3,E,NNN,00,,,,,")));
  EXPECT_TRUE(decoded_without_fact(sentence("GNGNS,123519,5912.3,N,00512.3,E,ENN,00,,,,,")));
}

TEST(Nmea0183Fixes, OneAnEpochAndTheBestKindSpeaks) {
  const std::string gga = sentence("GPGGA,123519,5912.3,N,00512.3,E,1,10,1.0,1.0,M,1.0,M,,");
  const std::string rmc = sentence("GPRMC,123519,A,5912.3,N,00512.3,E,4.2,271.4,221126,,,A");
  const std::string gll = sentence("GPGLL,5912.3,N,00512.3,E,123519,A,A");
  const std::string gns = sentence("GNGNS,123519,5912.3,N,00512.3,E,AN,14,0.7,41.2,44.1,,");
  EXPECT_EQ(decode(gga + rmc + gll + gns).all<GnssFix>().size(), 1u);
  EXPECT_EQ(decode(rmc + gga).all<GnssFix>().size(), 1u)
      << "the first epoch: RMC came first, its UTC is given";
  EXPECT_EQ(decode(rmc + gga).all<Course>().size(), 1u);
  EXPECT_EQ(
      decode(gga + sentence("GLGGA,123519,5912.3,N,00512.3,E,1,10,1.0,1.0,M,1.0,M,,")).all<GnssFix>().size(),
      1u);
  EXPECT_EQ(decode(gga + rmc).all<ClockReading>().size(), 2u);
}

TEST(Nmea0183Fixes, ALowerKindSpeaksAgainAfterFiveSeconds) {
  const auto decoder = make_nmea0183({});
  Decoded out;
  const auto feed = [&](const std::string& text, double s) {
    decoder->feed(test::as_bytes(text), arrival_at(kNoon + duration(s)), out);
  };
  feed(sentence("GPGGA,123500,5912.3,N,00512.3,E,1,10,1.0,1.0,M,1.0,M,,"), 0.0);
  feed(sentence("GPRMC,123505,A,5912.3,N,00512.3,E,4.2,271.4,221126,,,A"), 5.0);
  EXPECT_EQ(out.all<GnssFix>().size(), 1u);
  feed(sentence("GPRMC,123506,A,5912.3,N,00512.3,E,4.2,271.4,221126,,,A"), 5.1);
  EXPECT_EQ(out.all<GnssFix>().size(), 2u);
}

TEST(Nmea0183Gst, SigmasGoToTheFixOfItsUtcAndToYoungOnes) {
  const std::string gst = "$GPGST,123519.50,0.012,0.009,0.007,41.2,0.008,0.008,0.015*61\r\n";
  const auto fix =
      decode(gst + sentence("GPGGA,123520.5,5912.3,N,00512.3,E,4,14,0.7,,M,,M,,")).all<GnssFix>().at(0);
  EXPECT_EQ(fix.sd_north_m, 0.008);
  EXPECT_EQ(fix.sd_east_m, 0.008);
  EXPECT_EQ(fix.sd_down_m, 0.015);
  EXPECT_TRUE(decoded_without_fact(gst));

  const DecoderSettings dated{
      .checksum_required = true, .heading_magnetic = false, .date = kNoon, .address = {}};
  const auto late = decode(gst + sentence("GPGGA,123524.6,5912.3,N,00512.3,E,4,14,0.7,,M,,M,,"), dated, {});
  EXPECT_FALSE(late.all<GnssFix>().at(0).sd_north_m) << "5.1 s old";
}

TEST(Nmea0183Gst, SemiAxesStandInAndNonPositiveSigmasAreNone) {
  const std::string gga = sentence("GPGGA,123519.50,5912.3,N,00512.3,E,4,14,0.7,,M,,M,,");
  const auto axes = decode(sentence("GPGST,123519.50,,0.9,0.7,41.2,,,1.5") + gga).all<GnssFix>().at(0);
  EXPECT_EQ(axes.sd_north_m, 0.9);
  EXPECT_EQ(axes.sd_east_m, 0.9);
  const auto none = decode(sentence("GPGST,123519.50,,,,,0.0,-1.0,0") + gga).all<GnssFix>().at(0);
  EXPECT_FALSE(none.sd_north_m || none.sd_east_m || none.sd_down_m);
}

TEST(Nmea0183Vtg, BothFormsAndTheUnitThatIsThere) {
  for (const char* text :
       {"$GPVTG,271.4,T,259.9,M,4.20,N,7.78,K,D*2F\r\n", "$GPVTG,271.4,259.9,4.20,7.78*5B\r\n"}) {
    const auto course = only<Course>(text);
    EXPECT_NEAR(course.speed_mps, 4.20 * kKnot, 1e-12) << text;
    EXPECT_NEAR(course.course->deg(), 271.4, 1e-9) << text;
    EXPECT_EQ(time_of<Course>(text), std::nullopt);
  }
  EXPECT_NEAR(only<Course>(sentence("GPVTG,,T,,M,,N,7.2,K")).speed_mps, 2.0, 1e-12);
  EXPECT_TRUE(decoded_without_fact(sentence("GPVTG,,,,,,,,,N")));
  EXPECT_TRUE(decoded_without_fact(sentence("GPVTG,1.0,T,,M,1.0,N,1.0,K,N")));
}

TEST(Nmea0183Vtg, SilencesTheCourseOfRmc) {
  const auto all = decode(sentence("GPVTG,271.4,T,259.9,M,4.20,N,7.78,K,D") +
                          sentence("GPRMC,123519,A,5912.3,N,00512.3,E,4.2,271.4,221126,,,A"));
  EXPECT_EQ(all.all<Course>().size(), 1u);
  EXPECT_EQ(all.all<GnssFix>().size(), 1u);
}

TEST(Nmea0183Zda, ReadsTheClock) {
  for (const char* text :
       {"$GPZDA,123519.50,22,11,2026,00,00*68\r\n", "$GPZDA,123519.50,22,11,2026,,*68\r\n"})
    EXPECT_EQ(only<ClockReading>(text).device_ns, parse_iso8601("2026-11-22T12:35:19.5Z")->ns) << text;
  EXPECT_EQ(only<ClockReading>("$GPZDA,160012.71,11,03,2004,-1,00*7D\r\n").device_ns,
            parse_iso8601("2004-03-11T16:00:12.71Z")->ns);
  EXPECT_TRUE(decoded_without_fact(sentence("GPZDA,,,,,,")));
  EXPECT_EQ(refusal(sentence("GPZDA,123519,30,02,2026,,")), "range");
  EXPECT_EQ(refusal(sentence("GPZDA,123519,22,11,26,,")), "fields");
}

TEST(Nmea0183Heading, TrueMagneticAndInvalid) {
  EXPECT_NEAR(only<Heading>("$HEHDT,001.7,T*29\r\n").heading.deg(), 1.7, 1e-12);
  EXPECT_NEAR(only<Heading>("$GPHDT,274.07,T*03\r\n").heading.deg(), 274.07, 1e-12);
  EXPECT_NEAR(only<Heading>("$HETHS,096.0,A*22\r\n").heading.deg(), 96.0, 1e-12);
  EXPECT_EQ(only<Heading>("$HEHDT,001.7,T*29\r\n").reference, HeadingReference::true_north);
  EXPECT_TRUE(decoded_without_fact("$HETHS,,V*14\r\n"));
  EXPECT_TRUE(decoded_without_fact(sentence("HETHS,096.0,V")));
  EXPECT_TRUE(decoded_without_fact(sentence("HEHDT,,T")));
  EXPECT_NEAR(only<Heading>("$HCHDM,103.1,M*2A\r\n").heading.deg(), 103.1, 1e-12);
  EXPECT_EQ(only<Heading>("$HCHDM,103.1,M*2A\r\n").reference, HeadingReference::magnetic_north);
  DecoderSettings magnetic;
  magnetic.heading_magnetic = true;
  EXPECT_EQ(only<Heading>("$HEHDT,001.7,T*29\r\n", magnetic).reference, HeadingReference::magnetic_north);
}

TEST(Nmea0183Heading, ZeroTo360AndNoFurther) {
  EXPECT_EQ(only<Heading>(sentence("HEHDT,360.0,T")).heading.rad(), 0.0);
  EXPECT_EQ(refusal(sentence("HEHDT,360.1,T")), "range");
  EXPECT_EQ(refusal(sentence("HEHDT,-0.1,T")), "range");
  EXPECT_EQ(refusal(sentence("HEHDT,nan,T")), "fields");
}

TEST(Nmea0183Hdg, DeviationAndVariationAreEastPositive) {
  const auto east = only<Heading>("$HCHDG,101.1,2.0,E,7.1,W*55\r\n");
  EXPECT_NEAR(east.heading.deg(), 103.1, 1e-9);
  EXPECT_NEAR((east.heading + *east.variation).deg(), 96.0, 1e-9);
  EXPECT_EQ(east.reference, HeadingReference::magnetic_north);
  const auto unknown = only<Heading>("$SDHDG,234.6,,,1.3,E*34\r\n");
  EXPECT_NEAR((unknown.heading + *unknown.variation).deg(), 235.9, 1e-9);
  EXPECT_NEAR(only<Heading>(sentence("24HDG,1.0,2.0,W,,")).heading.deg(), 359.0, 1e-9);
  EXPECT_FALSE(only<Heading>(sentence("24HDG,1.0,2.0,W,,")).variation);
}

TEST(Nmea0183Rot, DegreesAMinuteToRadiansASecond) {
  EXPECT_NEAR(only<Rates>("$HEROT,-012.5,A*00\r\n").rate_z_rps * kDegPerRad, -0.2083333, 1e-7);
  EXPECT_NEAR(only<Rates>("$HEROT,+000.05,A*35\r\n").rate_z_rps * kDegPerRad, 0.05 / 60.0, 1e-12);
  EXPECT_TRUE(decoded_without_fact(sentence("HEROT,1.0,V")));
}

TEST(Nmea0183Depth, MetresThenFeetThenFathoms) {
  EXPECT_EQ(only<BottomDepth>("$SDDBT,32.8,f,10.0,M,5.5,F*0E\r\n").depth_m, 10.0);
  EXPECT_EQ(only<BottomDepth>("$SDDBT,,f,22.5,M,,F*33\r\n").depth_m, 22.5);
  EXPECT_EQ(only<BottomDepth>("$SDDBT,7.8,f,2.4,M,1.3,F*0D\r\n").depth_m, 2.4);
  EXPECT_NEAR(only<BottomDepth>(sentence("SDDBT,10,f,,M,,F")).depth_m, 3.048, 1e-12);
  EXPECT_NEAR(only<BottomDepth>(sentence("SDDBT,,f,,M,10,F")).depth_m, 18.288, 1e-12);
  EXPECT_TRUE(decoded_without_fact(sentence("SDDBT,,f,,M,,F")));
}

TEST(Nmea0183Depth, TheSignOfTheOffsetSaysBelowWhat) {
  using Below = BottomDepth::Below;
  const auto surface = only<BottomDepth>("$SDDPT,10.0,1.5,200.0*62\r\n");
  EXPECT_EQ(surface.depth_m, 11.5);
  EXPECT_EQ(surface.below, Below::surface);
  const auto keel = only<BottomDepth>("$SDDPT,10.0,-2.3*4A\r\n");
  EXPECT_NEAR(keel.depth_m, 7.7, 1e-12);
  EXPECT_EQ(keel.below, Below::keel);
  EXPECT_EQ(only<BottomDepth>("$INDPT,2.3,0.0*46\r\n").below, Below::transducer);
  EXPECT_EQ(only<BottomDepth>(sentence("SDDPT,2.3,")).below, Below::transducer);
  EXPECT_TRUE(decoded_without_fact(sentence("SDDPT,,1.5")));
  EXPECT_EQ(refusal(sentence("SDDPT,1.0,-2.3")), "range");
}

TEST(Nmea0183Vbw, EachBlockHasItsOwnStatus) {
  const auto both = decode("$VDVBW,2.10,-0.30,A,2.05,-0.25,A,0.10,V,0.12,A*44\r\n").all<DvlVelocity>();
  ASSERT_EQ(both.size(), 2u);
  EXPECT_EQ(both[0].reference, DvlReference::bottom);
  EXPECT_EQ(both[0].frame, DvlFrame::ship);
  EXPECT_TRUE(both[0].valid && both[0].tilt_applied);
  EXPECT_NEAR(both[0].x_mps, 1.0546, 5e-5);
  EXPECT_NEAR(both[0].y_mps, -0.1286, 5e-5);
  EXPECT_EQ(both[1].reference, DvlReference::water);
  EXPECT_NEAR(both[1].x_mps, 2.10 * kKnot, 1e-12);
  const auto lost = decode(sentence("VDVBW,,,,2.05,-0.25,V")).all<DvlVelocity>();
  ASSERT_EQ(lost.size(), 1u) << "no water block, and a ground block without lock";
  EXPECT_FALSE(lost[0].valid);
}

TEST(Nmea0183Vlw, IsDecodedWithoutAFact) {
  EXPECT_TRUE(decoded_without_fact("$VDVLW,1234.5,N,12.3,N,1200.1,N,12.1,N*5E\r\n"));
}

TEST(Nmea0183Xdr, AttitudeNeedsRollAndPitch) {
  const auto attitude = only<Attitude>("$IIXDR,A,-2.3,D,PTCH,A,1.4,D,ROLL*75\r\n");
  EXPECT_NEAR(attitude.pitch.deg(), -2.3, 1e-12);
  EXPECT_NEAR(attitude.roll.deg(), 1.4, 1e-12);
  EXPECT_TRUE(decoded_without_fact("$IIXDR,C,8.25,C,WTEMP,P,1.01325,B,BARO,C,,C,AIRTEMP*74\r\n"));
  EXPECT_TRUE(decoded_without_fact(sentence("IIXDR,A,-2.3,D,PTCH,A,1.4,D")));
  EXPECT_TRUE(
      decoded_without_fact("$HCXDR,A,171,D,PITCH,A,-37,D,ROLL,G,367,,MAGX,G,2420,,MAGY,G,-8984,,MAGZ*41\r\n"))
      << "tenths of a degree, which no pitch of 171 degrees may become";
}

TEST(Nmea0183Xdr, HalvesInSentencesOfTheirOwnMakeOneAttitude) {
  const std::string pitch = "$APXDR,A,0.135,D,PTCH*7C\r\n", roll = "$APXDR,A,3.861,D,ROLL*65\r\n";
  const auto attitude = only<Attitude>(pitch + roll);
  EXPECT_NEAR(attitude.pitch.deg(), 0.135, 1e-12);
  EXPECT_NEAR(attitude.roll.deg(), 3.861, 1e-12);
  EXPECT_EQ(decode(pitch + roll + roll).all<Attitude>().size(), 1u) << "no half is used twice";

  const auto decoder = make_nmea0183({});
  Decoded out;
  decoder->feed(test::as_bytes(pitch), arrival_at(kNoon), out);
  decoder->feed(test::as_bytes(roll), arrival_at(kNoon + duration(1.1)), out);
  EXPECT_TRUE(out.facts.empty()) << "1.1 s apart";
  decoder->feed(test::as_bytes(pitch), arrival_at(kNoon + duration(1.2)), out);
  EXPECT_EQ(out.all<Attitude>().size(), 1u);
}

TEST(Nmea0183Pashr, AttitudeFormGivesHeadingAttitudeAndHeave) {
  const std::string text = "$PASHR,123519.500,096.03,T,+01.40,-02.30,+00.12,0.020,0.020,0.050,2,1*08\r\n";
  const auto attitude = only<Attitude>(text);
  EXPECT_NEAR(attitude.roll.deg(), 1.40, 1e-12);
  EXPECT_NEAR(attitude.pitch.deg(), -2.30, 1e-12);
  EXPECT_EQ(attitude.heave_up_m, 0.12);
  EXPECT_NEAR(attitude.sd_roll->deg(), 0.020, 1e-12);
  EXPECT_NEAR(attitude.sd_pitch->deg(), 0.020, 1e-12);
  EXPECT_NEAR(only<Heading>(text).heading.deg(), 96.03, 1e-12);
  EXPECT_NEAR(only<Heading>(text).sd->deg(), 0.050, 1e-12);
  EXPECT_EQ(time_of<Attitude>(text), parse_iso8601("2026-11-22T12:35:19.5Z"));
  EXPECT_NEAR(only<Heading>("$PASHR,085335.000,224.19,T,-01.26,+00.83,+00.00,0.101,0.113,0.267,1,0*06\r\n")
                  .heading.deg(),
              224.19, 1e-9);
  EXPECT_EQ(decode(sentence("PASHR,POS,0,07,012345.00")).frames.at(0).byte_class, ByteClass::unused);
}

TEST(Nmea0183Prdid, PitchComesBeforeRoll) {
  for (const auto& [text, pitch, roll, heading] :
       {std::tuple{"$PRDID,-2.30,1.40,96.03*6C\r\n", -2.30, 1.40, 96.03},
        std::tuple{"$PRDID,-1.31,7.81,47.31*68\r\n", -1.31, 7.81, 47.31}}) {
    EXPECT_NEAR(only<Attitude>(text).pitch.deg(), pitch, 1e-12);
    EXPECT_NEAR(only<Attitude>(text).roll.deg(), roll, 1e-12);
    EXPECT_NEAR(only<Heading>(text).heading.deg(), heading, 1e-12);
  }
  EXPECT_EQ(refusal(sentence("PRDID,-2.30,1.40,96.03,")), "fields");
  EXPECT_EQ(refusal(sentence("PRDID,-2.30,1.40,x")), "fields");
}

TEST(Nmea0183Psxn, QualitySuppressesWhatItCallsInvalid) {
  const std::string attitude = "$PSXN,23,0.35,-1.74,218.26,0.58*13\r\n";
  const auto good = decode("$PSXN,20,1,0,0,0*3A\r\n$PSXN,22,0.03,-0.80*1F\r\n" + attitude);
  EXPECT_NEAR(good.all<Attitude>().at(0).roll.deg(), 0.35, 1e-12);
  EXPECT_NEAR(good.all<Attitude>().at(0).pitch.deg(), -1.74, 1e-12);
  EXPECT_EQ(good.all<Attitude>().at(0).heave_up_m, -0.58) << "the Seapath's heave is positive down";
  EXPECT_NEAR(good.all<Heading>().at(0).heading.deg(), 218.26, 1e-12);
  ASSERT_EQ(good.frames.size(), 3u);
  EXPECT_EQ(good.frames[0].kind, "PSXN20");
  EXPECT_EQ(good.frames[1].kind, "PSXN22");
  EXPECT_EQ(good.frames[2].kind, "PSXN23");
  const auto no_heading = decode(sentence("PSXN,20,0,0,2,0") + attitude);
  EXPECT_TRUE(no_heading.all<Heading>().empty());
  EXPECT_EQ(no_heading.all<Attitude>().size(), 1u);
  const auto no_tilt = decode(sentence("PSXN,20,0,0,1,2") + attitude);
  EXPECT_EQ(no_tilt.all<Heading>().size(), 1u);
  EXPECT_TRUE(no_tilt.all<Attitude>().empty());
}

TEST(Nmea0183Puhaw, ShipVelocityThroughTheWater) {
  DecoderSettings optional;
  optional.checksum_required = false;
  const auto v = only<DvlVelocity>("$PUHAW,UVH,-4.87,-6.04,219.2\r\n", optional);
  EXPECT_EQ(v.reference, DvlReference::water);
  EXPECT_EQ(v.frame, DvlFrame::earth);
  EXPECT_TRUE(v.valid && v.tilt_applied);
  EXPECT_NEAR(v.x_mps, -6.04 * kKnot, 1e-12);
  EXPECT_NEAR(v.y_mps, -4.87 * kKnot, 1e-12);
  EXPECT_NEAR(v.applied->heading.deg(), 219.2, 1e-9);
  EXPECT_NEAR(only<Heading>("$PUHAW,UVH,-4.87,-6.04,219.2\r\n", optional).heading.deg(), 219.2, 1e-9);
}

TEST(Nmea0183Psimssb, HeadUpIsForwardThenStarboard) {
  const std::string text = "$PSIMSSB,123519.50,B07,A,,C,H,M,12.50,-30.25,118.40,0.60,T,0.082400,*40\r\n";
  const auto p = only<UsblRelative>(text);
  EXPECT_EQ(p.transponder.view(), "B07");
  EXPECT_EQ(p.axes, UsblAxes::head_up);
  EXPECT_EQ(p.x_m, -30.25);
  EXPECT_EQ(p.y_m, 12.50);
  EXPECT_EQ(p.down_m, 118.40);
  EXPECT_EQ(p.sd_m, 0.60);
  EXPECT_EQ(time_of<UsblRelative>(text), parse_iso8601("2026-11-22T12:35:19.5Z"));
}

TEST(Nmea0183Psimssb, NorthUpInBothOrders) {
  const auto north =
      only<UsblRelative>("$PSIMSSB,180554.432,M44,A,,C,N,M,-61.300,39.017,34.026,0.072,T,0.050576,*47\r\n");
  EXPECT_EQ(north.axes, UsblAxes::north_up);
  EXPECT_EQ(north.x_m, -61.300);
  EXPECT_EQ(north.y_m, 39.017);
  const auto east =
      only<UsblRelative>(sentence("PSIMSSB,180554.432,M44,A,,C,E,M,39.017,-61.300,34.026,0.0,N,,"));
  EXPECT_EQ(east.x_m, -61.300);
  EXPECT_EQ(east.y_m, 39.017);
  EXPECT_FALSE(east.sd_m) << "0.0 is no accuracy";
}

TEST(Nmea0183Psimssb, RadiansAndGrid) {
  const auto place = only<UsblGeographic>(
      "$PSIMSSB,123519.50,B07,A,,R,G,M,1.0332345678,0.0908712345,118.40,0.60,N,,*74\r\n");
  EXPECT_EQ(place.position.lat.rad(), 1.0332345678);
  EXPECT_EQ(place.position.lon.rad(), 0.0908712345);
  EXPECT_EQ(place.depth->m, 118.40);
  const auto grid =
      only<UsblGrid>(sentence("PSIMSSB,123519.50,B07,A,,U,N,M,6562000.5,511000.25,118.40,0.60,N,,"));
  EXPECT_EQ(grid.northing_m, 6562000.5);
  EXPECT_EQ(grid.easting_m, 511000.25);
  const auto tritech =
      only<UsblGrid>(sentence("PSIMSSB,123519.50,B07,A,,U,E,M,511000.25,6562000.5,118.40,,N,,"));
  EXPECT_EQ(tritech.northing_m, 6562000.5);
  EXPECT_EQ(refusal(sentence("PSIMSSB,123519.50,B07,A,,R,G,M,59.2,5.2,118.40,0.60,N,,")), "range");
}

TEST(Nmea0183Psimssb, OnlyMeasuredSoundAndUnmarkedPlacesAreFacts) {
  EXPECT_TRUE(decoded_without_fact(
      "$PSIMSSB,083733.036,M17,A,NRy,C,N,F,0.000,0.000,0.000,20.000,T,0.003731,*08\r\n"));
  EXPECT_TRUE(decoded_without_fact("$PSIMSSB,123520.50,B07,V,NRy,C,H,P,,,,,N,,*0A\r\n"));
  for (const char* middle : {"V,,C,N,M", "A,NRy,C,N,M", "A,,C,N,F", "A,,C,N,P", "A,,C,N,R", "A,,P,H,M"})
    EXPECT_TRUE(decoded_without_fact(
        sentence(std::string("PSIMSSB,123519.50,B07,") + middle + ",1.0,2.0,3.0,0.6,N,,")))
        << middle;
}

TEST(Nmea0183Psimssb, AnAddressChoosesTheTransponder) {
  DecoderSettings settings;
  settings.address = "B08";
  const auto other =
      decode("$PSIMSSB,123519.50,B07,A,,C,H,M,12.50,-30.25,118.40,0.60,T,0.082400,*40\r\n", settings);
  EXPECT_TRUE(other.facts.empty());
  EXPECT_EQ(other.frames.at(0).byte_class, ByteClass::unused);
  EXPECT_EQ(other.frames.at(0).kind, "PSIMSSB");
}

TEST(Nmea0183Ptsax, ForwardStarboardAndTheDepthThatHolds) {
  const auto p =
      only<UsblRelative>("$PTSAX,#16069,124544.449,18,12,2017,1,17.95,-25.58,F,1013.10,1,9999.00*27\r\n");
  EXPECT_EQ(p.transponder.view(), "1");
  EXPECT_EQ(p.axes, UsblAxes::head_up);
  EXPECT_EQ(p.x_m, 17.95);
  EXPECT_EQ(p.y_m, -25.58);
  EXPECT_EQ(p.down_m, 1013.10);
  const auto other =
      only<UsblRelative>("$PTSAX,#2383172,071216.870,05,04,2018,4,-412.45,526.85,F,0631.8,1,9999.0*23\r\n");
  EXPECT_EQ(other.x_m, -412.45);
  EXPECT_EQ(other.down_m, 631.8);
  EXPECT_EQ(
      time_of<UsblRelative>("$PTSAX,#00043,123519.500,22,11,2026,7,30.25,12.50,F,0118.40,1,9999.00*04\r\n"),
      parse_iso8601("2026-11-22T12:35:19.5Z"));
  const auto form = [](const std::string& v, const std::string& tail) {
    return sentence("PTSAX,#1,123519,22,11,2026,12,1.0,2.0," + v + "," + tail);
  };
  EXPECT_EQ(only<UsblRelative>(form("E", "10.0,2,11.0")).down_m, 11.0);
  EXPECT_EQ(only<UsblRelative>(form("7", "10.0,2,9999.0")).down_m, 10.0);
  EXPECT_FALSE(only<UsblRelative>(form("F", "10.0,0,11.0")).down_m);
  EXPECT_EQ(only<UsblRelative>(form("F", "10.0,0,11.0")).transponder.view(), "12");
  EXPECT_TRUE(decode(form("3", "10.0,1,9999")).all<UsblRelative>().empty());
  EXPECT_TRUE(decode(form("0", "10.0,1,9999")).all<UsblRelative>().empty());
  EXPECT_EQ(decode(form("0", "10.0,1,9999")).all<ClockReading>().size(), 1u);
  EXPECT_EQ(refusal(form("G", "10.0,1,9999")), "fields");
}

TEST(Nmea0183Ptsax, LegacyFormHasNoTime) {
  const std::string text = "$PTSAX,01,00100,00199,F,0301,1,9999*16\r\n";
  const auto p = only<UsblRelative>(text);
  EXPECT_EQ(p.transponder.view(), "1");
  EXPECT_EQ(p.x_m, 100.0);
  EXPECT_EQ(p.y_m, 199.0);
  EXPECT_EQ(p.down_m, 301.0);
  EXPECT_EQ(time_of<UsblRelative>(text), std::nullopt);
}

TEST(Nmea0183Ptsag, IsTheTransponderNeverTheShip) {
  const auto place = only<UsblGeographic>(
      "$PTSAG,#00042,123519.500,22,11,2026,7,5912.34567,N,00512.34567,E,F,0118.40,2,0118.20*23\r\n");
  EXPECT_EQ(place.transponder.view(), "7");
  EXPECT_NEAR(place.position.lat.deg(), 59.2057612, 1e-7);
  EXPECT_EQ(place.depth->m, 118.20);
  EXPECT_EQ(only<UsblGeographic>(
                "$PTSAG,#16068,124544.449,18,12,2017,1,4305.25355,N,00631.76852,E,F,1013.10,1,9999.00*23\r\n")
                .depth->m,
            1013.10);
  const auto ship =
      decode("$PTSAG,#2374110,055648.831,05,04,2018,0,2718.19917,N,01747.61373,W,F,0005.8,1,9999.0*39\r\n");
  EXPECT_TRUE(ship.facts.empty());
  EXPECT_EQ(ship.frames.at(0).byte_class, ByteClass::unused);
  EXPECT_EQ(decode(sentence("PTSAY,#1,123519,22,11,2026,7,1.0,2.0,F,10.0,1,9999")).frames.at(0).byte_class,
            ByteClass::unused);
}

TEST(Nmea0183, RefusesWhatIsOutOfItsRangeOrMalformed) {
  const auto rmc = [](const std::string& lat, const std::string& course) {
    return sentence("GPRMC,123519,A," + lat + ",N,00512.3,E,4.2," + course + ",221126,,,A");
  };
  EXPECT_EQ(refusal(rmc("5960.0", "1.0")), "range");
  EXPECT_EQ(refusal(rmc("9000.1", "1.0")), "range");
  EXPECT_EQ(refusal(rmc("-5912.3", "1.0")), "range");
  EXPECT_EQ(refusal(rmc("5912.3", "360.5")), "range");
  EXPECT_EQ(refusal(rmc("59x2.3", "1.0")), "fields");
  EXPECT_EQ(refusal(rmc("5912.3", "1e2")), "fields");
  EXPECT_EQ(refusal(sentence("GPRMC,243519,A,5912.3,N,00512.3,E,4.2,1.0,221126,,,A")), "range");
  EXPECT_EQ(refusal(sentence("GPRMC,123561,A,5912.3,N,00512.3,E,4.2,1.0,221126,,,A")), "range");
  EXPECT_EQ(refusal(sentence("GPRMC,123519,A,5912.3,N,00512.3,E,4.2,1.0,310226,,,A")), "range");
  EXPECT_EQ(refusal(sentence("GPRMC,123519,A,5912.3,N,00512.3,E,4.2,1.0,,,,A")), "fields");
  EXPECT_EQ(refusal(sentence("GPRMC,123519,A,5912.3,N,00512.3,E")), "fields");
  EXPECT_EQ(refusal(sentence("GPRMC,123519,A,5912.3,X,00512.3,E,4.2,1.0,221126,,,A")), "fields");
  EXPECT_EQ(refusal(sentence("GPGGA,,5912.3,N,00512.3,E,1,10,1.0,,M,,M,,")), "fields");
  EXPECT_EQ(refusal(sentence("HEHDT")), "fields");
}

TEST(Nmea0183, KnowsWhatItDoesNotUseAndNamesWhatItDoesNotKnow) {
  const auto all =
      decode(sentence("GPGSA,A,3") + sentence("PUBX,00") + sentence("PRWIZCH,00,0") + sentence("GPQQQ,1") +
             sentence("PABCD,1") + "!AIVDM,1,1,,A,13aEOK?P00PD2wVMdLDRhgvL289?,0*26\r\n");
  const std::pair<ByteClass, const char*> expected[] = {
      {ByteClass::unused, "GSA"},  {ByteClass::unused, "PUBX"},   {ByteClass::unused, "PRWIZCH"},
      {ByteClass::unknown, "QQQ"}, {ByteClass::unknown, "PABCD"}, {ByteClass::unused, "VDM"}};
  ASSERT_EQ(all.frames.size(), std::size(expected));
  for (std::size_t i = 0; i < all.frames.size(); ++i) {
    EXPECT_EQ(all.frames[i].byte_class, expected[i].first) << i;
    EXPECT_EQ(all.frames[i].kind, expected[i].second) << i;
  }
}

TEST(Nmea0183, NamesAtMost64UnknownSentences) {
  std::string text;
  for (int i = 0; i < 70; ++i) text += sentence("PZ" + std::to_string(100 + i) + ",1");
  const auto all = decode(text + sentence("PZ100,1"));
  ASSERT_EQ(all.frames.size(), 71u);
  EXPECT_EQ(all.frames[63].kind, "PZ163");
  EXPECT_EQ(all.frames[64].kind, "other");
  EXPECT_EQ(all.frames[70].kind, "PZ100");
}

TEST(Nmea0183, EveryWireSampleIsFramedAndNoneRefused) {
  const auto all = decode(test::read_text(test::data_path("wire-samples/nmea.txt")));
  ASSERT_EQ(all.frames.size(), 34u);
  EXPECT_EQ(all.ledger.checksums(ChecksumState::ok), 34u);
  EXPECT_EQ(all.ledger.frames(ByteClass::decoded), 32u);
  EXPECT_EQ(all.ledger.frames(ByteClass::unknown), 2u) << "PNORBT7 and PNORBT8 are another decoder's";
}

TEST(Nmea0183, DecodesThePublicUsblLines) {
  std::istringstream lines(test::read_text(test::data_path("usbl_psimssb_lines/lines.tsv")));
  int sentences = 0;
  for (std::string line; std::getline(lines, line);) {
    if (line.empty() || line[0] == '#') continue;
    std::istringstream columns(line);
    std::string kind, origin, licence, text, verdict;
    std::getline(columns, kind, '\t'), std::getline(columns, origin, '\t'),
        std::getline(columns, licence, '\t');
    std::getline(columns, text, '\t'), std::getline(columns, verdict, '\t');
    const auto all = decode(text + "\n");
    ASSERT_EQ(all.frames.size(), 1u) << text;
    EXPECT_EQ(all.frames[0].checksum == ChecksumState::ok, verdict == "nmea-xor ok") << text;
    EXPECT_NE(all.frames[0].byte_class, ByteClass::refused) << text;
    EXPECT_TRUE(all.all<UsblRelative>().empty()) << "all filtered or with an error: " << text;
    EXPECT_EQ(all.all<GnssFix>().size(), kind == "gps" ? 1u : 0u) << text;
    ++sentences;
  }
  EXPECT_EQ(sentences, 8);
}

}  // namespace
}  // namespace leadline::decode
