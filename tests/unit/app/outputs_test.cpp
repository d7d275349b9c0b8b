// What an [[output]] sends, heard over loopback and read back by our own decoders.

#include "app/outputs.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/decode/iec61162_450.h"
#include "core/decode/nmea0183.h"
#include "tests/support/decoder_harness.h"
#include "tests/support/peer.h"

namespace leadline::app {
namespace {

using test::Decoded;
using testing::Contains;
using testing::HasSubstr;

constexpr Arrival kStart{1'795'350'919'000'000'000};  // 2026-11-22T12:35:19Z

struct Repeater {
  explicit Repeater(OutputOptions options, const std::string& body = "vehicle") {
    options.link = "udp://127.0.0.1:" + std::to_string(test::port_of(peer));
    configuration.navigation.navigation.body = body;
    configuration.sources.resize(2);
    configuration.sources[0].options = {.name = "dvl", .decoder = "trdi-pd0"};
    configuration.sources[0].mount.z_m = 0.5;
    configuration.sources[1].options = {.name = "gps", .decoder = "nmea0183", .body = "ship"};
    configuration.outputs = {options};
    loop = links::IoLoop::start().value();
    outputs = Outputs::open(*loop, configuration).value();
    EXPECT_TRUE(test::comes_about([&] { return outputs->status()[0].open; }));
  }

  void say(const Message& message, double at_s, SourceId source = kNoSource) {
    Envelope e;
    e.arrival = kStart + duration(at_s);
    e.valid = e.arrival.host() - std::chrono::milliseconds(40);
    e.source = source;
    e.message = message;
    outputs->take(e);
  }
  void solve(double at_s, EngineId engine = 0, Mode mode = Mode::A) {
    Solution s;
    s.engine = engine;
    s.position = {Angle::deg(59.2 + engine * 0.1), Angle::deg(5.2)};
    s.depth = Depth{30.0};
    s.heading = Angle::deg(123.4);
    s.vel_north_mps = 1.0, s.vel_east_mps = 0.0;
    s.mode = mode;
    say(s, at_s);
  }
  void tick(double at_s) { say(Tick{kStart + duration(at_s)}, at_s); }
  /// So many frames, one behind the other.
  std::string frames(int count) {
    std::string all;
    for (int i = 0; i < count; ++i) all += peer.read_some();
    return all;
  }

