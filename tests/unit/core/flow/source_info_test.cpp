#include "core/flow/source_info.h"

#include <gtest/gtest.h>

namespace leadline {
namespace {

const Arrival kHeard{1'500'000'000'000'000'000};

TEST(Validity, WithoutADeviceTimeIsArrivalLessLatency) {
  SourceInfo source;
  EXPECT_EQ(validity(source, {}, kHeard), kHeard.host());
  source.latency_ns = 1'200'000'000;
  source.time_offset_ns = 77;  // of the device's clock, which did not speak
  EXPECT_EQ(validity(source, {}, kHeard), kHeard.host() - Duration(1'200'000'000));
}

TEST(Validity, OfADeviceTimeAddsItsOffsetAndNoLatency) {
  SourceInfo source;
  source.latency_ns = 1'200'000'000;
  source.time_offset_ns = -30;
  EXPECT_EQ(validity(source, Time{1'000}, kHeard).ns, 970);
}

TEST(Validity, OfAGpsClockTakesTheLeapSecondsOff) {
  SourceInfo source;
  source.gps_time = true;
  const Time gps = *parse_iso8601("2020-06-01T12:00:18Z");
  EXPECT_EQ(validity(source, gps, kHeard), *parse_iso8601("2020-06-01T12:00:00Z"));
  source.time_offset_ns = 500'000'000;
  EXPECT_EQ(validity(source, gps, kHeard), *parse_iso8601("2020-06-01T12:00:00.5Z"));
  EXPECT_EQ(validity(source, {}, kHeard), kHeard.host());
}

TEST(Body, NamesAreThoseOfTheConfiguration) {
  EXPECT_STREQ(name_of(Body::vehicle), "vehicle");
  EXPECT_STREQ(name_of(Body::ship), "ship");
  EXPECT_STREQ(name_of(Body::target), "target");
}

}  // namespace
}  // namespace leadline
