#include "core/decode/xsens_mtdata2.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <bit>
#include <cmath>

#include "tests/support/files.h"
#include "tests/unit/core/decode/decoder_laws.h"

namespace leadline::test {
namespace {

constexpr Arrival kArrival{1'795'350'919'600'000'000};

Bytes sample() { return read_bytes(data_path("wire-samples/xsens_mtdata2.bin")); }
std::unique_ptr<Decoder> make() { return decode::make_xsens_mtdata2({}); }
Decoded decode_xsens(const Bytes& b) { return decode_all(*make(), b, kArrival); }

/// Builds messages value by value.
struct Packet {
  Bytes data;

  Packet& big(std::uint64_t value, int bytes) {
    for (int i = bytes - 1; i >= 0; --i) data.push_back(static_cast<std::uint8_t>(value >> 8 * i));
    return *this;
  }
  Packet& head(int id, int size) {
    return big(static_cast<std::uint64_t>(id), 2).big(static_cast<std::uint64_t>(size), 1);
  }
  /// Numbers in the format that the id names.
  Packet& numbers(int id, const std::vector<double>& values) {
    constexpr int kSizes[] = {4, 4, 6, 8};
    head(id, kSizes[id & 3] * static_cast<int>(values.size()));
    for (const double v : values) {
      if ((id & 3) == 0) big(std::bit_cast<std::uint32_t>(static_cast<float>(v)), 4);
      if ((id & 3) == 1)
        big(static_cast<std::uint32_t>(static_cast<std::int32_t>(std::llround(v * 0x1p20))), 4);
      if ((id & 3) == 2) {
        const auto fixed = static_cast<std::uint64_t>(std::llround(v * 0x1p32));
        big(fixed & 0xFFFFFFFF, 4).big(fixed >> 32 & 0xFFFF, 2);
      }
      if ((id & 3) == 3) big(std::bit_cast<std::uint64_t>(v), 8);
    }
    return *this;
  }
  Packet& counter(int n) { return head(0x1020, 2).big(static_cast<std::uint64_t>(n), 2); }
  Packet& ticks(std::uint32_t t) { return head(0x1060, 4).big(t, 4); }
  Packet& status(int bits) { return head(0xE020, 4).big(static_cast<std::uint64_t>(bits), 4); }
  Packet& utc(int second, std::uint32_t ns, int flags) {
    head(0x1010, 12).big(ns, 4).big(2026, 2);
    for (const int v : {11, 22, 12, 35, second, flags}) big(static_cast<std::uint64_t>(v), 1);
    return *this;
  }
  [[nodiscard]] Bytes message(std::uint8_t id = 0x36, bool extended = false) const {
    Bytes b{0xFA, 0xFF, id, static_cast<std::uint8_t>(data.size())};
    if (extended)
      b[3] = 0xFF, b.push_back(static_cast<std::uint8_t>(data.size() >> 8)),
      b.push_back(static_cast<std::uint8_t>(data.size()));
    b.insert(b.end(), data.begin(), data.end());
    unsigned sum = 0;
    for (std::size_t i = 1; i < b.size(); ++i) sum += b[i];
    b.push_back(static_cast<std::uint8_t>(0x100 - (sum & 0xFF)));
    return b;
  }
};

Bytes joined(const std::vector<Packet>& packets) {
  Bytes all;
  for (const Packet& p : packets) {
    const Bytes b = p.message();
    all.insert(all.end(), b.begin(), b.end());
  }
  return all;
}

TEST(XsensMtData2, TheSampleGivesItsDocumentedValues) {
  const Decoded d = decode_xsens(sample());
  ASSERT_EQ(d.frames.size(), 1u);
  EXPECT_EQ(d.frames[0].kind, "MTData2");
  EXPECT_EQ(d.frames[0].checksum, ChecksumState::ok);
  EXPECT_NEAR(d.all<Heading>().at(0).heading.deg(), 96.03, 1e-5);
  EXPECT_NEAR(d.all<Attitude>().at(0).roll.deg(), 1.40, 1e-6);
  EXPECT_NEAR(d.all<Attitude>()[0].pitch.deg(), 2.30, 1e-6) << "ENU pitch is bow down positive";
  EXPECT_NEAR(d.all<Rates>().at(0).rate_z_rps, -0.020, 1e-8) << "up positive there, clockwise here";
  EXPECT_TRUE(d.all<ImuSample>().empty()) << "no accelerations";
  EXPECT_TRUE(d.all<Health>().empty());
  for (const auto& fact : d.facts) EXPECT_FALSE(fact.device_time) << "sample time without UTC has no date";
}

TEST(XsensMtData2, EveryNumberFormatSaysTheSame) {
  for (const int format : {0, 1, 2, 3}) {
    const Decoded d = decode_xsens(Packet{}
                                       .numbers(0x8024 | format, {0.25, -1.5, 3.0})
                                       .numbers(0x4024 | format, {-0.5, 9.75, -9.8125})
                                       .numbers(0x2034 | format, {1.5, -2.25, 96.5})
                                       .message());
    const auto imu = d.all<ImuSample>().at(0);
    EXPECT_EQ(imu.gyro, (Vec3<Instrument>{0.25, -1.5, 3.0})) << format;
    EXPECT_EQ(imu.accel, (Vec3<Instrument>{-0.5, 9.75, -9.8125})) << format;
    EXPECT_FALSE(imu.increments);
    EXPECT_NEAR(d.all<Heading>().at(0).heading.deg(), 96.5, 1e-12);
  }
}

TEST(XsensMtData2, FramesAreTurnedToForwardStarboardDown) {
  const struct {
    const char* name;
    int bits;
    double pitch, yaw, y, z;
  } cases[] = {{"ENU", 0x0, 2.3, -6.03, -2.0, -3.0},
               {"NED", 0x4, -2.3, 96.03, 2.0, 3.0},
               {"NWU", 0x8, 2.3, -96.03, -2.0, -3.0}};
  for (const auto& c : cases) {
    const Decoded d = decode_xsens(Packet{}
                                       .numbers(0x2030 | c.bits | 3, {1.4, c.pitch, c.yaw})
                                       .numbers(0x8020 | c.bits | 3, {1.0, c.y, c.z})
                                       .message());
    EXPECT_NEAR(d.all<Heading>().at(0).heading.deg(), 96.03, 1e-9) << c.name;
    EXPECT_NEAR(d.all<Attitude>().at(0).roll.deg(), 1.4, 1e-9) << c.name;
    EXPECT_NEAR(d.all<Attitude>()[0].pitch.deg(), -2.3, 1e-9) << c.name;
    EXPECT_EQ(d.all<Rates>().at(0).rate_z_rps, 3.0) << c.name;
  }
  EXPECT_EQ(decode_xsens(Packet{}.numbers(0x2030 | 0xC, {0, 0, 0}).message()).frames.at(0).reason, "fields");
}

TEST(XsensMtData2, AQuaternionIsPreferredToEulerAnglesOnEitherSide) {
  // Bow to the north-east, 30 deg up, in ENU with axes forward-port-up.
  const Eigen::Quaterniond q = Eigen::AngleAxisd(kPi / 4, Eigen::Vector3d::UnitZ()) *
                               Eigen::AngleAxisd(-kPi / 6, Eigen::Vector3d::UnitY());
  const std::vector<double> sent{q.w(), q.x(), q.y(), q.z()}, euler{0, 0, 0};
  for (const bool first : {false, true}) {
    Packet p;
    if (first) p.numbers(0x2013, sent).numbers(0x2033, euler);
    if (!first) p.numbers(0x2033, euler).numbers(0x2013, sent);
    const Decoded d = decode_xsens(p.message());
    EXPECT_NEAR(d.all<Heading>().at(0).heading.deg(), 45.0, 1e-9);
    EXPECT_NEAR(d.all<Attitude>().at(0).pitch.deg(), 30.0, 1e-9);
    EXPECT_NEAR(d.all<Attitude>()[0].roll.deg(), 0.0, 1e-9);
  }
}

TEST(XsensMtData2, UtcDatesPacketsAndTheSampleTimeCarriesItOn) {
  const Time utc = *parse_iso8601("2026-11-22T12:35:19.5Z");
  const auto euler = [](Packet p) { return p.numbers(0x2030, {0, 0, 0}); };
  const Decoded d = decode_xsens(joined({euler(Packet{}.ticks(5)),  // no UTC yet
                                         euler(Packet{}.utc(19, 500'000'000, 7).ticks(0xFFFFFFF0)),
                                         euler(Packet{}.ticks(0xFFFFFFF0 + 100)),     // it has wrapped
                                         euler(Packet{}.ticks(50)),                   // started again
                                         euler(Packet{}.utc(20, 0, 3).ticks(60))}));  // UTC not valid
  std::vector<std::optional<Time>> times;
  for (const auto& fact : d.facts)
    if (std::holds_alternative<Attitude>(fact.message)) times.push_back(fact.device_time);
  ASSERT_EQ(times.size(), 5u);
  EXPECT_FALSE(times[0]);
  EXPECT_EQ(times[1], utc);
  EXPECT_EQ(times[2], utc + std::chrono::milliseconds(10));
  EXPECT_FALSE(times[3]);
  EXPECT_FALSE(times[4]);
  EXPECT_EQ(d.all<ClockReading>().size(), 1u);
  EXPECT_EQ(d.all<ClockReading>()[0].device_ns, utc.ns);
}

TEST(XsensMtData2, LostPacketsAreToldAndARestartIsNone) {
  const auto said = [](const std::vector<int>& counters) {
    std::vector<Packet> packets;
    for (const int n : counters) packets.push_back(Packet{}.counter(n));
    std::string last;
    const Decoded d = decode_xsens(joined(packets));
    for (const Health& h : d.all<Health>()) last = std::string(h.text.view());
    return last;
  };
  EXPECT_EQ(said({65534, 65535, 0, 1}), "") << "a wrap";
  EXPECT_EQ(said({7, 9}), "packets of the Xsens lost so far: 1");
  EXPECT_EQ(said({65535, 4}), "packets of the Xsens lost so far: 4");
  EXPECT_EQ(said({40'000, 0, 1}), "") << "a restart";
  EXPECT_EQ(said({500, 0}), "");
}

TEST(XsensMtData2, TheStatusWordDecidesAboutAttitudeAndPosition) {
  const auto packet = [](int status) {
    return Packet{}.numbers(0x2030, {0, 0, 0}).numbers(0x5043, {59.205, 5.2057}).status(status);
  };
  const Decoded good = decode_xsens(packet(7).message());
  EXPECT_EQ(good.all<Attitude>().size(), 1u);
  EXPECT_NEAR(good.all<GnssFix>().at(0).position.lat.deg(), 59.205, 1e-12);
  EXPECT_NEAR(good.all<GnssFix>()[0].position.lon.deg(), 5.2057, 1e-12);
  const Decoded bad = decode_xsens(joined({packet(0), packet(0)}));
  EXPECT_EQ(bad.all<Attitude>().size() + bad.all<Heading>().size() + bad.all<GnssFix>().size(), 0u);
  EXPECT_EQ(bad.all<Health>().size(), 2u) << "filter and self-test, each once";
}

TEST(XsensMtData2, SizesThatDoNotFitAndNumbersThatAreNoneRefuseThePacket) {
  const struct {
    Packet packet;
    const char* reason;
  } cases[] = {{Packet{}.head(0x2030, 8).big(0, 8), "fields"},
               {Packet{}.head(0x2031, 12).big(0, 4), "fields"},
               {Packet{}.head(0x1020, 4).big(0, 4), "fields"},
               {Packet{}.big(0x20, 1), "fields"},
               {Packet{}.numbers(0x8020, {NAN, 0, 0}), "range"},
               {Packet{}.numbers(0x4023, {INFINITY, 0, 0}), "range"},
               {Packet{}.numbers(0x2010, {0, 0, 0, 0}), "range"},
               {Packet{}.numbers(0x2030, {0, 91, 0}), "range"},
               {Packet{}.numbers(0x5043, {91, 0}), "range"},
               {Packet{}.utc(61, 0, 7), "range"}};
  for (const auto& c : cases) {
    const Decoded d = decode_xsens(c.packet.message());
    EXPECT_EQ(d.frames.at(0).reason, c.reason);
    EXPECT_TRUE(d.facts.empty());
  }
  EXPECT_EQ(decode_xsens(Packet{}.head(0x7770, 5).big(0, 5).numbers(0x2030, {0, 0, 0}).message())
                .all<Attitude>()
                .size(),
            1u)
      << "an unknown item is passed over";
}

TEST(XsensMtData2, OtherMessagesAndTheLongFormAreFramed) {
  EXPECT_EQ(decode_xsens(Packet{}.message(0x3E)).frames.at(0).byte_class, ByteClass::unused);
  EXPECT_EQ(decode_xsens(Packet{}.message(0x77)).frames.at(0).byte_class, ByteClass::unknown);
  const Decoded error = decode_xsens(Packet{}.big(40, 1).message(0x42));
  EXPECT_EQ(error.frames.at(0).kind, "Error");
  EXPECT_EQ(error.all<Health>().at(0).text.view(), "the Xsens reports error 40");
  Packet p;
  for (int i = 0; i < 60; ++i) p.numbers(0x2030, {0, 0, 0});
  const Decoded d = decode_xsens(p.message(0x36, true));
  EXPECT_EQ(d.frames.size(), 1u);
  EXPECT_EQ(d.all<Attitude>().size(), 1u);
}

TEST(XsensLaws, Hold) {
  Bytes three =
      joined({Packet{}.numbers(0x4020, {0, 0, 9.8}).numbers(0x8020, {0, 0, 0}), Packet{}.counter(9)});
  const Bytes one = sample();
  three.insert(three.end(), one.begin(), one.end());
  expect_any_split_alike(make, three, kArrival);
  expect_prefixes_accounted(make, three, kArrival);
  expect_byte_changes_harmless(make, one, kArrival, true);
  expect_found_in_rubbish(make, one, kArrival, 2, 10);
}

}  // namespace
}  // namespace leadline::test
