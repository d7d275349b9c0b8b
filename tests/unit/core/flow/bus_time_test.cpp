#include <gtest/gtest.h>

#include <memory>

#include "tests/unit/core/flow/fakes.h"

namespace leadline {
namespace {

using namespace test;

struct BusTime : testing::Test {
  BusTime() : bus(two_sources()) {
    bus.attach(sink);
    bus.attach(0, std::make_unique<LetterDecoder>());
  }
  [[nodiscard]] std::vector<std::int64_t> tick_ms() const {
    std::vector<std::int64_t> at;
    for (const auto& e : sink.of<Tick>()) {
      EXPECT_EQ(std::get<Tick>(e.message).at, e.arrival);
      EXPECT_EQ(e.valid, e.arrival.host());
      EXPECT_EQ(e.source, kNoSource);
      at.push_back(e.arrival.ns / 1'000'000);
    }
    return at;
  }
  Bus bus;
  KeepingSink sink;
};

TEST_F(BusTime, NoTickBeforeTheFirstMessage) {
  bus.take(chunk(0, ms(100'000), "1"));
  EXPECT_EQ(sink.kinds, "RD");
  EXPECT_EQ(bus.first_arrival(), ms(100'000));
}

TEST_F(BusTime, TicksAreTheMultiplesOf100MsBeforeTheMessage) {
  bus.take(chunk(0, ms(1050), "1"));
  bus.take(chunk(0, ms(1330), "2"));
  EXPECT_EQ(tick_ms(), (std::vector<std::int64_t>{1100, 1200, 1300}));
  EXPECT_EQ(sink.kinds, "RDTTTRD");
}

TEST_F(BusTime, AMessageOnTheMultipleComesAfterTheTick) {
  bus.take(chunk(0, ms(1050), "1"));
  bus.take(chunk(0, ms(1100), "2"));
  EXPECT_EQ(sink.kinds, "RDTRD");
  bus.take(chunk(0, ms(1100), "3"));
  EXPECT_EQ(sink.kinds, "RDTRDRD");
}

TEST_F(BusTime, NoTickTwiceNorLeftOutWhateverTheChunks) {
  for (std::int64_t at = 1000; at < 6000; at += 7) bus.take(chunk(0, ms(at), "1"));
  const auto ticks = tick_ms();
  ASSERT_EQ(ticks.size(), 49u);
  for (std::size_t i = 0; i < ticks.size(); ++i)
    EXPECT_EQ(ticks[i], 1100 + 100 * static_cast<std::int64_t>(i));
}

TEST_F(BusTime, AQuietHourStillTicks) {
  bus.take(chunk(0, ms(50), "1"));
  bus.take(chunk(0, ms(3'600'050), "1"));
  EXPECT_EQ(tick_ms().size(), 36'000u);
}

TEST_F(BusTime, OfALongSilenceTheFirstHourTicksAndItsEnd) {
  bus.take(chunk(0, ms(50), "1"));
  bus.take(chunk(0, ms(50 + 86'400'000), "2"));
  const auto ticks = tick_ms();
  ASSERT_EQ(ticks.size(), 36'002u);
  EXPECT_EQ(ticks[36'000], 3'600'100);
  EXPECT_EQ(ticks.back(), 86'400'000);
  bus.take(chunk(0, ms(50 + 86'400'100), "3"));
  EXPECT_EQ(tick_ms().back(), 86'400'100);
}

TEST_F(BusTime, SilenceTicksTheSameWhetherItIsToldOnTheWayOrAtItsEnd) {
  bus.take(chunk(0, ms(50), "1"));
  for (int i = 1; i < 50; ++i) bus.pass_time(ms(50 + 37 * i));
  bus.pass_time(ms(10));  // says nothing
  bus.take(chunk(0, ms(3000), "2"));
  std::vector<std::int64_t> expected;
  for (int t = 100; t <= 3000; t += 100) expected.push_back(t);
  EXPECT_EQ(tick_ms(), expected);
  EXPECT_EQ(bus.clock_steps(), 0u);
}

TEST_F(BusTime, AChunkWithoutBytesIsTimeThatPassed) {
  bus.take(chunk(0, ms(50), "1"));
  bus.take(chunk(0, ms(450), ""));
  EXPECT_EQ(tick_ms().size(), 4u);
}

TEST_F(BusTime, AnArrivalThatGoesBackIsTakenAsTheLatest) {
  bus.take(chunk(0, ms(1050), "1"));
  bus.take(chunk(0, ms(900), "2"));
  EXPECT_EQ(bus.clock_steps(), 1u);
  EXPECT_EQ(sink.all.back().arrival, ms(1050));
  EXPECT_EQ(sink.kinds, "RDRD");
  bus.take(chunk(0, ms(1050), "3"));
  EXPECT_EQ(bus.clock_steps(), 1u);
  EXPECT_EQ(bus.last_arrival(), ms(1050));
}

TEST_F(BusTime, FactsAreTrueWhenTheSourcesRulesSay) {
  auto sources = two_sources();
  sources[0].latency_ns = 250'000'000;
  sources[0].time_offset_ns = -1'000'000'000;
  Bus ruled(sources);
  KeepingSink kept;
  ruled.attach(kept);
  ruled.attach(0, std::make_unique<LetterDecoder>(Time{5'000'000'000}));
  ruled.take(chunk(0, ms(7000), "1t"));
  const auto facts = kept.of<DepthMeasured>();
  ASSERT_EQ(facts.size(), 2u);
  EXPECT_EQ(facts[0].valid.ns, 6'750'000'000);
  EXPECT_EQ(facts[1].valid.ns, 4'000'000'000);
  for (const auto& fact : facts) EXPECT_EQ(fact.arrival, ms(7000));
  EXPECT_EQ(kept.all[0].valid.ns, 7'000'000'000);  // the raw frame itself: when it was heard
}

}  // namespace
}  // namespace leadline
