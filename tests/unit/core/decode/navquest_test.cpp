#include "core/decode/navquest.h"

#include <gtest/gtest.h>

#include "tests/unit/core/decode/stream_laws.h"

namespace leadline::test {
namespace {

constexpr double kTiny = 1e-9;

const std::string kReal =
    "$#NQ.RES 0X0000 1 1 1 1 4.3 4.5 4.3 4.2 11.1 49.9 52.4 42.4 0 0 0 0 0 0 0 0 -55.1 10.0 42.0 1 -55.1 "
    "10.0 "
    "42.0 1 0 0 0 0 0 0 0 0 0 0 0 4.2 15.0 65.882 35.0 1500 74\r\n";

Decoded decode(std::string_view text, const decode::ProfileOptions& profile = {}) {
  return decode_all(*decode::make_navquest({}, profile), as_bytes(text), kHeard);
}

/// The real line with one token, counted from 0, put for another.
std::string with(std::size_t token, std::string_view value) {
  std::string text = kReal;
  std::size_t at = 0;
  for (; token > 0; --token) at = text.find(' ', at) + 1;
  return text.replace(at, text.find_first_of(" \r", at) - at, value);
}

TEST(NavQuest, TheRealLineHasItsDocumentedValues) {
  const decode::ProfileOptions own{.navquest_velocity = "vehicle"};
  const Decoded d = decode(kReal, own);
  EXPECT_EQ(classes(d), "NQ.RES");
  const auto v = d.all<DvlVelocity>().at(0);
  EXPECT_TRUE(v.valid);
  EXPECT_EQ(v.reference, DvlReference::bottom);
  EXPECT_EQ(v.frame, DvlFrame::instrument);
  EXPECT_NEAR(v.x_mps, -0.0551, kTiny);
  EXPECT_NEAR(v.y_mps, 0.0100, kTiny);
  EXPECT_NEAR(v.z_mps, 0.0420, kTiny);
  EXPECT_EQ(d.all<AltitudeAboveBottom>().at(0).above_bottom_m, 4.2);
  EXPECT_EQ(d.all<SoundSpeed>().at(0).speed_mps, 1500.0);
  EXPECT_EQ(d.all<BeamRanges>().at(0).range_m, (std::array<double, 4>{4.3, 4.5, 4.3, 4.2}));
  EXPECT_EQ(d.all<Heading>().size(), 0u) << "all zero is not filled";
  EXPECT_FALSE(d.first<DvlVelocity>()->device_time);
}

TEST(NavQuest, ItsVelocityIsTheBottomsUnlessTheProfileSaysTheVehicles) {
  const auto v = decode(kReal).all<DvlVelocity>().at(0);
  EXPECT_NEAR(v.x_mps, 0.0551, kTiny);
  EXPECT_NEAR(v.y_mps, -0.0100, kTiny);
  EXPECT_NEAR(v.z_mps, -0.0420, kTiny);
}

TEST(NavQuest, FlagsSayOverWhatAndWhetherAtAll) {
  EXPECT_EQ(decode(with(25, "2")).all<DvlVelocity>().at(0).reference, DvlReference::water);
  const auto none = decode(with(25, "0")).all<DvlVelocity>().at(0);
  EXPECT_FALSE(none.valid);
  EXPECT_EQ(none.reference, DvlReference::bottom);
  EXPECT_EQ(none.x_mps, 0.0);
  EXPECT_EQ(decode(with(41, "-1")).all<AltitudeAboveBottom>().size(), 0u) << "negative is invalid";
  EXPECT_EQ(decode(with(6, "-1")).all<BeamRanges>().at(0).range_m[0], 0.0);
  EXPECT_EQ(decode(with(5, "0")).all<BeamRanges>().at(0).range_m[3], 0.0);
}

TEST(NavQuest, AttitudeIsToldWhenFilledAndErrorsOnce) {
  const Decoded d = decode(with(40, "96.03"));
  EXPECT_NEAR(d.all<Heading>().at(0).heading.deg(), 96.03, kTiny);
  EXPECT_EQ(d.all<Attitude>().at(0).roll.deg(), 0.0);
  const std::string failing = with(1, "0X0004");
  EXPECT_EQ(decode(failing + failing + kReal + failing).all<Health>().size(), 2u);
}

TEST(NavQuest, ALineThatIsNotWholeOrNotLegalIsRefused) {
  const struct {
    std::string text, reason;
  } cases[] = {
      {with(22, "-?13713"), "fields"},
      {with(23, "-?50937"), "fields"},
      {with(22, "-55.1 0"), "fields"},
      {with(22, "1e3"), "fields"},
      {with(22, "nan"), "fields"},
      {with(22, "20001"), "range"},
      {with(25, "3"), "range"},
      {with(25, "0.5"), "range"},
      {with(2, "2"), "range"},
      {with(40, "361"), "range"},
      {with(18, "51"), "range"},
      {with(1, "0000"), "fields"},
      {with(1, "0X00G0"), "fields"},
      {with(46, "7.4"), "fields"},
      {kReal.substr(0, kReal.size() - 5) + "\r\n", "fields"},
      {kReal.substr(0, kReal.size() - 2), "truncated"},
      {"$#NQ\r\n", "truncated"},
      {"$#NQ.RES" + std::string(1100, ' ') + "\r\n", "too long"},
      {"$#NQ.RES\x01\r\n", "not printable"},
  };
  for (const auto& c : cases) {
    const Decoded d = decode(c.text);
    ASSERT_FALSE(d.frames.empty());
    EXPECT_EQ(d.frames[0].reason, c.reason) << c.text;
    EXPECT_EQ(d.facts.size(), 0u) << c.text;
    EXPECT_EQ(decode(c.text + "\r\n" + kReal).frames.back().byte_class, ByteClass::decoded)
        << "the next is whole: " << c.text;
  }
}

TEST(NavQuest, ALineBehindATornOneIsFound) {
  const Decoded d = decode(kReal.substr(0, 50) + kReal + "hello\r\n");
  EXPECT_EQ(classes(d), "skipped NQ.RES ?text");
  EXPECT_EQ(d.all<DvlVelocity>().size(), 1u);
}

TEST(NavQuest, ObeysTheLawsOfStreams) {
  expect_stream_laws([] { return decode::make_navquest({}); }, "4.2 15.0 74\r\n" + kReal + "\r" +
                                                                   kReal.substr(0, 60) + kReal +
                                                                   "# note\n\x01\n" + kReal.substr(0, 90));
}

}  // namespace
}  // namespace leadline::test
