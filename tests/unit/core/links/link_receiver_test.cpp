#include "core/links/link_receiver.h"

#include <fcntl.h>

#include <condition_variable>
#include <filesystem>
#include <fstream>
#include <mutex>
#include <set>

#include "tests/support/files.h"
#include "tests/support/peer.h"

namespace leadline::links {
namespace {

using namespace std::chrono_literals;
using test::comes_about;

const LinkLimits kQuick{.retry_first = 5ms, .retry_last = 20ms, .dead_peer = 2000ms};

class LinkReceiverTest : public testing::Test {
 protected:
  LinkReceiver& open(const LinkAddress& address, const LinkLimits& limits = kQuick) {
    receiver_ = std::make_unique<LinkReceiver>(*loop_, address, limits, [this](const Hearing& heard) {
      const std::lock_guard lock(mutex_);
      pieces_.emplace_back(heard.bytes.begin(), heard.bytes.end());
      all_ += pieces_.back();
      senders_.emplace(heard.sender);
      stamped_ = heard.kernel_wall_ns.has_value();
    });
    return *receiver_;
  }
  bool becomes_open() {
    return comes_about([&] { return receiver_->status().open; });
  }
  std::string all() {
    const std::lock_guard lock(mutex_);
    return all_;
  }
  bool hears(const std::string& text) {
    return comes_about([&] { return all() == text; });
  }
  static void write(const test::Peer& peer, const std::string& text) {
    ASSERT_EQ(::write(peer.file(), text.data(), text.size()), static_cast<ssize_t>(text.size()));
  }

