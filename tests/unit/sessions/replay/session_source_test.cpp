#include "sessions/replay/session_source.h"

#include <gtest/gtest.h>

#include "core/decode/registry.h"
#include "core/flow/bus.h"
#include "core/links/tlog_source.h"
#include "tests/unit/sessions/made_session.h"

namespace leadline::sessions {
namespace {

using test::MadeFolder;

struct Heard {
  SourceId source;
  std::int64_t arrival_ns;
  std::string bytes;
  std::optional<ByteClass> settled;
  std::string reason;
  bool operator==(const Heard&) const = default;
};

Heard heard(const Chunk& c) {
  return {c.source, c.arrival.ns, std::string(c.bytes.begin(), c.bytes.end()), c.settled,
          std::string(c.reason)};
}

/// What a sink is told, ticks left out, raw bytes kept.
class Told final : public Sink {
 public:
  void take(const Envelope& e) override {
    if (std::holds_alternative<Tick>(e.message)) return;
    all.push_back(e);
    bytes.emplace_back();
    if (auto* raw = std::get_if<RawFrame>(&all.back().message)) {
      bytes.back().assign(raw->bytes.begin(), raw->bytes.end());
      raw->bytes = {};
    }
  }
  std::vector<Envelope> all;
  std::vector<std::string> bytes;
};

std::vector<SourceInfo> infos() {
  std::vector<SourceInfo> sources;
  for (const auto& source : test::two_source_run().sources) sources.push_back(source.info);
  return sources;
}

/// A log of all that logs hold: sentences, hex, a bad line, an unknown source, a torn end.
std::string log_text() {
  std::string text = "# a comment\nno stamp\n";
  for (int i = 0; i < 700; ++i) {
    const std::string stamp =
        "(" + std::to_string(1'700'000'000 + i / 4) + "." + std::to_string(100000 + i) + ") ";
    text += stamp + "gps $GPHDT," + std::to_string(i % 360) + ".5,T\r\n";
    if (i % 3 == 0) text += stamp + "dvl #7f7f0100ff" + std::string(i % 7 * 2, 'a') + "\n";
    if (i % 50 == 0) text += stamp + "dvl #zz\n";
    if (i % 60 == 0) text += stamp + "sonar ping\n";
  }
  return text + "(1700000900.000000) gp";
}

struct Replayed {
  Told told;
  std::uint64_t refused = 0;
};

void run(Source& source, Replayed& out, Recorder* recorder) {
  Bus bus(infos());
  if (recorder != nullptr) bus.attach(*recorder);
  bus.attach(out.told);
  DecoderSettings settings;
  settings.checksum_required = false;
  bus.attach(1, decode::make_decoder("nmea0183", settings, {}).value());
  bus.attach(0, decode::make_decoder("trdi-pd0", settings, {}).value());
  for (Chunk chunk; source.next(chunk);) bus.take(chunk);
  bus.finish();
  for (const SourceId id : {SourceId{0}, SourceId{1}})
    out.refused += bus.ledger(id).frames(ByteClass::refused) + bus.ledger(id).refusals().size();
}

TEST(SessionSource, AReplayOfTheSessionIsTheReplayOfTheLog) {
  MadeFolder folder;
  const std::string log = folder.file("s.tlog"), path = folder.file("s.leadline");
  test::write_content(log, log_text());
  Replayed first;
  {
    auto recorder = Recorder::start(Session::create(path, {}).value(), test::two_source_run(RunKind::replay),
                                    test::lossless())
                        .value();
    links::TlogSource source(links::FileReader::open(log).value(), {{"dvl", 0}, {"gps", 1}});
    run(source, first, recorder.get());
    ASSERT_TRUE(recorder->finish());
  }
  ASSERT_GT(first.told.all.size(), 1000U);
  auto source = SessionSource::open(Session::open(path, Access::read).value(), {{"gps", 1}, {"dvl", 0}});
  ASSERT_TRUE(source) << source.error().line();
  Replayed second;
  run(source.value(), second, nullptr);
  EXPECT_EQ(first.refused, second.refused);
  ASSERT_EQ(first.told.all.size(), second.told.all.size());
  for (std::size_t i = 0; i < first.told.all.size(); ++i) {
    const Envelope &a = first.told.all[i], &b = second.told.all[i];
    ASSERT_TRUE(a.message == b.message) << i << " kind " << a.message.index();
    ASSERT_EQ(first.told.bytes[i], second.told.bytes[i]);
    ASSERT_EQ(a.arrival, b.arrival);
    ASSERT_EQ(a.valid, b.valid);
    ASSERT_EQ(a.source, b.source);
  }
}

/// Two hosts that both call themselves HE0001, in turns.
class TwoSenders final : public Source {
 public:
  bool next(Chunk& chunk) override {
    if (++said_ > 6) return false;
    const bool second = said_ % 2 == 0;
    chunk = Chunk{};
    chunk.source = 1;
    chunk.arrival = {test::kStartNs + said_ * std::int64_t{500'000'000}};
    chunk.bytes = {reinterpret_cast<const std::uint8_t*>(kBytes.data()), kBytes.size()};
    chunk.sender = second ? "10.0.0.9:60004" : "[fe80::1]:60004";
    return true;
  }

 private:
  static constexpr std::string_view kBytes{"UdPbC\0\\s:HE0001*45\\$HEROT,+000.05,A*35\r\n", 40};
  int said_ = 0;
};

TEST(SessionSource, SendersAreKeptSoThatAReplayRaisesTheirAlarm) {
  MadeFolder folder;
  const std::string path = folder.file("s.leadline");
  const auto run_with = [](Source& source, Told& told, Recorder* recorder) {
    Bus bus(infos());
    if (recorder != nullptr) bus.attach(*recorder);
    bus.attach(told);
    bus.attach(1, decode::make_decoder("iec61162-450", {}).value());
    for (Chunk chunk; source.next(chunk);) bus.take(chunk);
  };
  Told first, second;
  {
    auto recorder =
        Recorder::start(Session::create(path, {}).value(), test::two_source_run(), test::lossless()).value();
    TwoSenders source;
    run_with(source, first, recorder.get());
    ASSERT_TRUE(recorder->finish());
  }
  auto source = SessionSource::open(Session::open(path, Access::read).value(), {{"gps", 1}, {"dvl", 0}});
  ASSERT_TRUE(source) << source.error().line();
  run_with(source.value(), second, nullptr);
  ASSERT_EQ(first.all.size(), second.all.size());
  int alarms = 0;
  for (std::size_t i = 0; i < first.all.size(); ++i) {
    EXPECT_TRUE(first.all[i].message == second.all[i].message) << i;
    alarms += std::holds_alternative<Alarm>(second.all[i].message);
  }
  EXPECT_EQ(alarms, 1);
  EXPECT_EQ(std::get<RawFrame>(second.all[0].message).sender.view(), "[fe80::1]:60004");
}

TEST(SessionSource, NamesChooseTheSourceAndUnknownOnesAreSettled) {
  MadeFolder folder;
  test::MessageMaker maker;
  const auto messages = test::mixed_messages(3000, maker);
  const std::string path = folder.file("s.leadline");
  ASSERT_NO_FATAL_FAILURE(test::make_session(path, messages));
  auto source = SessionSource::open(Session::open(path, Access::read).value(), {{"dvl", 7}}).value();
  Chunk chunk;
  for (const auto& kept : messages) {
    if (!std::holds_alternative<RawFrame>(kept.envelope.message)) continue;
    ASSERT_TRUE(source.next(chunk));
    const bool dvl = kept.envelope.source == 0;
    const Heard expected{dvl ? SourceId{7} : kNoSource, kept.envelope.arrival.ns,
                         std::string(kept.bytes.begin(), kept.bytes.end()),
                         dvl ? std::nullopt : std::optional(ByteClass::unknown), ""};
    ASSERT_TRUE(heard(chunk) == expected);
  }
  ASSERT_TRUE(source.next(chunk));
  EXPECT_TRUE(chunk.bytes.empty()) << "how long the run went on";
  EXPECT_EQ(chunk.arrival, messages.back().envelope.arrival);
  EXPECT_FALSE(source.next(chunk));
  EXPECT_FALSE(source.next(chunk));
  EXPECT_FALSE(source.failure());
}

TEST(SessionSource, ARecordingThatWasContinuedIsOneTimeline) {
  MadeFolder folder;
  test::MessageMaker maker;
  const auto messages = test::mixed_messages(100, maker);
  const std::string path = folder.file("s.leadline");
  ASSERT_NO_FATAL_FAILURE(test::make_session(path, messages));
  auto info = test::two_source_run();
  std::swap(info.sources[0], info.sources[1]);  // another order of configuration: names decide
  info.sources[0].info.id = 0, info.sources[1].info.id = 1;
  for (const RunKind kind : {RunKind::record, RunKind::replay}) {
    info.kind = kind;
    auto recorder =
        Recorder::start(Session::open(path, Access::append).value(), info, test::lossless()).value();
    for (const auto& message : messages) recorder->take(message.shown());
    ASSERT_TRUE(recorder->finish());
  }
  auto source =
      SessionSource::open(Session::open(path, Access::read).value(), {{"dvl", 0}, {"gps", 1}}).value();
  EXPECT_EQ(source.runs(), (std::vector<RunId>{1, 2}));
  std::vector<SourceId> places;
  for (Chunk chunk; source.next(chunk);)
    if (!chunk.bytes.empty()) places.push_back(chunk.source);
  ASSERT_EQ(places.size() % 2, 0U);
  for (std::size_t i = 0; i < places.size() / 2; ++i)
    EXPECT_NE(places[i], places[i + places.size() / 2]) << i;

  auto third = SessionSource::open(Session::open(path, Access::read).value(), {}, 3).value();
  EXPECT_EQ(third.runs(), std::vector<RunId>{3});
  EXPECT_FALSE(SessionSource::open(Session::open(path, Access::read).value(), {}, 4));
}

TEST(SessionSource, ASessionWithoutFramesIsSaid) {
  MadeFolder folder;
  { ASSERT_TRUE(Session::create(folder.file("s.leadline"), {})); }
  const auto source = SessionSource::open(Session::open(folder.file("s.leadline"), Access::read).value(), {});
  ASSERT_FALSE(source);
  EXPECT_THAT(source.error().line(), testing::HasSubstr("holds no recorded frames"));
}

}  // namespace
}  // namespace leadline::sessions
