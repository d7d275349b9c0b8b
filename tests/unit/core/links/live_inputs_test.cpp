#include "core/links/live_inputs.h"

#include <map>

#include "tests/support/files.h"
#include "tests/support/peer.h"

namespace leadline::links {
namespace {

using namespace std::chrono_literals;

test::Peer udp_to(std::uint16_t port) {
  test::Peer peer(::socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0));
  const auto address = test::loopback(port);
  EXPECT_EQ(::connect(peer.file(), reinterpret_cast<const sockaddr*>(&address), sizeof address), 0);
  return peer;
}

TEST(LiveInputs, EachSourceOfALinkIsGivenAllThatTheLinkHears) {
  const auto loop = IoLoop::start().value();
  const auto port = test::port_of(test::udp_peer());
  const auto terminal = test::pseudo_terminal();
  const LinkAddress shared{.kind = LinkKind::udp, .host = "127.0.0.1", .port = port};
  const LinkAddress serial{.kind = LinkKind::serial, .path = test::path_of(terminal)};
  auto inputs = LiveInputs::open(*loop, {{0, shared}, {1, serial}, {2, shared}}, {}).value();
  ASSERT_EQ(inputs->states().size(), 2U);
  ASSERT_TRUE(test::comes_about([&] {
    const auto states = inputs->states();
    return states[0].status.open && states[1].status.open;
  }));
  const auto peer = udp_to(port);
  std::map<SourceId, std::string> sent, heard;
  for (int i = 0; i < 500; ++i) {
    const std::string a = "datagram " + std::to_string(i) + "\n", b = "serial " + std::to_string(i) + "\n";
    ASSERT_GT(::write(peer.file(), a.data(), a.size()), 0);
    ASSERT_GT(::write(terminal.file(), b.data(), b.size()), 0);
    sent[0] += a, sent[1] += b, sent[2] += a;
    if (i % 20 == 0) std::this_thread::sleep_for(1ms);
  }
  Chunk chunk;
  Arrival last{};
  const Arrival begun = inputs->clock().now();
  ASSERT_TRUE(test::comes_about([&] {
    while (inputs->take(chunk, 1ms)) {
      EXPECT_FALSE(chunk.settled) << chunk.reason;
      heard[chunk.source].append(chunk.bytes.begin(), chunk.bytes.end());
      EXPECT_LT(std::chrono::abs(chunk.arrival - begun), 60s);
      last = std::max(last, chunk.arrival);
    }
    return heard == sent;
  }));
  EXPECT_LE(last, inputs->clock().now());
  inputs->close();
  EXPECT_FALSE(inputs->take(chunk, 0ms));
  EXPECT_EQ(inputs->states()[0].status.heard_frames, 500U);
}

}  // namespace
}  // namespace leadline::links
