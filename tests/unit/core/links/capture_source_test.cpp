#include "core/links/capture_source.h"

#include <gmock/gmock.h>
#include <pcap/pcap.h>

#include <filesystem>
#include <fstream>

#include "tests/support/files.h"

namespace leadline::links {
namespace {

using testing::ElementsAre;

std::string be16(unsigned v) { return {static_cast<char>(v >> 8), static_cast<char>(v)}; }
std::string be32(std::uint32_t v) { return be16(v >> 16) + be16(v & 0xFFFF); }

std::string ipv4(char protocol, const std::string& payload, unsigned fragment = 0) {
  return std::string("\x45\0", 2) + be16(static_cast<unsigned>(20 + payload.size())) + be16(1) +
         be16(fragment) + "\x40" + protocol + be16(0) + std::string("\x0A\0\0\x05\x0A\0\0\x01", 8) + payload;
}
std::string ipv6(char protocol, const std::string& payload) {
  return std::string("\x60\0\0\0", 4) + be16(static_cast<unsigned>(payload.size())) + protocol + "\x40" +
         std::string(15, '\0') + "\5" + std::string(15, '\0') + "\1" + payload;
}
std::string udp(unsigned from, unsigned to, const std::string& data) {
  return be16(from) + be16(to) + be16(static_cast<unsigned>(8 + data.size())) + be16(0) + data;
}
std::string tcp(unsigned from, unsigned to, std::uint32_t sequence, const std::string& data,
                char flags = 0x18) {
  return be16(from) + be16(to) + be32(sequence) + be32(1) + "\x50" + flags + be16(100) + be32(0) + data;
}
std::string ethernet(unsigned type, const std::string& payload) {
  return std::string(12, '\0') + be16(type) + payload;
}

constexpr char kUdp = 17, kTcp = 6;

/// A capture, one packet a millisecond.
class Capture {
 public:
  explicit Capture(int link_type = DLT_EN10MB)
      : path_(testing::TempDir() + "leadline_capture_" + std::to_string(::getpid()) + ".pcap"),
        pcap_(::pcap_open_dead_with_tstamp_precision(link_type, 65535, PCAP_TSTAMP_PRECISION_NANO)),
        file_(::pcap_dump_open(pcap_, path_.c_str())) {}
  ~Capture() {
    close();
    std::filesystem::remove(path_);
  }
  Capture(const Capture&) = delete;
  Capture& operator=(const Capture&) = delete;

  void add(const std::string& frame) {
    pcap_pkthdr header{};
    header.ts.tv_sec = 1'700'000'000;
    header.ts.tv_usec = 1'000'000 * count_++ + 123;  // nanoseconds
    header.caplen = header.len = static_cast<bpf_u_int32>(frame.size());
    ::pcap_dump(reinterpret_cast<u_char*>(file_), &header, reinterpret_cast<const u_char*>(frame.data()));
  }
  const std::string& close() {
    if (file_ != nullptr) ::pcap_dump_close(std::exchange(file_, nullptr));
    if (pcap_ != nullptr) ::pcap_close(std::exchange(pcap_, nullptr));
    return path_;
  }