  test::Peer peer = test::udp_peer();
  Configuration configuration;
  std::unique_ptr<links::IoLoop> loop;
  std::unique_ptr<Outputs> outputs;
};

Decoded heard(const std::string& text) {
  return test::decode_all(*decode::make_nmea0183({}), test::as_bytes(text), kStart);
}

TEST(Outputs, SendTheNewestStateAtTheirRate) {
  Repeater repeater({.name = "r", .sentences = {"GGA", "HDT", "DPT"}, .rate_hz = 2.0});
  repeater.solve(0.0);
  repeater.say(AltitudeAboveBottom{12.0}, 0.0, 0);
  for (int i = 0; i <= 10; ++i) {
    repeater.solve(0.1 * i);
    repeater.tick(0.1 * i);
  }
  const auto d = heard(repeater.frames(9));
  ASSERT_EQ(d.all<GnssFix>().size(), 3u) << "at 0, 0.5 and 1 s";
  EXPECT_NEAR(d.all<GnssFix>()[2].position.lat.deg(), 59.2, 1e-9);
  EXPECT_EQ(d.first<GnssFix>()->device_time, kStart.host() - std::chrono::milliseconds(40));
  EXPECT_NEAR(d.all<Heading>()[0].heading.deg(), 123.4, 1e-9);
  EXPECT_NEAR(d.all<BottomDepth>()[0].depth_m, 42.5, 1e-9) << "30 m down, 0.5 m to the DVL, 12 m below it";
  EXPECT_TRUE(repeater.outputs->finish(std::chrono::seconds(20)));
  const auto status = repeater.outputs->status();
  ASSERT_EQ(status.size(), 1u);
  EXPECT_EQ(status[0].sent_frames, 9u);
  EXPECT_EQ(status[0].dropped_frames, 0u);
  EXPECT_EQ(status[0].name, "r");
}

TEST(Outputs, WhatIsStaleIsSentAsVoid) {
  Repeater repeater({.name = "r", .sentences = {"RMC", "GGA", "HDT"}, .rate_hz = 10.0});
  repeater.tick(0.0);  // nothing is known yet
  for (int i = 0; i < 5; ++i) repeater.solve(0.05 + 0.1 * i);
  repeater.tick(1.4);  // 0.95 s old
  repeater.tick(1.5);  // 1.05 s old
  const std::string never = repeater.frames(3), fresh = repeater.frames(3), stale = repeater.frames(3);
  for (const std::string& is_void : {never, stale}) {
    EXPECT_THAT(is_void, HasSubstr(",V,,,,,,,"));
    EXPECT_THAT(is_void, HasSubstr(",,,,,0,"));
    EXPECT_THAT(is_void, HasSubstr("$INHDT,,T*"));
    const auto d = heard(is_void);
    EXPECT_EQ(d.all<GnssFix>().size() + d.all<Course>().size() + d.all<Heading>().size(), 0u);
  }
  EXPECT_THAT(fresh, HasSubstr(",A,5912.0000000,N,"));
  EXPECT_EQ(heard(fresh).all<GnssFix>().size(), 1u);
}

TEST(Outputs, ASlowSourceIsStaleAfterThreeOfItsIntervals) {
  Repeater repeater({.name = "r", .sentences = {"RMC"}, .rate_hz = 10.0});
  for (int i = 0; i < 3; ++i) repeater.solve(1.0 * i);
  repeater.tick(4.9);
  repeater.tick(5.1);
  EXPECT_EQ(heard(repeater.frames(1)).all<GnssFix>().size(), 1u);
  EXPECT_EQ(heard(repeater.frames(1)).all<GnssFix>().size(), 0u);
}

TEST(Outputs, TheShipIsHerOwnTrackUnlessNavigationFollowsHer) {
  Repeater beside({.name = "r", .sentences = {"GGA"}, .rate_hz = 10.0, .body = "ship"});
  beside.solve(0.0, 0);
  beside.solve(0.0, kShipTrack);
  beside.tick(0.1);
  EXPECT_NEAR(heard(beside.frames(1)).all<GnssFix>()[0].position.lat.deg(), 59.2 + 25.5, 1e-9);
  Repeater followed({.name = "r", .sentences = {"GGA"}, .rate_hz = 10.0, .body = "ship"}, "ship");
  followed.solve(0.0, 0);
  followed.solve(0.0, kShipTrack);
  followed.tick(0.1);
  EXPECT_NEAR(heard(followed.frames(1)).all<GnssFix>()[0].position.lat.deg(), 59.2, 1e-9);
}

TEST(Outputs, SendDatagramsOfIec61162450) {
  Repeater repeater({.name = "r",
                     .format = "iec61162-450",
                     .sfi = "IN0007",
                     .destination = "NV0001",
                     .sentences = {"GGA", "HDT"},
                     .rate_hz = 10.0});
  repeater.solve(0.0);
  for (int i = 0; i < 3; ++i) repeater.tick(0.1 * i);
  const std::string one = repeater.frames(1);
  EXPECT_THAT(one, HasSubstr("s:IN0007,d:NV0001,n:0*"));
  const std::string all = one + repeater.frames(2);
  const auto d = test::decode_all(*decode::make_iec61162_450({}), test::as_bytes(all), kStart);
  EXPECT_EQ(d.all<Heading>().size(), 3u);
  EXPECT_EQ(d.ledger.lost(), 0u);
  EXPECT_EQ(d.ledger.refusals().size(), 0u);
}

TEST(Outputs, AreCheckedWithTheConfiguration) {
  const std::string head = "version = 1\n[[source]]\nname = \"a\"\ndecoder = \"nmea0183\"\n";
  const struct {
    std::string text, problem;
  } cases[] = {
      {"link = \"udp://127.0.0.1\"\nsentences = [\"GGA\"]\n", "f.toml:7: output \"r\".link: "},
      {"sentences = [\"GGA\"]\n", "output \"r\".link: is required"},
      {"link = \"udp://127.0.0.1:1\"\n", "output \"r\".sentences: names none"},
      {"link = \"udp://127.0.0.1:1\"\nsentences = [\"GGX\"]\n", "f.toml:8: output \"r\".sentences"},
      {"link = \"udp://127.0.0.1:1\"\nsentences = [\"GGA\"]\nbody = \"buoy\"\n",
       "f.toml:9: output \"r\".body: "},
      {"link = \"udp://127.0.0.1:1\"\nsentences = [\"GGA\"]\nbody = \"ship\"\n",
       "output \"r\".body: no [[source]]"},
      {"link = \"tcp://127.0.0.1:1\"\nsentences = [\"GGA\"]\nformat = \"iec61162-450\"\n",
       "f.toml:7: output \"r\".link: iec61162-450 goes over udp"},
      {"link = \"udp://127.0.0.1:1\"\nsentences = [\"GGA\"]\nformat = \"iec61162-450\"\nsfi = \"in1\"\n",
       "f.toml:10: output \"r\".sfi: must be two"},
  };
  for (const auto& c : cases) {
    const auto loaded =
        parse_configuration(head + "[[output]]\nname = \"r\"\n" + c.text, "f.toml", PluginHost());
    EXPECT_THAT(loaded.problems, Contains(HasSubstr(c.problem)));
  }
  const auto good = parse_configuration(
      head + "[[output]]\nname = \"r\"\nlink = \"udp://127.0.0.1:1\"\nsentences = [\"GGA\"]\n", "f.toml",
      PluginHost());
  for (const auto& problem : good.problems) EXPECT_THAT(problem, testing::Not(HasSubstr("output")));
}

}  // namespace
}  // namespace leadline::app
