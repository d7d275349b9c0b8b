#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <random>
#include <tuple>

#include "tests/unit/core/flow/fakes.h"

namespace leadline {
namespace {

using namespace test;

struct BusOrder : testing::Test {
  BusOrder() : bus(two_sources()), engine(0), second(1) {
    bus.attach(recorder);
    bus.attach(0, std::make_unique<LetterDecoder>());
    bus.attach(1, std::make_unique<LetterDecoder>());
    bus.attach(engine);
    bus.attach(second);
  }
  Bus bus;
  KeepingSink recorder;
  EchoEngine engine, second;
};

TEST_F(BusOrder, RawFrameThenItsFactThenWhatEnginesSay) {
  bus.take(chunk(0, ms(10), "1"));
  EXPECT_EQ(recorder.kinds, "RDMSMS");
  EXPECT_EQ(recorder.raw_bytes[0], "1");
}

TEST_F(BusOrder, EachFactIsAnsweredBeforeTheNext) {
  bus.take(chunk(0, ms(10), "12"));
  EXPECT_EQ(recorder.kinds, "RDMSMSDMSMS");
}

TEST_F(BusOrder, EnginesSpeakInTheOrderTheyWereAttached) {
  bus.take(chunk(0, ms(10), "1"));
  const auto said = recorder.of<Solution>();
  ASSERT_EQ(said.size(), 2u);
  EXPECT_EQ(std::get<Solution>(said[0].message).engine, 0);
  EXPECT_EQ(std::get<Solution>(said[1].message).engine, 1);
  EXPECT_EQ(said[0].source, 0);
}

TEST_F(BusOrder, EnginesDoNotHearEngines) {
  bus.take(chunk(0, ms(10), "12"));
  EXPECT_EQ(engine.heard, (std::vector<std::uint64_t>{1, 2, 7}));
  EXPECT_EQ(second.heard, engine.heard);
}

TEST_F(BusOrder, NumbersGoUpByOneFromOne) {
  std::mt19937_64 random(7);
  const std::string letters = "0123x_u";
  std::int64_t now = 0;
  for (int i = 0; i < 500; ++i) {
    std::string text;
    for (std::uint64_t n = random() % 5; n > 0; --n) text += letters[random() % letters.size()];
    now += static_cast<std::int64_t>(random() % 300);
    bus.take(chunk(static_cast<SourceId>(random() % 3), ms(now), text));
  }
  bus.finish();
  for (std::size_t i = 0; i < recorder.all.size(); ++i) {
    ASSERT_EQ(recorder.all[i].seq, i + 1);
    ASSERT_GE(recorder.all[i].arrival, recorder.all[i - std::min<std::size_t>(i, 1)].arrival);
  }
  EXPECT_GT(recorder.all.size(), 1500u);
}

TEST_F(BusOrder, EverySinkHearsTheSame) {
  KeepingSink screen;
  bus.attach(screen);
  bus.take(chunk(0, ms(10), "1x"));
  bus.take(chunk(1, ms(250), "2"));
  EXPECT_EQ(screen.kinds, recorder.kinds);
}

TEST_F(BusOrder, FactsPointToTheRawFrameTheyWereMadeFrom) {
  bus.take(chunk(0, ms(10), "1"));
  bus.take(chunk(1, ms(20), "2"));
  const auto facts = recorder.of<DepthMeasured>();
  ASSERT_EQ(facts.size(), 2u);
  for (const auto& fact : facts) {
    EXPECT_TRUE(std::holds_alternative<RawFrame>(recorder.all[fact.raw - 1].message));
    EXPECT_EQ(recorder.all[fact.raw - 1].source, fact.source);
  }
}

TEST_F(BusOrder, WhatIsGivenUpAtTheEndPointsToItsOwnSourcesFrame) {
  bus.take(chunk(0, ms(10), "p"));
  bus.take(chunk(1, ms(20), "2"));
  bus.finish();
  const Envelope last = recorder.of<DepthMeasured>().back();
  EXPECT_EQ(last.source, 0);
  EXPECT_EQ(last.raw, 1u);
}

TEST_F(BusOrder, ARefusedTelegramIsAMessage) {
  bus.take(chunk(0, ms(10), "1x"));
  const auto refused = recorder.of<Rejected>();
  ASSERT_EQ(refused.size(), 1u);
  const auto& r = std::get<Rejected>(refused[0].message);
  EXPECT_EQ(r.reason.view(), "checksum");
  EXPECT_EQ(r.offset, 1u);
  EXPECT_EQ(r.length, 1u);
  EXPECT_EQ(refused[0].raw, 1u);
}

TEST_F(BusOrder, ASettledCommentIsCountedAndNotHandedOn) {
  Chunk comment = chunk(0, ms(10), "# speed trial");
  comment.settled = ByteClass::comment;
  bus.take(comment);
  EXPECT_EQ(recorder.kinds, "");
  EXPECT_FALSE(bus.first_arrival());
  EXPECT_EQ(bus.ledger(0).bytes(ByteClass::comment), 13u);
}

TEST_F(BusOrder, ASettledRefusalIsRecordedAndNotDecoded) {
  Chunk torn = chunk(0, ms(10), "123");
  torn.settled = ByteClass::refused;
  torn.reason = "stamp";
  bus.take(torn);
  EXPECT_EQ(recorder.kinds, "RX");
  EXPECT_EQ(recorder.all[1].raw, 1u);
  EXPECT_EQ(std::get<Rejected>(recorder.all[1].message).reason.view(), "stamp");
  EXPECT_EQ(std::get<Rejected>(recorder.all[1].message).length, 3u);
  EXPECT_EQ(bus.ledger(0).bytes(ByteClass::refused), 3u);
}

TEST_F(BusOrder, AnUnknownSourceIsRecordedAndCountedAsStray) {
  bus.take(chunk(7, ms(10), "12"));
  bus.take(chunk(kNoSource, ms(20), "345"));
  EXPECT_EQ(recorder.kinds, "RR");
  EXPECT_EQ(recorder.all[0].source, kNoSource);
  EXPECT_EQ(bus.stray().bytes(ByteClass::unknown), 5u);
  EXPECT_EQ(bus.ledger(0).bytes_total(), 0u);
}

TEST(Bus, ASourceWithoutDecoderIsRecordedOnly) {
  Bus bus(two_sources());
  KeepingSink recorder;
  bus.attach(recorder);
  bus.take(chunk(1, ms(10), "123"));
  bus.finish();
  EXPECT_EQ(recorder.kinds, "R");
  EXPECT_EQ(bus.ledger(1).bytes(ByteClass::unused), 3u);
  EXPECT_FALSE(bus.ledger(1).damaged());
}

TEST_F(BusOrder, EveryByteIsInOneClass) {
  std::mt19937_64 random(11);
  const std::string letters = "0123x_u";
  std::uint64_t fed[3] = {0, 0, 0};
  for (int i = 0; i < 1000; ++i) {
    std::string text;
    for (std::uint64_t n = random() % 9; n > 0; --n) text += letters[random() % letters.size()];
    Chunk c = chunk(static_cast<SourceId>(random() % 3), ms(i), text);
    c.stamp_bytes = static_cast<std::uint32_t>(random() % 20);
    if (random() % 5 == 0)
      c.settled = random() % 2 ? ByteClass::comment : ByteClass::refused, c.reason = "stamp";
    fed[c.source] += text.size() + c.stamp_bytes;
    bus.take(c);
  }
  bus.finish();
  EXPECT_EQ(bus.ledger(0).bytes_total(), fed[0]);
  EXPECT_EQ(bus.ledger(1).bytes_total(), fed[1]);
  EXPECT_EQ(bus.stray().bytes_total(), fed[2]);
}

TEST_F(BusOrder, TheSameBytesGiveTheSameMessages) {
  const auto run = [] {
    Bus again(two_sources());
    KeepingSink sink;
    EchoEngine echo(0);
    again.attach(sink);
    again.attach(echo);
    again.attach(0, std::make_unique<LetterDecoder>());
    for (int i = 0; i < 50; ++i)
      again.take(chunk(static_cast<SourceId>(i % 2), ms(i * 37), i % 3 ? "12x" : "u_4"));
    return sink;
  };
  const KeepingSink a = run(), b = run();
  ASSERT_EQ(a.all.size(), b.all.size());
  for (std::size_t i = 0; i < a.all.size(); ++i) {
    const Envelope &x = a.all[i], &y = b.all[i];
    ASSERT_EQ(std::tie(x.seq, x.raw, x.valid, x.arrival, x.source),
              std::tie(y.seq, y.raw, y.valid, y.arrival, y.source));
    ASSERT_TRUE(x.message == y.message);
  }
}

}  // namespace
}  // namespace leadline