 private:
  std::string path_;
  pcap_t* pcap_;
  pcap_dumper_t* file_;
  int count_ = 0;
};

struct Heard {
  SourceId source;
  std::int64_t ms;
  std::string sender, bytes;
  bool operator==(const Heard&) const = default;
};
void PrintTo(const Heard& h, std::ostream* out) {
  *out << h.source << " " << h.ms << " " << h.sender << " " << h.bytes;
}

const std::vector<CapturedSource> kSources{
    {0, {.kind = LinkKind::udp, .host = "0.0.0.0", .port = 4001}},
    {1, {.kind = LinkKind::tcp, .host = "dvl", .port = 16171}},
    {2, {.kind = LinkKind::tcp_listen, .host = "0.0.0.0", .port = 10110}},
    {3, {.kind = LinkKind::udp, .host = "0.0.0.0", .port = 4001}},
};

std::vector<Heard> heard_in(CaptureSource& source) {
  std::vector<Heard> all;
  for (Chunk c; source.next(c);) {
    EXPECT_EQ(c.arrival.ns % 1000, 0);
    all.push_back({c.source, (c.arrival.ns - 1'700'000'000'000'000'000) / 1'000'000, std::string(c.sender),
                   std::string(c.bytes.begin(), c.bytes.end())});
  }
  return all;
}

TEST(CaptureSource, DatagramsGoToTheSourcesOfTheirPort) {
  Capture capture;
  capture.add(ethernet(0x0800, ipv4(kUdp, udp(5000, 4001, "one"))));
  capture.add(ethernet(0x0800, ipv4(kUdp, udp(5000, 4002, "for nobody"))));
  capture.add(ethernet(0x0806, "arp"));
  capture.add(ethernet(0x0800, ipv4(kUdp, udp(5000, 4001, "fragment"), 0x2000)));
  capture.add(std::string(12, '\0') + "\x81" + std::string("\0\0\x07", 3) +
              ethernet(0x86DD, ipv6(kUdp, udp(6000, 4001, "six"))).substr(12));
  auto source = CaptureSource::open(capture.close(), kSources).value();
  EXPECT_THAT(heard_in(source),
              ElementsAre(Heard{0, 0, "10.0.0.5:5000", "one"}, Heard{3, 0, "10.0.0.5:5000", "one"},
                          Heard{0, 4, "::5:6000", "six"}, Heard{3, 4, "::5:6000", "six"}));
  EXPECT_EQ(source.for_nobody(), (CaptureSource::Counts{{"udp 4002", 1}}));
  EXPECT_EQ(source.not_understood(), 2U);
  EXPECT_FALSE(source.failure());
}

TEST(CaptureSource, StreamsArePutIntoOrder) {
  Capture capture;
  const auto add = [&](std::uint32_t sequence, const std::string& data, char flags = 0x18) {
    capture.add(ethernet(0x0800, ipv4(kTcp, tcp(16171, 5555, sequence, data, flags))));
  };
  add(0xFFFFFFF0U, "", 0x12);  // SYN; numbers wrap soon
  add(0xFFFFFFF1U, "abcdefghij");
  add(0x00000005U, "uvwxyz");           // early
  add(0xFFFFFFF1U, "abcdefghij");       // again
  add(0xFFFFFFF6U, "fghijklmnopqrst");  // its head again, the rest is what was missing
  capture.add(ethernet(0x0800, ipv4(kTcp, tcp(7777, 10110, 100, "client"))));
  capture.add(ethernet(0x0800, ipv4(kTcp, tcp(5555, 16171, 9, "our own command"))));
  auto source = CaptureSource::open(capture.close(), kSources).value();
  EXPECT_THAT(
      heard_in(source),
      ElementsAre(Heard{1, 1, "10.0.0.5:16171", "abcdefghij"}, Heard{1, 4, "10.0.0.5:16171", "klmnopqrst"},
                  Heard{1, 4, "10.0.0.5:16171", "uvwxyz"}, Heard{2, 5, "10.0.0.5:7777", "client"}));
  EXPECT_EQ(source.missing_bytes(), 0U);
}

TEST(CaptureSource, BehindAGapTheStreamGoesOn) {
  Capture capture;
  const auto add = [&](std::uint32_t sequence, const std::string& data) {
    capture.add(ethernet(0x0800, ipv4(kTcp, tcp(16171, 5555, sequence, data))));
  };
  add(100, "first.");
  for (std::uint32_t i = 0; i < 100; ++i) add(116 + 4 * i, "next");  // ten bytes were never captured
  auto source = CaptureSource::open(capture.close(), kSources).value();
  std::string all;
  for (const auto& heard : heard_in(source)) all += heard.bytes;
  std::string expected = "first.";
  for (int i = 0; i < 100; ++i) expected += "next";
  EXPECT_EQ(all, expected);
  EXPECT_EQ(source.missing_bytes(), 10U);
}

TEST(CaptureSource, OtherLinkTypes) {
  for (const auto& [type, header] :
       std::vector<std::pair<int, std::string>>{{DLT_LINUX_SLL, std::string(14, '\0') + be16(0x0800)},
                                                {DLT_LINUX_SLL2, be16(0x0800) + std::string(18, '\0')},
                                                {DLT_RAW, ""},
                                                {DLT_NULL, std::string("\2\0\0\0", 4)}}) {
    Capture capture(type);
    capture.add(header + ipv4(kUdp, udp(5000, 4001, "one")));
    auto source = CaptureSource::open(capture.close(), {kSources[0]}).value();
    EXPECT_THAT(heard_in(source), ElementsAre(Heard{0, 0, "10.0.0.5:5000", "one"})) << type;
  }
}

TEST(CaptureSource, ATornFileGivesWhatIsWhole) {
  Capture capture;
  for (int i = 0; i < 3; ++i) capture.add(ethernet(0x0800, ipv4(kUdp, udp(5000, 4001, "whole"))));
  const std::string path = capture.close();
  std::filesystem::resize_file(path, std::filesystem::file_size(path) - 4);
  auto source = CaptureSource::open(path, {kSources[0]}).value();
  EXPECT_EQ(heard_in(source).size(), 2U);
  ASSERT_TRUE(source.failure());
  EXPECT_NE(source.failure()->line().find("middle of a packet"), std::string::npos);
  std::ofstream(path) << "no capture at all";
  EXPECT_FALSE(CaptureSource::open(path, {kSources[0]}));
}

TEST(CapturePacket, EveryPrefixOfAPacketIsRefusedOrWhole) {
  const std::string whole = ethernet(0x0800, ipv4(kTcp, tcp(16171, 5555, 7, "payload")));
  for (std::size_t n = 0; n < whole.size(); ++n)
    EXPECT_FALSE(captured_packet(DLT_EN10MB, {reinterpret_cast<const std::uint8_t*>(whole.data()), n})) << n;
  EXPECT_TRUE(
      captured_packet(DLT_EN10MB, {reinterpret_cast<const std::uint8_t*>(whole.data()), whole.size()}));
}

}  // namespace
}  // namespace leadline::links
