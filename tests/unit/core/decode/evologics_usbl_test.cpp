#include "core/decode/evologics_usbl.h"

#include <gtest/gtest.h>

#include "tests/support/files.h"
#include "tests/unit/core/decode/decoder_laws.h"

namespace leadline::test {
namespace {

constexpr Arrival kArrival{1'795'350'919'700'000'000};
constexpr double kTiny = 1e-9;

const std::string kMade =
    "+++AT:143:USBLLONG,1795350919.661000,1795350919.500000,7,12.5000,-30.2500,-118.4000,-5.1095,-32.3296,"
    "-118.4000,0.0000,0.0000,-0.5486,82445,-42,130,0.6000\r\n";
const std::string kBoot =
    "+++AT:124:USBLLONG,10446.991981,10446.534643,3,-0.0604,-1.0888,-0.5851,-0.4233,-1.0020,-0.5901,0.0063,"
    "0.0269,-0.3295,825,-36,77,1.0375\r\n";
const std::string kReal =
    "+++AT:132:USBLLONG,1325384364.662679,1325384364.401149,2,0.0234,0.3407,-0.1417,-0.3286,0.0800,-0.1494,"
    "-0.0178,0.1164,1.3498,247,-16,388,0.0116\r\n";

std::unique_ptr<Decoder> make() { return decode::make_evologics_usbl({}); }
Decoded decode_text(const std::string& text, std::optional<Arrival> arrival = kArrival) {
  return decode_all(*make(), as_bytes(text), arrival);
}
std::string notification(const std::string& body, std::size_t counted_more = 0) {
  return "+++AT:" + std::to_string(body.size() + counted_more) + ":" + body + "\r\n";
}

TEST(EvologicsUsbl, TheSamplesGiveTheirDocumentedValues) {
  const struct {
    const std::string& line;
    const char* transponder;
    double north_m, east_m, down_m;
  } cases[] = {{kMade, "7", -32.3296, -5.1095, 118.4},
               {kBoot, "3", -1.0020, -0.4233, 0.5901},
               {kReal, "2", 0.08, -0.3286, 0.1494}};
  for (const auto& c : cases) {
    const Decoded d = decode_text(c.line);
    ASSERT_EQ(d.frames.size(), 1u) << c.line;
    EXPECT_EQ(d.frames[0].kind, "USBLLONG");
    EXPECT_EQ(d.frames[0].byte_class, ByteClass::decoded);
    const auto u = d.all<UsblRelative>().at(0);
    EXPECT_EQ(u.transponder.view(), c.transponder);
    EXPECT_EQ(u.axes, UsblAxes::north_up);
    EXPECT_NEAR(u.x_m, c.north_m, kTiny);
    EXPECT_NEAR(u.y_m, c.east_m, kTiny);
    EXPECT_NEAR(*u.down_m, c.down_m, kTiny);
    EXPECT_FALSE(u.sd_m) << "the unit of the accuracy is not public";
  }
}

TEST(EvologicsUsbl, AFixIsValidWhenItWasMeasured) {
  const Decoded made = decode_text(kMade);
  EXPECT_EQ(made.first<UsblRelative>()->device_time, from_unix(1795350919.5));
  EXPECT_EQ(made.all<ClockReading>().at(0).device_ns, from_unix(1795350919.661).ns);
  const Decoded boot = decode_text(kBoot);
  EXPECT_NEAR(seconds(kArrival.host() - *boot.first<UsblRelative>()->device_time), 0.457338, 1e-8);
  EXPECT_TRUE(boot.all<ClockReading>().empty()) << "its clock counts from the start";
  EXPECT_FALSE(decode_text(kBoot, {}).first<UsblRelative>()->device_time);
}

TEST(EvologicsUsbl, ItsNorthIsTalkedOfOnce) {
  EXPECT_EQ(decode_text(kMade + kMade).all<Health>().size(), 1u);
}

TEST(EvologicsUsbl, OnlyTheWantedTransponderMakesFacts) {
  DecoderSettings settings;
  settings.address = "2";
  const Decoded d = decode_all(*decode::make_evologics_usbl(settings), as_bytes(kMade + kReal), kArrival);
  EXPECT_EQ(d.all<UsblRelative>().size(), 1u);
  EXPECT_EQ(d.frames.at(0).byte_class, ByteClass::unused);
  EXPECT_EQ(d.frames.at(1).byte_class, ByteClass::decoded);
}

TEST(EvologicsUsbl, NotificationsAreFoundByLengthAmongUserData) {
  const std::string body = kMade.substr(10, kMade.size() - 12);
  const std::string counted = notification(body, 2);
  const std::string binary = notification(std::string("RECVIM,3,1,2,noack,0.5,-30,99,0.1,+++\r\n", 40));
  const std::string text = "user +++ data\r\n+++AT" + kMade + counted + binary + notification("NEWTHING,1");
  const Decoded d = decode_text(text);
  ASSERT_EQ(d.frames.size(), 5u);
  EXPECT_EQ(d.frames[0].byte_class, ByteClass::skipped);
  EXPECT_EQ(d.frames[1].byte_class, ByteClass::decoded);
  EXPECT_EQ(d.frames[2].byte_class, ByteClass::decoded) << "a length that counts CR LF";
  EXPECT_EQ(d.frames[3].kind, "RECVIM");
  EXPECT_EQ(d.frames[3].byte_class, ByteClass::unused);
  EXPECT_EQ(d.frames[4].byte_class, ByteClass::unknown);
  EXPECT_EQ(d.all<UsblRelative>().size(), 2u);
  EXPECT_TRUE(covers(d, text.size()));
}

TEST(EvologicsUsbl, AWrongLengthIsRefusedAndTheNextOneFound) {
  for (const std::string length : {"142", "144", "141", "9", "0", "", "999999", "99999", "8193"}) {
    const std::string text = "+++AT:" + length + kMade.substr(9) + kReal;
    const Decoded d = decode_text(text);
    ASSERT_EQ(d.all<UsblRelative>().size(), 1u) << length;
    EXPECT_EQ(d.all<UsblRelative>()[0].transponder.view(), "2") << length;
    EXPECT_TRUE(covers(d, text.size()));
    EXPECT_EQ(d.frames.at(0).byte_class, ByteClass::refused) << length;
  }
}

TEST(EvologicsUsbl, FieldsThatAreNoneAreRefused) {
  const std::string head = "USBLLONG,100.5,100.0,7,1,2,-3,", tail = ",0,0,0,82445,-42,130,0.6";
  const struct {
    std::string body;
    const char* reason;
  } cases[] = {{head + "1,2,-3" + tail, ""},
               {head + "1,2,nan" + tail, "fields"},
               {head + "1,2,1e3" + tail, "fields"},
               {head + "1,2," + tail, "fields"},
               {head + "1,2,-3,0,0", "fields"},
               {head + "1,2,-30000" + tail, "range"},
               {head + "1,2,-3,0,0,7,82445,-42,130,0.6", "range"},
               {"USBLLONG,100.0,100.5,7,1,2,-3,1,2,-3" + tail, "range"},
               {"USBLLONG,100.0,99.5,7.5,1,2,-3,1,2,-3" + tail, "fields"}};
  for (const auto& c : cases) {
    const Decoded d = decode_text(notification(c.body));
    EXPECT_EQ(d.frames.at(0).reason, c.reason) << c.body;
    EXPECT_EQ(d.all<UsblRelative>().size(), *c.reason == 0 ? 1u : 0u) << c.body;
  }
}

TEST(EvologicsLaws, Hold) {
  const std::string text = "xx" + kMade + "+++AT:20:RECVIM,1\r\n" + kReal;
  const Bytes bytes(text.begin(), text.end()), made(kMade.begin(), kMade.end());
  expect_any_split_alike(make, bytes, kArrival);
  expect_prefixes_accounted(make, Bytes(kMade.begin(), kMade.end()), kArrival);
  expect_byte_changes_harmless(make, made, kArrival, false);  // there is no checksum
}

}  // namespace
}  // namespace leadline::test
