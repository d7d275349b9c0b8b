#include "core/flow/source_watch.h"

#include <gtest/gtest.h>

#include <string>

namespace leadline {
namespace {

constexpr std::int64_t kMs = 1'000'000;

struct Said final : EngineOutput {
  std::vector<std::pair<std::int64_t, std::string>> lines;  // ms, source: text
  void publish(Time valid, const Message& message, SourceId source) override {
    lines.emplace_back(valid.ns / kMs,
                       std::to_string(source) + ": " + std::string(std::get<Health>(message).text.view()));
  }
};

class SourceWatchTest : public testing::Test {
 protected:
  SourceWatchTest() : watch_(two()) {}
  static std::vector<SourceInfo> two() {
    std::vector<SourceInfo> sources(2);
    sources[0].id = 0, sources[1].id = 1;
    return sources;
  }
  void tick_until(std::int64_t ms) {
    for (; next_ms_ <= ms; next_ms_ += 100) {
      Envelope envelope;
      envelope.arrival = {next_ms_ * kMs};
      envelope.message = Tick{envelope.arrival};
      watch_.take(envelope, said_);
    }
  }
  void hear(SourceId source, std::int64_t ms) {
    tick_until(ms);
    Envelope envelope;
    envelope.source = source;
    envelope.arrival = {ms * kMs};
    envelope.message = RawFrame{};
    watch_.take(envelope, said_);
  }

  SourceWatch watch_;
  Said said_;
  std::int64_t next_ms_ = 0;
};

TEST_F(SourceWatchTest, AFastSourceIsSilentAfterTwoSecondsAndHeardAgain) {
  for (int ms = 0; ms <= 10'000; ms += 200) hear(0, ms), hear(1, ms);
  for (int ms = 10'200; ms <= 20'000; ms += 200) hear(1, ms);
  ASSERT_EQ(said_.lines.size(), 1U);
  EXPECT_EQ(said_.lines[0], (std::pair<std::int64_t, std::string>(12'000, "0: silent for 2.0 s")));
  hear(0, 20'050);
  ASSERT_EQ(said_.lines.size(), 2U);
  EXPECT_EQ(said_.lines[1].second, "0: is heard again after 10.1 s");
  EXPECT_FALSE(watch_.silent(0));
}

TEST_F(SourceWatchTest, ASlowSourceIsGivenThreeOfItsIntervals) {
  for (int ms = 0; ms <= 80'000; ms += 500) {
    if (ms % 8000 == 0) hear(0, ms);
    hear(1, ms);
  }
  for (int ms = 80'500; ms <= 110'000; ms += 500) hear(1, ms);
  ASSERT_EQ(said_.lines.size(), 1U);
  EXPECT_EQ(said_.lines[0].first, 104'000);
}

TEST_F(SourceWatchTest, ASourceThatNeverSpeaksIsSaidOnce) {
  for (int ms = 0; ms <= 60'000; ms += 100) hear(1, ms);
  ASSERT_EQ(said_.lines.size(), 1U);
  EXPECT_EQ(said_.lines[0].first, 10'000);
  EXPECT_EQ(said_.lines[0].second, "0: nothing heard since the start, 10.0 s ago");
}

}  // namespace
}  // namespace leadline
