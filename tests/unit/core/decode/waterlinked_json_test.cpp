#include "core/decode/waterlinked_json.h"

#include <gtest/gtest.h>

#include "core/decode/json_reader.h"
#include "tests/unit/core/decode/stream_laws.h"

namespace leadline::test {
namespace {

constexpr double kTiny = 1e-9;

const std::string kVelocity =
    R"({"time":106.3935775756836,"vx":-3.713480691658333e-05,"vy":5.703703573090024e-05,)"
    R"("vz":2.4990416932269e-05,"fom":0.00016016385052353144,"covariance":)"
    R"([[2.4471841442164077e-08,-3.3937477272871774e-09,-1.6659699175747278e-09],)"
    R"([-3.3937477272871774e-09,1.4654466085062268e-08,4.0409570134514183e-10],)"
    R"([-1.6659699175747278e-09,4.0409570134514183e-10,1.5971971523143225e-09]],)"
    R"("altitude":0.4949815273284912,"transducers":[)"
    R"({"id":0,"velocity":0.00010825289791682735,"distance":0.5568000078201294,"rssi":-30.49,"nsd":-88.73,"beam_valid":true},)"
    R"({"id":1,"velocity":-1.4719001228513662e-05,"distance":0.5663000106811523,"rssi":-31.09,"nsd":-89.43,"beam_valid":true},)"
    R"({"id":2,"velocity":2.7863150535267778e-05,"distance":0.537600040435791,"rssi":-27.18,"nsd":-84.47,"beam_valid":true},)"
    R"({"id":3,"velocity":1.9419496311456896e-05,"distance":-1,"rssi":-28.18,"nsd":-86.03,"beam_valid":false}],)"
    R"("velocity_valid":true,"status":0,"format":"json_v3.1","type":"velocity",)"
    R"("time_of_validity":1795350919480000,"time_of_transmission":1795350919500000})"
    "\n";
const std::string kPlace =
    R"({"ts":1795350919.5,"x":12.43,"y":64.6,"z":1.767,"std":0.0015,"roll":0.6173,"pitch":-0.6173,"yaw":0.6,)"
    R"("type":"position_local","status":0,"format":"json_v3.1"})"
    "\r\n";
const std::string kAnswer =
    R"({"response_to":"get_config","success":true,"error_message":"","result":{"speed_of_sound":1475.00,)"
    R"("mounting_rotation_offset":20.00,"acoustic_enabled":true},"format":"json_v3.1","type":"response"})"
    "\n";

Decoded decode(std::string_view text, std::optional<Arrival> arrival = kHeard) {
  return decode_all(*decode::make_waterlinked_json({}), as_bytes(text), arrival);
}

std::string with(std::string_view from, std::string_view to) {
  std::string text = kVelocity;
  const auto at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

TEST(WaterLinkedJson, AVelocityReportGivesItsFacts) {
  const Decoded d = decode(kVelocity);
  EXPECT_EQ(classes(d), "velocity");
  const auto v = d.all<DvlVelocity>().at(0);
  EXPECT_TRUE(v.valid);
  EXPECT_EQ(v.reference, DvlReference::bottom);
  EXPECT_EQ(v.x_mps, -3.713480691658333e-05);
  EXPECT_EQ(v.y_mps, 5.703703573090024e-05);
  EXPECT_EQ(v.z_mps, 2.4990416932269e-05);
  EXPECT_NEAR(*v.sd_mps, 1.5643478e-4, 1e-10);
  EXPECT_EQ(d.all<AltitudeAboveBottom>().at(0).above_bottom_m, 0.4949815273284912);
  EXPECT_EQ(d.all<BeamRanges>().at(0).range_m[1], 0.5663000106811523);
  EXPECT_EQ(d.all<BeamRanges>().at(0).range_m[3], 0.0);
  EXPECT_EQ(d.first<DvlVelocity>()->device_time, parse_iso8601("2026-11-22T12:35:19.480Z"));
  EXPECT_EQ(
      decode(with(R"("type":"velocity")", R"("type":"velocity_water")")).all<DvlVelocity>().at(0).reference,
      DvlReference::water);
}

TEST(WaterLinkedJson, PlacesGiveTiltsAndAnswersNothing) {
  const Decoded d = decode(kPlace + kAnswer);
  EXPECT_EQ(classes(d), "position_local -response");
  ASSERT_EQ(d.facts.size(), 1u);
  EXPECT_NEAR(d.all<Attitude>().at(0).pitch.deg(), -0.6173, kTiny);
  EXPECT_EQ(d.facts[0].device_time, parse_iso8601("2026-11-22T12:35:19.500Z"));
}

TEST(WaterLinkedJson, WithoutValidityThereIsNoLock) {
  for (const std::string& text : {with(R"("velocity_valid":true,)", ""),
                                  with(R"("velocity_valid":true)", R"("velocity_valid":false)")}) {
    const Decoded d = decode(text);
    ASSERT_EQ(d.all<DvlVelocity>().size(), 1u);
    EXPECT_FALSE(d.all<DvlVelocity>()[0].valid);
    EXPECT_EQ(d.all<DvlVelocity>()[0].x_mps, 0.0);
    EXPECT_EQ(d.all<AltitudeAboveBottom>().size(), 0u);
  }
}

TEST(WaterLinkedJson, UnknownMembersArePassedOverAndDepthIsBounded) {
  const std::string deep(6, '['), shut(6, ']');
  EXPECT_EQ(classes(decode(with(R"("status":0)", R"("status":0,"new":{"a":)" + deep + "1" + shut + "}"))),
            "velocity");
  EXPECT_EQ(classes(decode(with(R"("status":0)", R"("status":0,"new":{"a":[)" + deep + "1" + shut + "]}"))),
            "line!syntax");
  EXPECT_EQ(
      classes(decode(with(R"("status":0)", R"("status":0,"x\"\u00e9":null,"vx2":[true,false,null,-1e5])"))),
      "velocity");
  EXPECT_EQ(classes(decode(R"({"type":"news"})"
                           "\n{}\n")),
            "?object ?object");
}

TEST(WaterLinkedJson, WhatDoesNotFitIsRefused) {
  const struct {
    std::string text, expected;
  } cases[] = {
      {with(R"("vx":-3.7)", R"("vx":"-3.7)"), "line!syntax"},
      {with(R"("vx":-3.713480691658333e-05)", R"("vx":"fast")"), "velocity!fields"},
      {with(R"("vx":-3.713480691658333e-05)", R"("vx":null)"), "velocity!fields"},
      {with(R"("vx":-3.713480691658333e-05)", R"("vx":37)"), "velocity!range"},
      {with(R"("vx":-3.713480691658333e-05)", R"("vx":--3)"), "velocity!fields"},
      {with(R"("vx":-3.713480691658333e-05)", R"("vx":1e999)"), "velocity!fields"},
      {with(R"("vx":)", R"("vy":0,"vx":)"), "velocity!fields"},
      {with(R"("velocity_valid":true)", R"("velocity_valid":1)"), "velocity!fields"},
      {with(R"("velocity_valid":true)", R"("velocity_valid":True)"), "line!syntax"},
      {with(R"([-3.3937477272871774e-09,1.4)", R"([1.4)"), "velocity!fields"},
      {with(R"({"id":0)", R"({"id":1)"), "velocity!fields"},
      {with(R"({"id":0)", R"({"id":7)"), "velocity!fields"},
      {with(R"("distance":0.5568000078201294)", R"("distance":5e5)"), "velocity!fields"},
      {kVelocity.substr(0, 700), "line!truncated"},
      {kVelocity.substr(0, 700) + "\n", "line!syntax"},
      {kVelocity.substr(0, kVelocity.size() - 1), "velocity"},
      {kVelocity.substr(0, kVelocity.size() - 1) + "}\n", "line!syntax"},
      {kVelocity.substr(0, kVelocity.size() - 1) + kPlace, "line!syntax"},
      {"{" + std::string(70'000, ' ') + "}\n", "line!too long skipped"},
      {"[1,2]\n\x80\n", "?text skipped"},
  };
  for (const auto& c : cases) {
    const Decoded d = decode(c.text);
    EXPECT_EQ(classes(d), c.expected) << c.text.substr(0, 80);
    EXPECT_TRUE(covers(d, c.text.size()));
    EXPECT_EQ(decode(c.text + "\n" + kPlace).all<Attitude>().size(), 1u) << "the next line is whole";
  }
}

TEST(WaterLinkedJson, ASmallReportObeysTheLawsOfStreams) {
  const std::string small =
      R"({"vx":0.85,"vy":0.12,"vz":0.03,"velocity_valid":true,"altitude":11.02,"type":"velocity"})"
      "\r\n";
  expect_stream_laws([] { return decode::make_waterlinked_json({}); },
                     "tail}\n" + small + "# note\n\r" + kPlace + "\x01\r" + kAnswer.substr(0, 90) + "\n" +
                         small + small.substr(0, 40));
}

TEST(JsonReader, TakesWholeValuesOnly) {
  const auto whole = [](std::string_view text) {
    decode::JsonReader reader(text);
    decode::JsonEvent event;
    while (reader.next(event)) {
    }
    return reader.whole();
  };
  for (const char* good :
       {"{}", "[]", " [1, 2 ,{\"a\":[]}] ", "\"\\u00E9\\n\"", "null", "-1.5e3", "{\"a\":{},\"b\":[[]]}"})
    EXPECT_TRUE(whole(good)) << good;
  for (const char* bad : {"",
                          "{",
                          "[",
                          "]",
                          "{]",
                          "[}",
                          "[1 2]",
                          "[1,]",
                          "{\"a\"}",
                          "{\"a\":}",
                          "{a:1}",
                          "{,}",
                          "[,1]",
                          "{\"a\":1,}",
                          "\"",
                          "\"\\x\"",
                          "\"\\u12g4\"",
                          "tru",
                          "[[[[[[[[[]]]]]]]]]",
                          "1 2",
                          "\"a\tb\""})
    EXPECT_FALSE(whole(bad)) << bad;
}

}  // namespace
}  // namespace leadline::test
