// Positions as text, and back.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>

#include "core/geo/geodesy.h"
#include "ui/models/figures.h"

namespace leadline::ui {
namespace {

using testing::HasSubstr;

Geodetic place(double lat_deg, double lon_deg) { return {Angle::deg(lat_deg), Angle::deg(lon_deg)}; }
PositionText dm(double lat_deg, double lon_deg) { return position_text(place(lat_deg, lon_deg)); }

TEST(PositionText, InItsFourForms) {
  const Geodetic p = place(36.91, 129.905);
  EXPECT_EQ(position_text(p), (PositionText{"36°54.60000′ N", "129°54.30000′ E"}));
  EXPECT_EQ(position_text(p, PositionFormat::dd), (PositionText{"36.9100000° N", "129.9050000° E"}));
  EXPECT_EQ(position_text(p, PositionFormat::dms), (PositionText{"36°54′36.000″ N", "129°54′18.000″ E"}));
  const PositionText utm = position_text(p, PositionFormat::utm);
  EXPECT_THAT(utm.first, testing::MatchesRegex("52N 58[0-9]{4}\\.[0-9]{2} E"));
  EXPECT_THAT(utm.second, testing::MatchesRegex("408[0-9]{4}\\.[0-9]{2} N"));
  EXPECT_EQ(position_line(p), "36°54.60000′ N  129°54.30000′ E");
}

TEST(PositionText, RoundingIsCarriedIntoMinutesAndDegrees) {
  const double nearly_deg = 59.9999951 / 60.0;
  EXPECT_EQ(dm(12 + nearly_deg, 7 + nearly_deg), (PositionText{"13°00.00000′ N", "008°00.00000′ E"}));
  EXPECT_EQ(dm(-12 - nearly_deg, -7 - nearly_deg), (PositionText{"13°00.00000′ S", "008°00.00000′ W"}));
  EXPECT_EQ(dm(12 + 59.9999949 / 60.0, 0.0).first, "12°59.99999′ N");
  EXPECT_EQ(position_text(place(12.99999996, 0.0), PositionFormat::dd).first, "13.0000000° N");
  EXPECT_EQ(position_text(place(12 + 59.0 / 60 + 59.9996 / 3600, 0.0), PositionFormat::dms).first,
            "13°00′00.000″ N");
}

TEST(PositionText, AtPolesEquatorAndDateLine) {
  EXPECT_EQ(dm(90.0, 0.0).first, "90°00.00000′ N");
  EXPECT_EQ(dm(-90.0, 0.0).first, "90°00.00000′ S");
  EXPECT_EQ(dm(89.99999999, 0.0).first, "90°00.00000′ N");
  EXPECT_EQ(dm(0.0, -180.0).second, "180°00.00000′ W");
  EXPECT_EQ(dm(0.0, 179.9999999999).second, "180°00.00000′ E");
  EXPECT_EQ(dm(0.0, 181.0).second, "179°00.00000′ W");
  EXPECT_EQ(dm(-1e-9, -1e-9), (PositionText{"00°00.00000′ N", "000°00.00000′ E"})) << "no south of nothing";
  EXPECT_EQ(dm(-33.5, -70.25), (PositionText{"33°30.00000′ S", "070°15.00000′ W"}));
  EXPECT_EQ(position_text(place(88.0, 10.0), PositionFormat::utm).first, "88°00.00000′ N")
      << "UTM ends at 84";
}

TEST(PositionText, EveryFormIsReadBackToItsLastDigit) {
  std::mt19937 random(9);
  std::uniform_real_distribution<double> lat(-79.9, 83.9), lon(-180.0, 180.0);
  for (int i = 0; i < 2000; ++i) {
    const Geodetic p = place(lat(random), lon(random));
    for (const auto format :
         {PositionFormat::dm, PositionFormat::dd, PositionFormat::dms, PositionFormat::utm}) {
      const std::string text = position_line(p, format);
      const auto read = parse_position(text);
      ASSERT_TRUE(read) << text << ": " << read.error().line();
      EXPECT_LT(geo::geodesic(p, read.value()).distance_m, 0.025) << text;
    }
  }
}

TEST(PositionPaste, OneAPlaceInManyHands) {
  for (const char* text : {
           "36°54.60000′ N 129°54.30000′ E",
           "36°54.6'N, 129°54.3'E",
           "36 54.6 N 129 54.3 E",
           "N36 54.6 E129 54.3",
           "n 36° 54.6' e 129° 54.3'",
           "36-54.600N 129-54.300E",
           "36.91, 129.905",
           "36.91,129.905",
           "+36.91 +129.905",
           "36.91° N 129.905° E",
           "129.905 E 36.91 N",
           "E129°54.3' N36°54.6'",
           "36°54′36″N 129°54′18″E",
           "36 54 36.0 129 54 18.0",
           "36 54.6 129 54.3",
           "36:54:36 N 129:54:18 E",
           "36°54'36\"N/129°54'18\"E",
           " 36.910000\t129.905000\n",
           "36\u00a054.6\u2032\u202fN\u2009129\u00ba54.3\u2019 E",
       }) {
    const auto read = parse_position(text);
    ASSERT_TRUE(read) << text << ": " << read.error().line();
    EXPECT_LT(geo::geodesic(read.value(), place(36.91, 129.905)).distance_m, 0.001) << text;
  }
}

TEST(PositionPaste, SignsAndLettersOfTheSouthAndWest) {
  for (const char* text : {"-33.5 -70.25", "\u221233.5, \u221270.25", "33°30' S 70°15' W", "S33.5 W70.25",
                           "-33 30 -70 15", "70.25W 33.5S"}) {
    const auto read = parse_position(text);
    ASSERT_TRUE(read) << text << ": " << read.error().line();
    EXPECT_LT(geo::geodesic(read.value(), place(-33.5, -70.25)).distance_m, 0.001) << text;
  }
  EXPECT_EQ(parse_position("0 180").value().lon.deg(), -180.0) << "one name for the date line";
}

TEST(PositionPaste, UtmWithHemisphereOrBand) {
  const Geodetic p = place(36.91, 129.905);
  std::string text = position_line(p, PositionFormat::utm);
  EXPECT_LT(geo::geodesic(parse_position(text).value(), p).distance_m, 0.01);
  text.replace(0, 3, "52T");  // a band of the north
  EXPECT_LT(geo::geodesic(parse_position(text).value(), p).distance_m, 0.01);
  const Geodetic south = place(-33.5, -70.25);
  EXPECT_LT(
      geo::geodesic(parse_position(position_line(south, PositionFormat::utm)).value(), south).distance_m,
      0.01);
  EXPECT_FALSE(parse_position("61N 580000 4085000"));
  EXPECT_FALSE(parse_position("0N 580000 4085000"));
  EXPECT_FALSE(parse_position("52N 9580000 4085000"));
}

TEST(PositionPaste, WhatIsNoneIsRefusedInASentence) {
  for (const auto& [text, why] : std::vector<std::pair<const char*, const char*>>{
           {"", "empty"},
           {"36.91", "needs a latitude and a longitude"},
           {"91 0", "latitudes end at 90"},
           {"0 181", "longitudes end at 180"},
           {"36 60.0 N 129 54 E", "end at 60"},
           {"36 54 60 N 129 54 0 E", "end at 60"},
           {"36.5 30 N 129 54 E", "only the last number"},
           {"36 -54.6 129 54.3", "sign stands in its middle"},
           {"-36.9 N 129.9 E", "a sign and a letter"},
           {"36.9 N 129.9 N", "one of N, S and one of E, W"},
           {"36.9 N 129.9", "one of N, S and one of E, W"},
           {"36,91 129,905", "decimals with a point"},
           {"36,54 N 129,54 E", "decimals with a point"},
           {"somewhere near Busan", "holds words"},
           {"36.9.1 129.9", "is no number"},
           {"36.9 N 129.9 E 12", "there are three parts"},
           {"1 2 3 4 5 6 7 8", "needs a latitude"},
           {"36.9 129.9 ?", "does not belong"},
           {"N E", "missing"},
           {"-", "does not belong"},
           {".", "no number"},
           {"1e5 3", ""},
       }) {
    const auto read = parse_position(text);
    ASSERT_FALSE(read) << text;
    EXPECT_THAT(read.error().line(), HasSubstr(why)) << text;
    EXPECT_THAT(read.error().remedy, HasSubstr("36°54.60000′ N")) << text;
  }
  EXPECT_FALSE(parse_position(std::string(10'000, '1')));
}

TEST(PositionPaste, AnyBytesAreReadOrRefused) {
  std::mt19937 random(4);
  const std::string alphabet = "0123456789.,-+ NSEWnsewDM°′″'\":/;\xC2\xE2\x80 x";
  for (int i = 0; i < 20'000; ++i) {
    std::string text;
    for (std::size_t n = random() % 24; n > 0; --n) text += alphabet[random() % alphabet.size()];
    if (const auto read = parse_position(text)) {
      EXPECT_LE(std::abs(read.value().lat.deg()), 90.0) << text;
      EXPECT_LE(std::abs(read.value().lon.deg()), 180.0) << text;
    }
  }
}

}  // namespace
}  // namespace leadline::ui
