// What the profile of a source changes in its decoder.

#include "core/decode/profile.h"

#include <gtest/gtest.h>

#include "core/decode/nmea0183.h"
#include "core/decode/registry.h"
#include "core/decode/trdi_pd6.h"
#include "tests/unit/core/decode/stream_laws.h"

namespace leadline::test {
namespace {

using decode::ProfileOptions;

std::string sentence(const std::string& body) {
  unsigned sum = 0;
  for (const char c : body) sum ^= static_cast<unsigned char>(c);
  const char* const hex = "0123456789ABCDEF";
  return "$" + body + "*" + hex[sum >> 4] + hex[sum & 15] + "\r\n";
}

Decoded heard(const std::string& body, const ProfileOptions& profile) {
  return decode_all(*decode::make_nmea0183({}, profile), as_bytes(sentence(body)), kHeard);
}

TEST(Profile, EveryDecoderWithKeysIsKnownAndItsDefaultsAreLegal) {
  std::size_t with_keys = 0;
  for (const auto& decoder : decode::decoders()) {
    ProfileOptions options;
    const auto keys = decode::profile_keys(decoder.name);
    with_keys += keys.empty() ? 0 : 1;
    for (const BoundKey& key : bind(std::span<const Key<ProfileOptions>>(keys), options)) {
      EXPECT_FALSE(key.help.empty()) << key.name;
      if (const auto* const text = std::get_if<std::string*>(&key.target)) {
        EXPECT_NE(std::find(key.choices.begin(), key.choices.end(), **text), key.choices.end()) << key.name;
      }
    }
  }
  EXPECT_GE(with_keys, 5u);
  EXPECT_TRUE(decode::profile_keys("trdi-pd0").empty());
  EXPECT_TRUE(decode::profile_keys("no-such").empty());
}

TEST(Profile, UsblOrderSaysWhichCoordinateComesFirst) {
  const std::string utm_n = "PSIMSSB,123519.50,B07,A,,U,N,M,6562000.5,511000.25,118.40,0.60,N,,",
                    utm_e = "PSIMSSB,123519.50,B07,A,,U,E,M,511000.25,6562000.5,118.40,0.60,N,,",
                    swapped = "PSIMSSB,123519.50,B07,A,,U,N,M,511000.25,6562000.5,118.40,0.60,N,,",
                    radians = "PSIMSSB,123519.50,B07,A,,R,G,M,1.0332345678,0.0908712345,118.40,0.60,N,,",
                    radians_swapped =
                        "PSIMSSB,123519.50,B07,A,,R,G,M,0.0908712345,1.0332345678,118.40,0.60,N,,";
  const struct {
    const std::string& text;
    const char* order;
    bool grid;
  } cases[] = {{utm_n, "auto", true},           {utm_e, "auto", true},
               {utm_n, "northing-first", true}, {swapped, "easting-first", true},
               {radians, "auto", false},        {radians_swapped, "easting-first", false}};
  for (const auto& c : cases) {
    const Decoded d = heard(c.text, {.usbl_order = c.order});
    if (c.grid) {
      EXPECT_EQ(d.all<UsblGrid>().at(0).easting_m, 511000.25) << c.order;
      EXPECT_EQ(d.all<UsblGrid>().at(0).northing_m, 6562000.5) << c.order;
    } else {
      EXPECT_EQ(d.all<UsblGeographic>().at(0).position.lat.rad(), 1.0332345678) << c.order;
      EXPECT_EQ(d.all<UsblGeographic>().at(0).position.lon.rad(), 0.0908712345) << c.order;
    }
  }
  EXPECT_EQ(heard(utm_e, {.usbl_order = "northing-first"}).all<UsblGrid>().at(0).easting_m, 6562000.5)
      << "as the installation says, whatever the orientation";
}

TEST(Profile, FilteredFixesAndLocalClocks) {
  const std::string text = "PSIMSSB,123519.50,B07,A,,C,H,F,12.50,-30.25,118.40,0.60,N,,",
                    predicted = "PSIMSSB,123519.50,B07,A,,C,H,P,12.50,-30.25,118.40,0.60,N,,",
                    measured = "PSIMSSB,043519.50,B07,A,,C,H,M,12.50,-30.25,118.40,0.60,N,,";
  EXPECT_EQ(heard(text, {}).all<UsblRelative>().size(), 0u);
  EXPECT_EQ(heard(text, {.usbl_filtered = true}).all<UsblRelative>().size(), 1u);
  EXPECT_EQ(heard(predicted, {.usbl_filtered = true}).all<UsblRelative>().size(), 0u);
  EXPECT_TRUE(heard(measured, {}).first<UsblRelative>()->device_time);
  EXPECT_FALSE(heard(measured, {.usbl_clock = "local"}).first<UsblRelative>()->device_time);
}

TEST(Profile, HydrophonesNeededAtLeast) {
  const std::string three = "PTSAX,#00043,123519.500,22,11,2026,7,30.25,12.50,E,0118.40,1,9999.00",
                    four = "PTSAX,#00043,123519.500,22,11,2026,7,30.25,12.50,F,0118.40,1,9999.00";
  EXPECT_EQ(heard(three, {}).all<UsblRelative>().size(), 1u);
  EXPECT_EQ(heard(three, {.usbl_hydrophones = 4}).all<UsblRelative>().size(), 0u);
  EXPECT_EQ(heard(four, {.usbl_hydrophones = 4}).all<UsblRelative>().size(), 1u);
}

TEST(Profile, SignsOfPashr) {
  const std::string text = "PASHR,123519.500,096.03,T,+01.40,-02.30,+00.12,0.020,0.020,0.050,2,1";
  const auto usual = heard(text, {}).all<Attitude>().at(0);
  EXPECT_NEAR(usual.roll.deg(), 1.4, 1e-9);
  EXPECT_EQ(*usual.heave_up_m, 0.12);
  const auto other = heard(text, {.pashr_roll_positive = "starboard-up", .pashr_heave_positive = "down"})
                         .all<Attitude>()
                         .at(0);
  EXPECT_NEAR(other.roll.deg(), -1.4, 1e-9);
  EXPECT_NEAR(other.pitch.deg(), -2.3, 1e-9);
  EXPECT_EQ(*other.heave_up_m, -0.12);
}

TEST(Profile, ZdaOfANeighbouringSecond) {
  const auto clock =
      heard("GPZDA,123519.50,22,11,2026,00,00", {.zda_offset_s = -1.0}).all<ClockReading>().at(0);
  EXPECT_EQ(clock.device_ns, parse_iso8601("2026-11-22T12:35:18.500Z")->ns);
}

TEST(Profile, EstimatedPositionsOnRequest) {
  for (const char* text : {"GPRMC,123519.50,A,5912.34567,N,00512.34567,E,4.20,271.4,221126,,,E",
                           "GPGLL,5912.3457,N,00512.3457,E,123519.50,A,E",
                           "GNGNS,123519.50,5912.34567,N,00512.34567,E,EE,14,0.7,41.2,44.1,,",
                           "GPGGA,123519.50,5912.34567,N,00512.34567,E,6,14,0.7,41.20,M,44.10,M,,"}) {
    EXPECT_EQ(heard(text, {}).all<GnssFix>().size(), 0u) << text;
    const auto fixes = heard(text, {.estimated_positions = true}).all<GnssFix>();
    ASSERT_EQ(fixes.size(), 1u) << text;
    EXPECT_EQ(fixes[0].quality, GnssQuality::unknown);
  }
  EXPECT_EQ(heard("GPGGA,123519.50,5912.34567,N,00512.34567,E,8,14,0.7,41.20,M,44.10,M,,",
                  {.estimated_positions = true})
                .all<GnssFix>()
                .size(),
            0u)
      << "simulated is not estimated";
}

TEST(Profile, TransducersNamedByTheInstallation) {
  const std::string text = "IIXDR,A,-2.3,D,TRIM,A,1.4,D,HEEL-1";
  EXPECT_EQ(heard(text, {}).all<Attitude>().size(), 0u);
  const auto tilt =
      heard(text, {.xdr_pitch = {"TRIM"}, .xdr_roll = {"ROLL", "HEEL-1"}}).all<Attitude>().at(0);
  EXPECT_NEAR(tilt.pitch.deg(), -2.3, 1e-9);
  EXPECT_NEAR(tilt.roll.deg(), 1.4, 1e-9);
}

TEST(Profile, SoundersOfOtherMakersAreReadAsTheStandards) {
  const auto lenient = [](const char* text) {
    return decode_all(*decode::make_nmea0183({.checksum_required = false}), as_bytes(text), kHeard);
  };
  EXPECT_EQ(lenient("$VDDPT,0.400,0\r\n").all<BottomDepth>().at(0).depth_m, 0.4);
  EXPECT_EQ(lenient("$GPDPT,10.0,1.5\r\n").all<BottomDepth>().at(0).below, BottomDepth::Below::surface);
  const Decoded strict = decode_all(*decode::make_nmea0183({}), as_bytes("$VDDPT,0.400,0\r\n"), kHeard);
  EXPECT_EQ(classes(strict), "DPT!checksum absent");
}

TEST(Profile, AxesOfPd6) {
  const std::string alone = ":BI,300,100,-50,0,A\n", turned = ":BI,300,100,-50,0,A\n:BS,141,283,-50,A\n";
  const auto velocity = [&](const std::string& text, const char* axes) {
    return decode_all(*decode::make_trdi_pd6({}, {.pd6_axes = axes}), as_bytes(text), kHeard)
        .all<DvlVelocity>()
        .at(0);
  };
  EXPECT_NEAR(velocity(alone, "auto").x_mps, 0.1, 1e-9);
  EXPECT_NEAR(velocity(alone, "waterlinked").x_mps, 0.3, 1e-9);
  EXPECT_NEAR(velocity(alone, "waterlinked").z_mps, -0.05, 1e-9);
  EXPECT_NEAR(velocity(turned, "waterlinked").x_mps, 0.3, 1e-9) << "named axes stay whatever BS says";
  const std::string mirrored = ":BI,300,100,-50,0,A\n:BS,100,300,-50,A\n";
  EXPECT_NEAR(velocity(mirrored, "auto").x_mps, 0.3, 1e-9);
  EXPECT_NEAR(velocity(mirrored, "trdi").x_mps, 0.1, 1e-9);
}

}  // namespace
}  // namespace leadline::test
