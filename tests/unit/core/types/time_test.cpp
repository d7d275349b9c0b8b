#include "core/types/time.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <random>
#include <utility>

namespace leadline {
namespace {

Time at(std::string_view text) {
  const auto t = parse_iso8601(text);
  EXPECT_TRUE(t) << text;
  return t.value_or(Time{});
}

TEST(CivilTime, EachDayFrom1900To2200ComesBack) {
  const Time first = at("1900-01-01T00:00:00Z"), last = at("2200-12-31T23:59:59Z");
  std::mt19937_64 random(1);
  Civil before{1899, 12, 31};
  for (Time t = first; t < last; t = t + Duration(std::chrono::hours(24))) {
    const Time somewhen = t + Duration(random() % 86'400'000'000'000);
    const Civil c = to_civil(somewhen);
    ASSERT_EQ(from_civil(c), somewhen);
    // The calendar's own rule: the day after is the next day, or the first of the next month or year.
    const bool next_day = c.year == before.year && c.month == before.month && c.day == before.day + 1;
    const bool next_month =
        c.year == before.year && c.month == before.month + 1 && c.day == 1 && before.day >= 28;
    const bool next_year = c.year == before.year + 1 && c.month == 1 && c.day == 1 && before.month == 12;
    ASSERT_TRUE(next_day || next_month || next_year) << iso8601(t);
    before = c;
  }
  EXPECT_EQ(before.year, 2200);
}

TEST(CivilTime, UnixEpochAndKnownInstants) {
  EXPECT_EQ(at("1970-01-01T00:00:00Z").ns, 0);
  EXPECT_EQ(at("2001-09-09T01:46:40Z").ns, 1'000'000'000'000'000'000);
  EXPECT_EQ(at("1969-12-31T23:59:59.999999999Z").ns, -1);
}

TEST(CivilTime, LeapSecondIsTheNextMinute) {
  EXPECT_EQ(at("2016-12-31T23:59:60Z"), at("2017-01-01T00:00:00Z"));
  EXPECT_EQ(from_civil({2016, 12, 31, 23, 59, 60, 500'000'000}), at("2017-01-01T00:00:00.5Z"));
}

TEST(CivilTime, YearEnd) {
  EXPECT_EQ((at("2018-01-01T00:00:00Z") - at("2017-12-31T23:59:59.999999999Z")).count(), 1);
}

TEST(CivilTime, The29thOfFebruaryIsThereInLeapYearsOnly) {
  EXPECT_TRUE(from_civil({2024, 2, 29}));
  EXPECT_TRUE(from_civil({2000, 2, 29}));
  EXPECT_FALSE(from_civil({2023, 2, 29}));
  EXPECT_FALSE(from_civil({1900, 2, 29}));
}

TEST(CivilTime, RefusesFieldsOutOfRange) {
  const Civil bad[] = {{2020, 0, 1},
                       {2020, 13, 1},
                       {2020, 4, 31},
                       {2020, 1, 0},
                       {2020, 1, 1, 24, 0, 0},
                       {2020, 1, 1, 0, 60, 0},
                       {2020, 1, 1, 0, 0, 61},
                       {2020, 1, 1, -1, 0, 0},
                       {1699, 1, 1},
                       {2261, 1, 1},
                       {2020, 1, 1, 0, 0, -1},
                       {2020, -1, 1},
                       {2020, 1, 1, 0, 0, 0, -1},
                       {2020, 1, 1, 0, 0, 0, 1'000'000'000}};
  for (const Civil& c : bad) EXPECT_FALSE(from_civil(c)) << c.year << '-' << c.month << '-' << c.day;
  EXPECT_TRUE(from_civil({1700, 1, 1}));
  EXPECT_TRUE(from_civil({2260, 12, 31, 23, 59, 60, 999'999'999}));
}

TEST(Iso8601, WritesEachNumberOfDecimals) {
  const Time t = at("2026-11-22T12:35:19.123456789Z");
  EXPECT_EQ(iso8601(t), "2026-11-22T12:35:19.123Z");
  EXPECT_EQ(iso8601(t, 0), "2026-11-22T12:35:19Z");
  EXPECT_EQ(iso8601(t, 6), "2026-11-22T12:35:19.123457Z");
  EXPECT_EQ(iso8601(t, 9), "2026-11-22T12:35:19.123456789Z");
  EXPECT_EQ(iso8601(t, 99), iso8601(t, 9));
  EXPECT_EQ(iso8601(at("2026-11-22T12:35:19.000000001Z"), 9), "2026-11-22T12:35:19.000000001Z");
}

TEST(Iso8601, RoundsIntoTheNextSecondNeverTo60) {
  EXPECT_EQ(iso8601(at("2017-12-31T23:59:59.9996Z")), "2018-01-01T00:00:00.000Z");
  EXPECT_EQ(iso8601(at("2017-12-31T23:59:59.9994Z")), "2017-12-31T23:59:59.999Z");
  EXPECT_EQ(iso8601(at("2017-06-01T10:00:59.5Z"), 0), "2017-06-01T10:01:00Z");
  EXPECT_EQ(iso8601(Time{-1}, 3), "1970-01-01T00:00:00.000Z");
}

TEST(Iso8601, ReadsItsVariants) {
  const Time t = at("2014-08-01T00:00:00.814000Z");
  EXPECT_EQ(at("2014-08-01 00:00:00.814"), t);
  EXPECT_EQ(at("2014-08-01T00:00:00.814"), t);
  EXPECT_EQ(at("2014-08-01T00:00:00.8140000009999Z"), t);  // beyond the nanosecond is cut off
  EXPECT_EQ(at("2014-08-01 00:00:00Z"), t - Duration(814'000'000));
}

TEST(Iso8601, RefusesAnythingElse) {
  for (const char* text :
       {"", "2014", "2014-08-01", "2014-08-01T", "2014-08-01T00:00", "2014-08-01T00:00:0",
        "2014-08-01T00:00:00.", "2014-08-01T00:00:00.Z", "2014-08-01T00:00:00ZZ", "2014-08-01T00:00:00+01:00",
        "2014-08-01t00:00:00", "2014-8-01T00:00:00", "2014-02-30T00:00:00", "2014-08-01T24:00:00",
        "2014-08-01T00:00:61", " 2014-08-01T00:00:00", "2014/08/01T00:00:00", "-014-08-01T00:00:00",
        "2014-08-01T00:00:00 "})
    EXPECT_FALSE(parse_iso8601(text)) << text;
}

TEST(Iso8601, WhatIsWrittenIsRead) {
  std::mt19937_64 random(2);
  for (int i = 0; i < 2000; ++i) {
    const Time t{static_cast<std::int64_t>(random() % 9'000'000'000'000'000'000) - 2'000'000'000'000'000'000};
    EXPECT_EQ(parse_iso8601(iso8601(t, 9)), t);
    EXPECT_LE(std::abs((at(iso8601(t, 6)) - t).count()), 500);
  }
}

TEST(Date, IsMidnight) {
  EXPECT_EQ(parse_date("2017-08-01"), at("2017-08-01T00:00:00Z"));
  for (const char* text :
       {"", "2017-08", "2017-08-01T", "2017-13-01", "2017-02-29", "17-08-01", "2017-08-1", "2017-08-01 "})
    EXPECT_FALSE(parse_date(text)) << text;
}

TEST(UnixTime, RoundTripWithinADoublesGrain) {
  std::mt19937_64 random(3);
  for (int i = 0; i < 5000; ++i) {
    const Time t{static_cast<std::int64_t>(random() % 2'000'000'000'000'000'000)};
    EXPECT_LE(std::abs((from_unix(to_unix(t)) - t).count()), 120);
  }
  EXPECT_EQ(from_unix(1234567890.25).ns, 1'234'567'890'250'000'000);
  EXPECT_EQ(from_unix(-0.25).ns, -250'000'000);
  EXPECT_EQ(to_unix(Time{1'500'000'000}), 1.5);
}

TEST(Durations, ConvertToTheNearestNanosecond) {
  EXPECT_EQ(duration(0.1).count(), 100'000'000);
  EXPECT_EQ(duration(-1.5e-9).count(), -2);
  EXPECT_DOUBLE_EQ(seconds(Duration(250'000'000)), 0.25);
}

TEST(GpsTime, OffsetsAroundTheLeapSeconds) {
  const std::pair<const char*, int> table[] = {
      {"1979-12-31T00:00:00", 0},  {"1980-01-06T00:00:00", 0},  {"1981-06-30T23:59:59", 0},
      {"1981-07-01T00:00:00", 1},  {"1982-07-01T00:00:00", 2},  {"1983-07-01T00:00:00", 3},
      {"1985-07-01T00:00:00", 4},  {"1988-01-01T00:00:00", 5},  {"1990-01-01T00:00:00", 6},
      {"1991-01-01T00:00:00", 7},  {"1992-07-01T00:00:00", 8},  {"1993-07-01T00:00:00", 9},
      {"1994-07-01T00:00:00", 10}, {"1996-01-01T00:00:00", 11}, {"1997-07-01T00:00:00", 12},
      {"1998-12-31T23:59:59", 12}, {"1999-01-01T00:00:00", 13}, {"2005-12-31T23:59:59", 13},
      {"2006-01-01T00:00:00", 14}, {"2009-01-01T00:00:00", 15}, {"2012-07-01T00:00:00", 16},
      {"2015-07-01T00:00:00", 17}, {"2016-12-31T23:59:59", 17}, {"2017-01-01T00:00:00", 18},
      {"2026-01-01T00:00:00", 18}};
  for (const auto& [utc, offset] : table) EXPECT_EQ(gps_minus_utc_s(at(utc)), offset) << utc;
}

TEST(GpsTime, ToUtcAcrossTheLeapSecondOf2016) {
  EXPECT_EQ(utc_from_gps(at("2017-01-01T00:00:16")), at("2016-12-31T23:59:59"));
  EXPECT_EQ(utc_from_gps(at("2017-01-01T00:00:17")), at("2017-01-01T00:00:00"));  // 23:59:60
  EXPECT_EQ(utc_from_gps(at("2017-01-01T00:00:18")), at("2017-01-01T00:00:00"));
  EXPECT_EQ(utc_from_gps(at("2017-01-01T00:00:19")), at("2017-01-01T00:00:01"));
  EXPECT_EQ(utc_from_gps(at("2020-06-01T12:00:18.5")), at("2020-06-01T12:00:00.5"));
}

TEST(ArrivalTime, IsTheNearestMicrosecond) {
  EXPECT_EQ(arrival_at(Time{1'499}).ns, 1'000);
  EXPECT_EQ(arrival_at(Time{1'500}).ns, 2'000);
  EXPECT_EQ(arrival_at(Time{-1'499}).ns, -1'000);
  EXPECT_EQ(arrival_at(Time{-1'501}).ns, -2'000);
  EXPECT_EQ(arrival_at(at("2014-08-01T00:00:00.814Z")).host(), at("2014-08-01T00:00:00.814Z"));
}

TEST(ArrivalTime, AMicrosecondStampOfALogSurvivesTheDouble) {
  for (std::int64_t us = 1'770'000'000'000'000; us < 1'770'000'000'003'000; ++us)
    ASSERT_EQ(arrival_at(from_unix(static_cast<double>(us) * 1e-6)).ns, us * 1000);
}

}  // namespace
}  // namespace leadline
