#include "core/links/link_sender.h"

#include <filesystem>
#include <numeric>

#include "tests/support/files.h"
#include "tests/support/peer.h"

namespace leadline::links {
namespace {

using namespace std::chrono_literals;
using test::comes_about;

const LinkLimits kQuick{.retry_first = 5ms, .retry_last = 20ms};

/// Frame i, no two alike; binary bytes are among them.
std::string frame(int i) {
  std::string bytes = "frame " + std::to_string(i) + ' ';
  for (int k = 0; k < i % 40; ++k) bytes.push_back(static_cast<char>(i * 7 + k));
  return bytes + "\r\n";
}

class LinkSenderTest : public testing::Test {
 protected:
  LinkSender& open(const LinkAddress& address, const LinkLimits& limits = kQuick) {
    sender_ = std::make_unique<LinkSender>(*loop_, address, limits,
                                           [this](std::int64_t tag) { told_.push_back(tag); });
    return *sender_;
  }
  bool send(const std::string& bytes, std::int64_t tag = 0) {
    return sender_->send({reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()}, tag);
  }
  /// Sends `count` frames and gives them one behind the other.
  std::string send_frames(int count) {
    std::string all;
    for (int i = 0; i < count; ++i) {
      EXPECT_TRUE(send(frame(i), i));
      all += frame(i);
    }
    return all;
  }
  bool becomes_open() {
    return comes_about([&] { return sender_->status().open; });
  }
  /// All that was sent was told, in order; nothing was dropped.
  void expect_books_of(int frames, std::size_t bytes) {
    ASSERT_TRUE(sender_->finish(20s));
    const auto status = sender_->status();
    EXPECT_EQ(status.sent_frames, static_cast<std::uint64_t>(frames));
    EXPECT_EQ(status.sent_bytes, bytes);
    EXPECT_EQ(status.dropped_frames, 0U);
    std::vector<std::int64_t> tags(static_cast<std::size_t>(frames));
    std::iota(tags.begin(), tags.end(), 0);
    EXPECT_EQ(told_, tags);
  }