  std::mutex mutex_;
  std::vector<std::string> pieces_;
  std::string all_;
  std::set<std::string> senders_;
  bool stamped_ = false;
  std::unique_ptr<IoLoop> loop_ = IoLoop::start().value();
  std::unique_ptr<LinkReceiver> receiver_;
};

std::uint16_t free_udp_port() { return test::port_of(test::udp_peer()); }

test::Peer udp_to(std::uint16_t port) {
  test::Peer peer(::socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0));
  const auto address = test::loopback(port);
  EXPECT_EQ(::connect(peer.file(), reinterpret_cast<const sockaddr*>(&address), sizeof address), 0);
  return peer;
}

TEST_F(LinkReceiverTest, UdpHearsEachDatagramWholeWithSenderAndKernelStamp) {
  const auto port = free_udp_port();
  open({.kind = LinkKind::udp, .host = "127.0.0.1", .port = port});
  ASSERT_TRUE(becomes_open());
  const auto peer = udp_to(port);
  std::string sent;
  std::vector<std::string> frames;
  for (int i = 0; i < 2000; ++i) {
    frames.push_back("frame " + std::to_string(i) + std::string(static_cast<std::size_t>(i % 1400), 'x'));
    write(peer, frames.back());
    sent += frames.back();
  }
  ASSERT_TRUE(hears(sent));
  EXPECT_EQ(pieces_, frames);
  EXPECT_TRUE(stamped_);
  EXPECT_EQ(senders_, std::set<std::string>{"127.0.0.1:" + std::to_string(test::port_of(peer))});
  const auto status = receiver_->status();
  EXPECT_EQ(status.heard_frames, 2000U);
  EXPECT_EQ(status.heard_bytes, sent.size());
  EXPECT_EQ(status.kernel_drops, 0U);
  EXPECT_GT(status.receive_buffer, 0U);
}

TEST_F(LinkReceiverTest, UdpHearsAGroup) {
  const auto port = free_udp_port();
  const LinkAddress group{.kind = LinkKind::udp, .host = "239.192.0.77", .port = port, .iface = "127.0.0.1"};
  open(group);
  if (!comes_about([&] { return receiver_->status().open || !receiver_->status().last_error.empty(); }) ||
      !receiver_->status().open)
    GTEST_SKIP() << "this machine has no multicast: " << receiver_->status().last_error;
  LinkSender sender(*loop_, group);
  ASSERT_TRUE(comes_about([&] { return sender.status().open; }));
  const std::string text = "$HEHDT,001.7,T*29\r\n";
  sender.send({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
  EXPECT_TRUE(hears(text));
}

TEST_F(LinkReceiverTest, APortInUseIsSaidAndTakenWhenItIsFree) {
  auto holder = test::udp_peer();
  open({.kind = LinkKind::udp, .host = "127.0.0.1", .port = test::port_of(holder)});
  ASSERT_TRUE(comes_about([&] { return !receiver_->status().last_error.empty(); }));
  EXPECT_NE(receiver_->status().last_error.find("another program listens on this port"), std::string::npos);
  holder.close();
  EXPECT_TRUE(becomes_open());
}

TEST_F(LinkReceiverTest, ATerminalUnpluggedInMidSentenceIsOpenedAgain) {
  const std::string link = testing::TempDir() + "leadline_receiver_tty_" + std::to_string(::getpid());
  std::string expected;
  for (int round = 0; round < 5; ++round) {
    // The name stays, the device behind it is another: so it is with /dev/serial/by-id.
    auto terminal = test::pseudo_terminal();
    std::filesystem::remove(link);
    std::filesystem::create_symlink(test::path_of(terminal), link);
    if (round == 0) open({.kind = LinkKind::serial, .path = link});
    ASSERT_TRUE(comes_about([&] {
      return receiver_->status().open &&
             receiver_->status().times_opened == static_cast<std::uint64_t>(round) + 1;
    })) << receiver_->status().last_error;
    const std::string text = "$HEHDT,001.7,T*29\r\n$HEHDT,0";
    write(terminal, text);
    expected += text;
    ASSERT_TRUE(hears(expected));
    terminal.close();
    ASSERT_TRUE(comes_about([&] { return !receiver_->status().open; }));
  }
  EXPECT_NE(receiver_->status().last_error.find("gone"), std::string::npos) << receiver_->status().last_error;
  std::filesystem::remove(link);
}

TEST_F(LinkReceiverTest, TcpHearsAServerAndComesBackAfterAReset) {
  const auto server = test::tcp_server();
  open({.kind = LinkKind::tcp, .host = "127.0.0.1", .port = test::port_of(server)});
  std::string expected;
  for (int round = 0; round < 3; ++round) {
    auto peer = test::accepted(server);
    const std::string text = std::string(200'000, static_cast<char>('a' + round)) + "half";
    write(peer, text);
    expected += text;
    ASSERT_TRUE(hears(expected));
    const linger at_once{1, 0};
    ::setsockopt(peer.file(), SOL_SOCKET, SO_LINGER, &at_once, sizeof at_once);
    peer.close();
  }
}

TEST_F(LinkReceiverTest, ATcpServerHearsAllItsClientsEachByName) {
  open({.kind = LinkKind::tcp_listen, .host = "127.0.0.1", .port = 0});
  ASSERT_TRUE(becomes_open());
  const auto a = test::connected(receiver_->status().port), b = test::connected(receiver_->status().port);
  write(a, "from a\n");
  ASSERT_TRUE(hears("from a\n"));
  write(b, "from b\n");
  ASSERT_TRUE(hears("from a\nfrom b\n"));
  EXPECT_EQ(senders_.size(), 2U);
}

TEST_F(LinkReceiverTest, AFileIsFollowedThroughGrowthAndReplacement) {
  const std::string path = testing::TempDir() + "leadline_followed_" + std::to_string(::getpid());
  std::ofstream(path) << "first\n";
  open({.kind = LinkKind::file, .path = path, .follow = true});
  ASSERT_TRUE(hears("first\n"));
  std::ofstream(path, std::ios::app) << "second\n";
  ASSERT_TRUE(hears("first\nsecond\n"));
  const std::string fresh = path + ".new";
  std::ofstream(fresh) << "third\n";
  std::filesystem::rename(fresh, path);
  ASSERT_TRUE(hears("first\nsecond\nthird\n"));
  std::filesystem::remove(path);
}

TEST_F(LinkReceiverTest, NothingIsLeftOpenAfterManyUnplugs) {
  const auto handles = [] {
    const std::filesystem::directory_iterator all("/proc/self/fd");
    return std::distance(begin(all), end(all));
  };
  const auto port = free_udp_port();
  open({.kind = LinkKind::udp, .host = "127.0.0.1", .port = port});
  ASSERT_TRUE(becomes_open());
  receiver_.reset();
  const auto before = handles();
  for (int i = 0; i < 50; ++i) {
    open({.kind = LinkKind::udp, .host = "127.0.0.1", .port = port});
    ASSERT_TRUE(becomes_open());
    receiver_.reset();
  }
  EXPECT_EQ(handles(), before);
}

}  // namespace
}  // namespace leadline::links
