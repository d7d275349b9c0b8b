#include "core/decode/trdi_pd6.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>

#include "tests/support/decoder_harness.h"
#include "tests/support/files.h"

namespace leadline::test {
namespace {

constexpr double kTiny = 1e-9;
constexpr Arrival kArrival{1'795'350'919'600'000'000};  // 2026-11-22T12:35:19.6Z

Decoded decode_pd6(std::string_view text, std::size_t chunk = 0, std::optional<Arrival> arrival = kArrival) {
  return decode_all(*decode::make_trdi_pd6({}), as_bytes(text), arrival, chunk);
}

std::string sample() { return read_text(data_path("wire-samples/pd6.txt")); }
std::string invalid() { return read_text(data_path("wire-samples/pd6_invalid.txt")); }

/// The sample with one text put for another.
std::string with(std::string_view from, std::string_view to) {
  std::string text = sample();
  const auto at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

/// Kind and what became of it, of each report: "SA TS BI -BS" (- unused, !reason refused, ? other).
std::string classes(const Decoded& d) {
  std::string text;
  for (const FrameReport& f : d.frames) {
    if (!text.empty()) text += ' ';
    if (f.byte_class == ByteClass::unused) text += '-';
    if (f.byte_class == ByteClass::unknown || f.byte_class == ByteClass::skipped) text += '?';
    text += f.kind;
    if (f.byte_class == ByteClass::refused) text += "!" + std::string(f.reason);
  }
  return text;
}

bool covers(const Decoded& d, std::size_t size) {
  std::uint64_t covered = 0;
  for (const FrameReport& f : d.frames) {
    if (f.offset != covered || f.length == 0) return false;
    covered += f.length;
  }
  return covered == size;
}

// --- the samples of wire-formats 4 ---

TEST(Pd6, TheSampleGivesItsFactsInOrder) {
  const Decoded d = decode_pd6(sample());
  const Time time = *parse_iso8601("2026-11-22T12:35:19.500Z");
  const Message order[] = {ClockReading{},        Heading{},    Attitude{}, SoundSpeed{}, DepthMeasured{},
                           AltitudeAboveBottom{}, DvlVelocity{}};
  ASSERT_EQ(d.facts.size(), std::size(order));
  for (std::size_t i = 0; i < std::size(order); ++i) {
    EXPECT_EQ(d.facts[i].message.index(), order[i].index()) << i;
    EXPECT_EQ(d.facts[i].device_time, time) << i;
  }
  EXPECT_EQ(d.all<ClockReading>()[0].device_ns, time.ns);
  EXPECT_NEAR(d.all<Heading>()[0].heading.deg(), 96.03, kTiny);
  EXPECT_NEAR(d.all<Attitude>()[0].pitch.deg(), -2.30, kTiny);
  EXPECT_NEAR(d.all<Attitude>()[0].roll.deg(), 1.40, kTiny);
  EXPECT_EQ(d.all<SoundSpeed>()[0].speed_mps, 1490.0);
  EXPECT_NEAR(d.all<DepthMeasured>()[0].depth.m, 118.4, kTiny);
  EXPECT_NEAR(d.all<AltitudeAboveBottom>()[0].above_bottom_m, 11.02, kTiny);
  EXPECT_EQ(classes(d), "SA TS BI -BS -BE BD");
  EXPECT_TRUE(covers(d, sample().size()));
}

struct Case {
  const char* name;
  std::string text;
  bool told, valid;
  DvlFrame frame;
  double x_mps, y_mps, z_mps;
};

TEST(Pd6, VelocitiesAreTheVehiclesForwardStarboardDown) {
  const std::string bs = ":BS,  +120,  +850,   -30,A\r\n", be = ":BE,  +833,  -209,   -30,A\r\n";
  const Case cases[] = {
      {"sample", sample(), true, true, DvlFrame::instrument, 0.850, 0.120, 0.030},
      {"no lock", invalid(), true, false, DvlFrame::instrument, 0, 0, 0},
      {"ship alone", bs, true, true, DvlFrame::ship, 0.850, 0.120, 0.030},
      {"ship before earth", bs + be, true, true, DvlFrame::ship, 0.850, 0.120, 0.030},
      {"earth alone", be, true, true, DvlFrame::earth, -0.209, 0.833, 0.030},
      {"real, Water Linked",
       ":BI,  +123,  -420, +2000,    +0,A\r\n:BS,  -420,  +123, +2000,A\r\n"
       ":BD,       +0.00,       +0.00,       +0.00,   5.32,  0.00\r\n",
       true, true, DvlFrame::instrument, 0.123, -0.420, 2.000},
      {"Water Linked before BS was filled, TRDI's axes",
       ":BI,  +123,  -420, +2000,    +0,A\r\n:BS,     0,     0,     0,A\r\n", true, true,
       DvlFrame::instrument, -0.420, 0.123, -2.000},
      {"real, NavQuest 600",
       ":WI,+00000,+00000,+00000,+00000,I\r\n:BI,+00000,-02345,-00439,+00000,A\r\n"
       ":BD,+00000000.00,+00000000.00,+00000000.00,0000.40,000.00\r\n",
       true, true, DvlFrame::instrument, -2.345, 0.0, 0.439},
      {"no sign, no padding", ":BI,120,850,-30,4,A\n", true, true, DvlFrame::instrument, 0.850, 0.120, 0.030},
      {"bad BI, zero BS called good", ":BI,-32768,-32768,-32768,-32768,V\n:BS,0,0,0,A\n", true, false,
       DvlFrame::instrument, 0, 0, 0},
      {"I is bad", ":BI,  +120,  +850,   -30,    +4,I\n", true, false, DvlFrame::instrument, 0, 0, 0},
      {"one component missing", ":BI,  +120,-32768,   -30,    +4,A\n", true, false, DvlFrame::instrument, 0,
       0, 0},
      {"BI and BS disagree by 6 mm/s", ":BI,0,850,0,0,A\n:BS,0,856,0,A\n", false, false, DvlFrame::instrument,
       0, 0, 0},
      {"BI and BS disagree by 5 mm/s", ":BI,0,850,0,0,A\n:BS,0,855,0,A\n", true, true, DvlFrame::instrument,
       0.85, 0, 0},
  };
  for (const Case& c : cases) {
    const Decoded d = decode_pd6(c.text);
    const auto all = d.all<DvlVelocity>();
    ASSERT_EQ(all.size(), c.told ? 1u : 0u) << c.name;
    EXPECT_TRUE(covers(d, c.text.size())) << c.name;
    if (!c.told) continue;
    EXPECT_EQ(all[0].reference, DvlReference::bottom) << c.name;
    EXPECT_EQ(all[0].valid, c.valid) << c.name;
    EXPECT_EQ(all[0].frame, c.frame) << c.name;
    EXPECT_EQ(all[0].tilt_applied, c.frame != DvlFrame::instrument) << c.name;
    EXPECT_NEAR(all[0].x_mps, c.x_mps, kTiny) << c.name;
    EXPECT_NEAR(all[0].y_mps, c.y_mps, kTiny) << c.name;
    EXPECT_NEAR(all[0].z_mps, c.z_mps, kTiny) << c.name;
  }
}

TEST(Pd6, WhatIsNotSentOrNotFilledIsNotTold) {
  const Decoded none = decode_pd6(invalid());
  EXPECT_EQ(none.facts.size(), 2u);  // sound speed and a ping without lock
  EXPECT_FALSE(none.facts[0].device_time) << "a clock of zeros is none";
  EXPECT_EQ(classes(none), "TS -WI BI -BD");
  EXPECT_EQ(decode_pd6(with(":SA, -2.30, +1.40, 96.03", ":SA,+0.00,+0.00,0.00")).all<Heading>().size(), 0u);
  EXPECT_EQ(decode_pd6(with("11.02,  0.00", "11.02,  0.20")).all<AltitudeAboveBottom>().size(), 0u)
      << "the range of a ping before";
  EXPECT_FALSE(decode_pd6(with("    +4,A", "-32768,A")).all<DvlVelocity>()[0].error_mps);
  EXPECT_NEAR(*decode_pd6(sample()).all<DvlVelocity>()[0].error_mps, 0.004, kTiny);
}

TEST(Pd6, EarthVelocitiesCarryTheAttitudeThatMadeThem) {
  std::string text = sample();
  text.erase(text.find(":BI"), text.find(":BE") - text.find(":BI"));
  const auto v = decode_pd6(text).all<DvlVelocity>();
  ASSERT_EQ(v.size(), 1u);
  ASSERT_TRUE(v[0].applied);
  EXPECT_NEAR(v[0].applied->heading.deg(), 96.03, kTiny);
  EXPECT_NEAR(v[0].applied->pitch.deg(), -2.30, kTiny);
}

TEST(Pd6, ShipVelocityIsLevelUnlessEarthHasAnotherThirdAxis) {
  EXPECT_FALSE(decode_pd6(":BS,100,850,-30,A\n:BE,850,100,-27,A\n").all<DvlVelocity>()[0].tilt_applied);
  EXPECT_TRUE(decode_pd6(":BS,100,850,-30,A\n:BE,850,100,-29,A\n").all<DvlVelocity>()[0].tilt_applied);
}

TEST(Pd6, AxesOfAWaterLinkedAreKnownFromBsAndKept) {
  const std::string mirrored = ":BI,300,100,-50,0,A\n:BS,100,300,-50,A\n", alone = ":BI,300,100,-50,0,A\n";
  const auto v = decode_pd6(mirrored + alone).all<DvlVelocity>();
  ASSERT_EQ(v.size(), 2u);
  for (const auto& each : v) {
    EXPECT_NEAR(each.x_mps, 0.3, kTiny);
    EXPECT_NEAR(each.z_mps, -0.05, kTiny);
  }
  const auto turned = decode_pd6(":BI,300,100,-50,0,A\n:BS,141,283,-50,A\n" + mirrored).all<DvlVelocity>();
  EXPECT_NEAR(turned[1].x_mps, 0.1, kTiny) << "an alignment, by chance a mirror image later";
}

TEST(Pd6, WaterVelocitiesAndPd13RangesAreTold) {
  const Decoded d = decode_pd6(
      ":TS,26112212351950,35.0, +8.3, 118.4,1490.0,  0\r\n:RA,1184.00, 110, 111,   0, 110\r\n"
      ":WI,  +100,  +800,   -10,    +0,A\r\n:WD,     +120.52,     -884.10,       -2.31,  11.02,  0.00\r\n"
      ":BI,  +120,  +850,   -30,    +4,A\r\n");
  const auto v = d.all<DvlVelocity>();
  ASSERT_EQ(v.size(), 2u);
  EXPECT_EQ(v[1].reference, DvlReference::water);
  EXPECT_NEAR(v[1].x_mps, 0.8, kTiny);
  EXPECT_NEAR(d.all<Pressure>()[0].gauge_pa, 1'184'000.0, kTiny);
  EXPECT_NEAR(d.all<BeamRanges>()[0].range_m[1], 11.1, kTiny);
  EXPECT_EQ(d.all<BeamRanges>()[0].range_m[2], 0.0);
  EXPECT_EQ(classes(d), "TS RA WI -WD BI");
}

TEST(Pd6, TroubleIsToldOnce) {
  const std::string ping = with("1490.0,  0", "1490.0, 17");
  EXPECT_EQ(decode_pd6(ping + ping).all<Health>().size(), 1u);
  const std::string leak = ":HM,G,L,0A1B,0C2D,12.345,1.234,25.00\r\n",
                    dry = ":HM,G,G,0A1B,0C2D,12.345,1.234,25.00\r\n";
  const Decoded d = decode_pd6(dry + leak + leak);
  EXPECT_EQ(d.all<Health>().size(), 1u);
  EXPECT_EQ(classes(d), "HM HM HM");
}

TEST(Pd6, ADateThatIsGpsWeeksOffIsNotGoneBy) {
  const Decoded d = decode_pd6(with("261122", "070408"));  // 1024 weeks before
  EXPECT_EQ(d.all<ClockReading>().size(), 0u);
  EXPECT_EQ(d.all<Health>().size(), 1u);
  EXPECT_FALSE(d.first<DvlVelocity>()->device_time);
}

// --- pings and damage ---

TEST(Pd6, APingEndsAtBdOrWhereTheNextBegins) {
  const std::string bd = ":BD,";
  std::string without = sample();
  without.erase(without.find(bd));
  const Decoded d = decode_pd6(without + without);
  EXPECT_EQ(d.all<DvlVelocity>().size(), 2u);
  const auto decoder = decode::make_trdi_pd6({});
  Decoded out;
  decoder->feed(as_bytes(without), kArrival, out);
  EXPECT_EQ(out.facts.size(), 0u);
  decoder->feed(as_bytes(":SA, -2.30, +1.40, 96.03\r\n"), kArrival, out);
  EXPECT_EQ(out.all<DvlVelocity>().size(), 1u);
}

TEST(Pd6, DamageRefusesWhatFollowsInItsPing) {
  const struct {
    std::string text, expected;
    std::size_t velocities;
  } cases[] = {
      {with(":TS,26112212351950", ":TS,2611221235195x"), "SA TS!fields BI!group BS!group BE!group BD!group",
       0},
      {with(":TS,261122", ":TS,261322"), "SA TS!range BI -BS -BE BD", 1},
      {with(" -2.30, +1.40", " -2.30, +1.4x"), "SA!fields TS BI -BS -BE BD", 1},
      {with(" -2.30, +1.40", "-92.30, +1.40"), "SA!range TS BI -BS -BE BD", 1},
      {with("  +850,   -30,    +4,A\r\n", "  +85"), "SA TS BI!torn BS!group BE!group BD!group", 0},
      {with(":BI,  +120", ":BI,+17120"), "SA TS BI!range BS -BE BD", 1},
      {with(":BI,  +120", ":BI,  +160"), "SA TS BI!inconsistent BS!inconsistent BE!inconsistent BD", 0},
      {with(":BI,  +120",
            ":BI,  +1\x01"
            "0"),
       "SA TS BI!not printable BS!group BE!group BD!group", 0},
      {with(":BE,", "garbage\r\n:BE,"), "SA TS BI -BS ?text BE!group BD!group", 1},
      {with(":BE,", ":XY,1\r\n:BE,"), "SA TS BI -BS ?line -BE BD", 1},
      {with(":BE,", "\r\n:BE,"), "SA TS BI -BS  -BE BD", 1},
      {with("  0.00\r\n", "  0.0"), "SA TS BI -BS -BE BD!truncated", 1},
      {sample() + "\r\n# note\r\n", "SA TS BI -BS -BE BD  ", 1},
  };
  for (const auto& c : cases) {
    const Decoded d = decode_pd6(c.text);
    EXPECT_EQ(classes(d), c.expected);
    EXPECT_EQ(d.all<DvlVelocity>().size(), c.velocities) << c.expected;
    EXPECT_TRUE(covers(d, c.text.size())) << c.expected;
    const Decoded after = decode_pd6(c.text + "\r\n" + sample());
    EXPECT_EQ(after.all<DvlVelocity>().size(), c.velocities + 1) << "the next ping is whole: " << c.expected;
  }
}

TEST(Pd6, NumbersAreDecimalDigitsOnly) {
  for (const char* bad : {"   nan", "   inf", "  1e2", "  0x1F", "1 2", "", "+ 120", "?120"})
    EXPECT_EQ(decode_pd6(":BI," + std::string(bad) + ",  +850,   -30,    +4,A\r\n").facts.size(), 0u) << bad;
  for (const char* bad :
       {":BI,1,2,3,4\n", ":BI,1,2,3,4,A,5\n", ":BI,1,2,3,4,a\n", ":BI\n", ":BS,1,2,3,4,A\n"})
    EXPECT_EQ(decode_pd6(bad).facts.size(), 0u) << bad;
}

TEST(Pd6, OverlongLinesAreToldInPieces) {
  const std::string text =
      ":BI," + std::string(300, ' ') + "1,2,3,4,A\r\n" + std::string(200'000, 'x') + "\n" + sample();
  const Decoded d = decode_pd6(text);
  EXPECT_TRUE(covers(d, text.size()));
  EXPECT_EQ(d.frames[0].reason, "too long");
  EXPECT_EQ(d.frames[0].length, 256u);
  EXPECT_EQ(d.all<DvlVelocity>().size(), 1u);
}

std::string mixed() {
  return "tail of a ping,A\r\n" + sample() + "\n# note\r" + invalid() + with("\r\n:BI", "\r:BI") +
         with(":BS,  +120,  +850", ":BS,  +12") + with(":BE", "\x01\x02\r\n:BE") + ":HM,G,L,1,2,3,4,5\n" +
         sample() + ":BI," + std::string(300, '7') + "\r\n" + sample().substr(0, 100);
}

TEST(Pd6, EverySplitInTwoGivesTheSame) {
  const std::string text = mixed();
  const Decoded whole = decode_pd6(text);
  EXPECT_TRUE(covers(whole, text.size()));
  EXPECT_EQ(whole.all<DvlVelocity>().size(), 6u);
  for (std::size_t cut = 1; cut < text.size(); ++cut) {
    const auto decoder = decode::make_trdi_pd6({});
    Decoded parts;
    decoder->feed(as_bytes(std::string_view(text).substr(0, cut)), kArrival, parts);
    decoder->feed(as_bytes(std::string_view(text).substr(cut)), kArrival, parts);
    decoder->finish(parts);
    ASSERT_TRUE(same(whole, parts)) << "cut at " << cut;
  }
  for (const std::size_t chunk : {1, 2, 3, 7, 64, 255, 256, 257})
    ASSERT_TRUE(same(whole, decode_pd6(text, chunk)));
}

TEST(Pd6, RandomEditsLoseNoByteAndMakeNoImpossibleVelocity) {
  std::mt19937 random(1);
  for (int round = 0; round < 300; ++round) {
    std::string text = mixed() + mixed();
    for (char& c : text)
      if (random() % 60 == 0) c = static_cast<char>(random());
    const Decoded d = decode_pd6(text);
    ASSERT_TRUE(covers(d, text.size())) << round;
    for (const auto& v : d.all<DvlVelocity>())
      ASSERT_LE(std::hypot(v.x_mps, v.y_mps, v.z_mps), 16.0 * std::sqrt(3.0));
  }
}

}  // namespace
}  // namespace leadline::test