  std::vector<std::int64_t> told_;  // before the loop: it is told on that thread
  std::unique_ptr<IoLoop> loop_ = IoLoop::start().value();
  std::unique_ptr<LinkSender> sender_;
};

TEST_F(LinkSenderTest, UdpSendsEachFrameAsADatagramInOrder) {
  const auto peer = test::udp_peer();
  open({.kind = LinkKind::udp, .host = "127.0.0.1", .port = test::port_of(peer)});
  ASSERT_TRUE(becomes_open());
  std::size_t bytes = 0;
  for (int i = 0; i < 500; ++i) {
    ASSERT_TRUE(send(frame(i), i));
    ASSERT_EQ(peer.read_some(), frame(i));
    bytes += frame(i).size();
  }
  expect_books_of(500, bytes);
}

TEST_F(LinkSenderTest, UdpDropsWhatIsNoDatagramAndGoesOn) {
  const auto peer = test::udp_peer();
  open({.kind = LinkKind::udp, .host = "127.0.0.1", .port = test::port_of(peer)});
  ASSERT_TRUE(becomes_open());
  EXPECT_TRUE(send(std::string(70'000, 'x')));
  EXPECT_TRUE(send("short"));
  EXPECT_EQ(peer.read_some(), "short");
  ASSERT_TRUE(sender_->finish(20s));
  EXPECT_EQ(sender_->status().dropped_frames, 1U);
  EXPECT_NE(sender_->status().last_error.find("longer than a datagram"), std::string::npos);
}

TEST_F(LinkSenderTest, MulticastIsHeardOnTheInterfaceNamed) {
  const test::Peer peer(::socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0));
  sockaddr_in any{};
  any.sin_family = AF_INET;
  ASSERT_EQ(::bind(peer.file(), reinterpret_cast<const sockaddr*>(&any), sizeof any), 0);
  ip_mreqn group{};
  ::inet_pton(AF_INET, "239.192.0.4", &group.imr_multiaddr);
  group.imr_address.s_addr = htonl(INADDR_LOOPBACK);
  ASSERT_EQ(::setsockopt(peer.file(), IPPROTO_IP, IP_ADD_MEMBERSHIP, &group, sizeof group), 0);
  open({.kind = LinkKind::udp, .host = "239.192.0.4", .port = test::port_of(peer), .iface = "lo"});
  ASSERT_TRUE(becomes_open());
  EXPECT_TRUE(send("to all"));
  EXPECT_EQ(peer.read_some(), "to all");
}

TEST_F(LinkSenderTest, AnInterfaceThatIsNotThereIsNamed) {
  open({.kind = LinkKind::udp, .host = "239.192.0.4", .port = 9, .iface = "noeth7"});
  ASSERT_TRUE(comes_about([&] { return !sender_->status().last_error.empty(); }));
  EXPECT_NE(sender_->status().last_error.find("no network interface noeth7"), std::string::npos);
  EXPECT_FALSE(sender_->status().open);
}

TEST_F(LinkSenderTest, TcpConnectsAndSendsEveryByteInOrder) {
  const auto server = test::tcp_server();
  open({.kind = LinkKind::tcp, .host = "127.0.0.1", .port = test::port_of(server)});
  const auto peer = test::accepted(server);
  ASSERT_TRUE(becomes_open());
  const auto all = send_frames(2000);
  EXPECT_EQ(peer.read(all.size()), all);
  expect_books_of(2000, all.size());
}

TEST_F(LinkSenderTest, TcpComesBackAfterThePeerWentAndGoesOnWithAWholeFrame) {
  const auto server = test::tcp_server();
  open({.kind = LinkKind::tcp, .host = "127.0.0.1", .port = test::port_of(server)});
  for (std::uint64_t time = 1; time <= 3; ++time) {
    auto peer = test::accepted(server);
    ASSERT_TRUE(
        comes_about([&] { return sender_->status().open && sender_->status().times_opened == time; }));
    EXPECT_TRUE(send(frame(5)));
    EXPECT_EQ(peer.read(frame(5).size()), frame(5));
    peer.close();
    ASSERT_TRUE(comes_about([&] { return sender_->status().times_opened > time; }));
    EXPECT_NE(sender_->status().last_error.find("the other side"), std::string::npos);
  }
}

TEST_F(LinkSenderTest, WhatIsSentWhileNobodyListensIsDroppedAndCounted) {
  auto server = test::tcp_server();
  const auto port = test::port_of(server);
  server.close();
  open({.kind = LinkKind::tcp, .host = "127.0.0.1", .port = port});
  ASSERT_TRUE(comes_about([&] { return !sender_->status().last_error.empty(); }));
  for (int i = 0; i < 1000; ++i) send(frame(i));
  ASSERT_TRUE(sender_->finish(20s));
  EXPECT_EQ(sender_->status().dropped_frames, 1000U);
  EXPECT_EQ(sender_->status().sent_frames, 0U);
  EXPECT_NE(sender_->status().last_error.find("nobody listens there"), std::string::npos);
}

TEST_F(LinkSenderTest, APeerThatNeverReadsCostsNoMoreThanItsQueueAndIsCounted) {
  const auto server = test::tcp_server();
  LinkLimits small = kQuick;
  small.queue_bytes = 64 << 10, small.send_buffer = 16 << 10;
  open({.kind = LinkKind::tcp, .host = "127.0.0.1", .port = test::port_of(server)}, small);
  auto peer = test::accepted(server);
  ASSERT_TRUE(becomes_open());
  std::uint64_t refused = 0;
  for (int i = 0; i < 100'000; ++i) refused += send(std::string(1000, 'x')) ? 0 : 1;
  EXPECT_GT(refused, 50'000U) << "100 MB do not fit into the buffers of the system and 64 KiB of ours";
  EXPECT_GE(sender_->status().dropped_frames, refused);
  peer.close();
  ASSERT_TRUE(sender_->finish(20s));
  EXPECT_EQ(sender_->status().dropped_frames + sender_->status().sent_frames, 100'000U);
}

TEST_F(LinkSenderTest, TcpListenGivesEveryClientTheSameBytes) {
  open({.kind = LinkKind::tcp_listen, .host = "127.0.0.1", .port = 0});
  ASSERT_TRUE(becomes_open());
  EXPECT_TRUE(send("nobody is here"));
  ASSERT_TRUE(sender_->finish(20s));
  EXPECT_EQ(sender_->status().dropped_frames, 1U);
  const auto port = sender_->status().port;
  std::vector<test::Peer> peers;
  for (int i = 0; i < 5; ++i) peers.push_back(test::connected(port));
  ASSERT_TRUE(comes_about([&] { return sender_->status().clients == 5; }));
  const auto all = send_frames(1000);
  for (const auto& peer : peers) EXPECT_EQ(peer.read(all.size()), all);
  ASSERT_TRUE(sender_->finish(20s));
  EXPECT_EQ(sender_->status().sent_frames, 5000U);
  peers.pop_back();
  EXPECT_TRUE(comes_about([&] { return sender_->status().clients == 4; }));
  EXPECT_EQ(sender_->status().dropped_clients, 0U);
}

TEST_F(LinkSenderTest, TcpListenLetsASlowClientGoAndTheOthersLoseNothing) {
  LinkLimits small = kQuick;
  small.queue_bytes = 64 << 10, small.send_buffer = 16 << 10;
  open({.kind = LinkKind::tcp_listen, .host = "127.0.0.1", .port = 0}, small);
  ASSERT_TRUE(becomes_open());
  const auto port = sender_->status().port;
  const auto slow = test::connected(port), quick = test::connected(port);
  ASSERT_TRUE(comes_about([&] { return sender_->status().clients == 2; }));
  const std::string kilobyte(1000, 'x');
  for (int i = 0; i < 100'000 && sender_->status().dropped_clients == 0; ++i) {
    ASSERT_TRUE(send(kilobyte));
    ASSERT_EQ(quick.read(kilobyte.size()), kilobyte);
  }
  EXPECT_EQ(sender_->status().dropped_clients, 1U);
  EXPECT_EQ(sender_->status().clients, 1U);
  EXPECT_GT(sender_->status().dropped_frames, 0U);
}

TEST_F(LinkSenderTest, APortInUseIsNamedAndTakenWhenItIsFree) {
  auto other = test::tcp_server();
  open({.kind = LinkKind::tcp_listen, .host = "127.0.0.1", .port = test::port_of(other)});
  ASSERT_TRUE(comes_about([&] { return !sender_->status().last_error.empty(); }));
  EXPECT_NE(sender_->status().last_error.find("another program listens on this port"), std::string::npos);
  other.close();
  EXPECT_TRUE(becomes_open());
}

TEST_F(LinkSenderTest, ASerialLineCarriesEveryByteAndComesBackAfterAHangUp) {
  const std::string path =
      std::filesystem::temp_directory_path() / ("leadline-pty-" + std::to_string(::getpid()));
  for (std::uint64_t time = 1; time <= 2; ++time) {
    auto terminal = test::pseudo_terminal();
    std::filesystem::remove(path);
    std::filesystem::create_symlink(test::path_of(terminal), path);
    if (time == 1) open({.kind = LinkKind::serial, .path = path});
    ASSERT_TRUE(
        comes_about([&] { return sender_->status().open && sender_->status().times_opened >= time; }));
    std::string all;
    for (int i = 0; i < 256; ++i) {
      ASSERT_TRUE(send(frame(i)));
      ASSERT_EQ(terminal.read(frame(i).size()), frame(i)) << "raw: no byte is changed or taken as a command";
      all += frame(i);
    }
    terminal.close();
    ASSERT_TRUE(comes_about([&] { return !sender_->status().open; }));
    EXPECT_NE(sender_->status().last_error.find("plug"), std::string::npos) << sender_->status().last_error;
  }
  std::filesystem::remove(path);
}

TEST_F(LinkSenderTest, WhatIsNoDeviceIsNamed) {
  open({.kind = LinkKind::serial, .path = "/dev/leadline-is-not-there"});
  ASSERT_TRUE(comes_about([&] { return !sender_->status().last_error.empty(); }));
  EXPECT_NE(sender_->status().last_error.find("there is no such device"), std::string::npos);
}

TEST_F(LinkSenderTest, AFileIsAppendedTo) {
  const std::string path =
      std::filesystem::temp_directory_path() / ("leadline-file-" + std::to_string(::getpid()));
  std::ofstream(path) << "before\n";
  open({.kind = LinkKind::file, .path = path});
  ASSERT_TRUE(becomes_open());
  const auto all = send_frames(300);
  expect_books_of(300, all.size());
  EXPECT_EQ(test::read_text(path), "before\n" + all);
  std::filesystem::remove(path);
}

TEST_F(LinkSenderTest, LeavingWhileFramesAreUnderWayEndsWell) {
  const auto server = test::tcp_server();
  for (int i = 0; i < 20; ++i) {
    open({.kind = LinkKind::tcp, .host = "127.0.0.1", .port = test::port_of(server)});
    const auto peer = test::accepted(server);
    for (int k = 0; k < 200; ++k) send(std::string(1000, 'x'));
    sender_.reset();
    const auto told = told_.size();
    loop_->run_there([] {});
    EXPECT_EQ(told_.size(), told) << "nothing is told afterwards";
  }
}

}  // namespace
}  // namespace leadline::links
