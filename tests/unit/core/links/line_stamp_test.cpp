#include "core/links/line_stamp.h"

#include <gtest/gtest.h>

#include <random>

namespace leadline::links {
namespace {

TEST(UnixStamp, TakesOneToNineDecimalsExactly) {
  struct Case {
    const char* text;
    std::int64_t ns;
  };
  for (const auto& c :
       {Case{"(1795350919.500000) ", 1795350919500000000}, Case{"(1795350919.5) ", 1795350919500000000},
        Case{"(1795350919.123456789)\t", 1795350919123456789}, Case{"(0.1) ", 100000000}}) {
    const auto stamp = unix_stamp(std::string(c.text) + "gps $X");
    ASSERT_TRUE(stamp) << c.text;
    EXPECT_EQ(stamp->time.ns, c.ns) << c.text;
    EXPECT_EQ(stamp->length, std::string(c.text).size()) << c.text;
  }
}

TEST(UnixStamp, RefusesAnythingElse) {
  for (const char* text :
       {"", "(", "()", "(1.0)", "(1.0)gps x", "(1) gps x", "(1.) gps x", "(.5) gps x", "(-1.0) gps x",
        " (1.0) gps x", "1.0 gps x", "(1.0123456789) gps x", "(99999999999.0) gps x", "(9999999999.0) gps x",
        "(1e9) gps x", "(1.0 ) gps x", "(1,0) gps x", "(1795350919.5"})
    EXPECT_FALSE(unix_stamp(text)) << text;
}

TEST(IsoStamp, EqualsTheReferenceParserOnRandomTimes) {
  std::mt19937_64 random(7);
  for (int i = 0; i < 20000; ++i) {
    const Time time{static_cast<std::int64_t>(random() % 8'000'000'000'000'000'000)};
    const int decimals = i % 10;
    const std::string text = iso8601(time, decimals);
    const auto stamp = iso_stamp(text + " $HEHDT");
    ASSERT_TRUE(stamp) << text;
    ASSERT_EQ(stamp->time, *parse_iso8601(text)) << text;
    ASSERT_EQ(stamp->length, text.size() + 1) << text;
  }
}

TEST(IsoStamp, TakesWhatLogsWriteAndNoMore) {
  EXPECT_EQ(iso_stamp("2014-08-01T00:00:00.186000Z $PUHAW")->time,
            *parse_iso8601("2014-08-01T00:00:00.186Z"));
  EXPECT_EQ(iso_stamp("2014-08-01T00:00:00Z\tx")->length, 21u);
  EXPECT_EQ(iso_stamp("2014-08-01T00:00:00 x")->length, 20u);
  EXPECT_EQ(iso_stamp("2014-08-01T00:00:00Z\r\n")->length, 20u) << "an empty sentence keeps its terminator";
  EXPECT_EQ(iso_stamp("2016-12-31T23:59:60Z x")->time, *parse_iso8601("2017-01-01T00:00:00Z"));
  for (const char* text : {"", "2014-08-01", "2014-08-01T00:00:00Z", "2014-08-01T00:00:00.1",
                           "2014-08-01 00:00:00Z x", "2014-13-01T00:00:00Z x", "2014-02-30T00:00:00Z x",
                           "2014-08-01T24:00:00Z x", "2014-08-01T00:00:0aZ x", "2a14-08-01T00:00:00Z x",
                           "20/4-08-01T00:00:00Z x", "2014-08-01T00:00:00.Z x", "2014-08-01T00:00:00Zx y",
                           "2014/08/01T00:00:00Z x", "$PUHAW,UVH 2014-08-01T00:00:00Z"})
    EXPECT_FALSE(iso_stamp(text)) << text;
}

}  // namespace
}  // namespace leadline::links
