#include "core/decode/nmea0183_clock.h"

#include <gtest/gtest.h>

#include <string>

#include "core/decode/nmea0183.h"
#include "tests/support/decoder_harness.h"

namespace leadline::decode {
namespace {

using test::Decoded;

std::string padded(int value, std::size_t width) {
  const std::string digits = std::to_string(value);
  return std::string(width > digits.size() ? width - digits.size() : 0, '0') + digits;
}

std::string sentence(const std::string& body) {
  unsigned sum = 0;
  for (const char c : body) sum ^= static_cast<unsigned char>(c);
  const char* const hex = "0123456789ABCDEF";
  return "$" + body + "*" + hex[sum >> 4] + hex[sum & 15] + "\r\n";
}

std::string clock_of(const Civil& c) {
  return padded(c.hour, 2) + padded(c.minute, 2) + padded(c.second, 2) + "." +
         padded(c.nanosecond / 1'000'000, 3);
}

std::string date_of(const Civil& c) {
  return padded(c.day, 2) + padded(c.month, 2) + padded(c.year % 100, 2);
}

std::string gga_at(Time t) {
  return sentence("GPGGA," + clock_of(to_civil(t)) + ",5912.3,N,00512.3,E,1,10,1.0,,M,,M,,");
}

std::string zda_at(Time t) {
  const Civil c = to_civil(t);
  return sentence("GPZDA," + clock_of(c) + "," + padded(c.day, 2) + "," + padded(c.month, 2) + "," +
                  padded(c.year, 4) + ",,");
}

std::string rmc(const std::string& time, const std::string& date) {
  return sentence("GPRMC," + time + ",A,5912.3,N,00512.3,E,4.2,271.4," + date + ",,,A");
}

Time at(const char* text) { return *parse_iso8601(text); }

Decoded decode(const std::string& text, std::optional<Arrival> arrival, std::optional<Time> date = {}) {
  DecoderSettings settings;
  settings.date = date;
  const auto decoder = make_nmea0183(settings);
  return test::decode_all(*decoder, test::as_bytes(text), arrival);
}

template <class T>
std::vector<std::optional<Time>> times(const Decoded& all) {
  std::vector<std::optional<Time>> found;
  for (const auto& fact : all.facts)
    if (std::holds_alternative<T>(fact.message)) found.push_back(fact.device_time);
  return found;
}

/// 23:59:58 to 00:00:02 in steps of 0.1 s, each second's ZDA one second late, the whole heard `late_s` after.
void run_over_midnight(bool live, double late_s, std::optional<Time> date) {
  const Time start = at("2026-12-31T23:59:58Z");
  DecoderSettings settings;
  settings.date = date;
  const auto decoder = make_nmea0183(settings);
  Decoded out;
  for (int i = 0; i <= 40; ++i) {
    const Time t = start + duration(0.1 * i);
    const auto arrival = live ? std::optional(arrival_at(t + duration(late_s))) : std::nullopt;
    std::string text;
    if (i % 10 == 0) text += zda_at(t - duration(1.0));
    text += gga_at(t);
    decoder->feed(test::as_bytes(text), arrival, out);
  }
  const auto found = times<GnssFix>(out);
  ASSERT_EQ(found.size(), 41u);
  for (int i = 0; i <= 40; ++i) EXPECT_EQ(found[static_cast<std::size_t>(i)], start + duration(0.1 * i)) << i;
}

TEST(Nmea0183Clock, MidnightMakesNoJumpOfADay) {
  run_over_midnight(true, 0.3, {});
  run_over_midnight(true, -1.0, {});
  run_over_midnight(true, 3600.0, {});
  run_over_midnight(false, 0.0, {});
  run_over_midnight(false, 0.0, at("2020-06-01T12:00:00Z"));
}

TEST(Nmea0183Clock, AFreshDateOfTheSourceBeatsTheHost) {
  const auto all = decode(zda_at(at("2014-08-01T12:00:00Z")) + gga_at(at("2014-08-01T12:00:01Z")),
                          arrival_at(at("2026-11-22T12:35:20Z")));
  EXPECT_EQ(times<GnssFix>(all).at(0), at("2014-08-01T12:00:01Z"));
}

TEST(Nmea0183Clock, AnOldDateOfTheSourceGivesWayToTheHost) {
  const auto decoder = make_nmea0183({});
  Decoded out;
  const Time host = at("2026-11-22T12:35:20Z");
  decoder->feed(test::as_bytes(zda_at(at("2014-08-01T12:00:00Z"))), arrival_at(host), out);
  decoder->feed(test::as_bytes(gga_at(at("2014-08-01T12:00:06Z"))), arrival_at(host + duration(5.1)), out);
  EXPECT_EQ(times<GnssFix>(out).at(0), at("2026-11-22T12:00:06Z"));
}

TEST(Nmea0183Clock, APlainStreamIsDatedByItselfElseByTheConfigurationElseNot) {
  const std::string gga = gga_at(at("2026-11-22T12:00:01Z"));
  EXPECT_EQ(times<GnssFix>(decode(rmc("120000", "221126") + gga, {})).back(), at("2026-11-22T12:00:01Z"));
  EXPECT_EQ(times<GnssFix>(decode(gga, {}, at("2025-05-05T12:00:00Z"))).at(0), at("2025-05-05T12:00:01Z"));
  const auto undated = decode(gga, {});
  EXPECT_EQ(times<GnssFix>(undated).at(0), std::nullopt);
  EXPECT_TRUE(undated.all<ClockReading>().empty());
}

TEST(Nmea0183Clock, APlainStreamRunsOnOverDaysFromItsFirstDate) {
  std::string text = zda_at(at("2026-11-22T00:00:00Z"));
  for (int hour = 1; hour <= 100; ++hour)
    text += gga_at(at("2026-11-22T00:00:00Z") + duration(3600.0 * hour));
  EXPECT_EQ(times<GnssFix>(decode(text, {})).back(), at("2026-11-26T04:00:00Z"));
}

TEST(Nmea0183Clock, LeapSecondIsCarriedToTheNextDay) {
  const auto all = decode("$GPRMC,235960.00,A,5912.34567,N,00512.34567,E,4.20,271.4,311216,,,A*6C\r\n" +
                              rmc("000000.5", "010117"),
                          arrival_at(at("2017-01-01T00:00:00.3Z")));
  EXPECT_EQ(times<Course>(all).at(0), at("2017-01-01T00:00:00Z"));
  EXPECT_EQ(times<Course>(all).at(1), at("2017-01-01T00:00:00.5Z"));
  const auto time_only = decode(sentence("GPGGA,235960.50,5912.3,N,00512.3,E,1,10,1.0,,M,,M,,"),
                                arrival_at(at("2017-01-01T00:00:00.8Z")));
  EXPECT_EQ(times<GnssFix>(time_only).at(0), at("2017-01-01T00:00:00.5Z"));
}

TEST(Nmea0183Clock, TwoDigitYearsLieWithin50YearsOfTheHost) {
  for (const int host : {1999, 2026, 2050}) {
    const auto arrival = arrival_at(*from_civil({.year = host, .month = 7, .day = 1}));
    for (int yy = 0; yy < 100; ++yy) {
      const auto text = rmc("120000", "2806" + padded(yy, 2));
      const auto readings = decode(text, arrival).all<ClockReading>();
      if (readings.empty()) continue;  // 1024 weeks off to the day: told as a rollover, below
      const int year = to_civil(Time{readings[0].device_ns}).year;
      EXPECT_EQ(year % 100, yy);
      EXPECT_GE(year, host - 50);
      EXPECT_LE(year, host + 49);
    }
  }
  const nmea0183::Dating alone{std::nullopt};
  EXPECT_EQ(alone.full_year(80, {}), 1980);
  EXPECT_EQ(alone.full_year(79, {}), 2079);
  const nmea0183::Dating told{at("2026-11-22T00:00:00Z")};
  EXPECT_EQ(told.full_year(76, {}), 1976);
  EXPECT_EQ(told.full_year(75, {}), 2075);
}

TEST(Nmea0183Clock, WeekRolloverIsToldOnceAndNotUsed) {
  const Time host = at("2026-11-22T12:00:00Z");
  for (const int weeks : {-2048, -1024, 1024, 2048}) {
    const Time wrong = host + std::chrono::hours(weeks * 7 * 24) + duration(3600.0);
    const std::string text = zda_at(wrong) + rmc("130000", date_of(to_civil(wrong))) +
                             gga_at(wrong + duration(1.0)) + zda_at(wrong);
    const auto all = decode(text, arrival_at(host));
    ASSERT_EQ(all.all<Health>().size(), 1u) << weeks;
    EXPECT_EQ(all.all<Health>()[0].level, Health::Level::warning);
    EXPECT_EQ(times<Course>(all).at(0), std::nullopt) << weeks;
    EXPECT_EQ(times<GnssFix>(all).back(), at("2026-11-22T13:00:01Z")) << "the day is the host's";
    EXPECT_EQ(all.all<ClockReading>().size(), 1u) << "GGA's only";
  }
  const Time near = host + std::chrono::hours((1024 * 7 + 2) * 24);
  EXPECT_TRUE(decode(zda_at(near), arrival_at(host)).all<Health>().empty()) << "two days off a rollover";
  EXPECT_TRUE(decode(zda_at(host + std::chrono::hours(-1024 * 7 * 24)), {}).all<Health>().empty())
      << "no host";
}

TEST(Nmea0183Clock, CalendarEndsAreRight) {
  const Time host = at("2024-02-29T12:00:00Z");
  EXPECT_EQ(times<Course>(decode(rmc("235959", "290224"), arrival_at(host))).at(0),
            at("2024-02-29T23:59:59Z"));
  EXPECT_EQ(times<GnssFix>(decode(gga_at(at("2025-12-31T23:59:59Z")), arrival_at(at("2026-01-01T00:00:01Z"))))
                .at(0),
            at("2025-12-31T23:59:59Z"));
  EXPECT_EQ(decode(rmc("120000", "290225"), arrival_at(host)).frames.at(0).reason, "range");
}

}  // namespace
}  // namespace leadline::decode
