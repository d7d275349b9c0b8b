#include "ui/bridge/bridge.h"

#include <gtest/gtest.h>

#include <QCoreApplication>
#include <atomic>
#include <chrono>
#include <fstream>
#include <thread>

#include "tests/unit/ui/bridge/made_messages.h"

namespace leadline::ui {
namespace {

using namespace std::chrono_literals;

/// Memory of this process that is in use, bytes.
std::size_t resident() {
  std::ifstream statm("/proc/self/statm");
  std::size_t size = 0, pages = 0;
  statm >> size >> pages;
  return pages * 4096;
}

class BridgeInAnEventLoop : public testing::Test {
 protected:
  int argc_ = 0;
  QCoreApplication app_{argc_, nullptr};
};

TEST_F(BridgeInAnEventLoop, LooksAtDisplayRateAndOnlyWhenSomethingCame) {
  Bridge bridge(test::dive_setup());
  int looked = 0;
  QObject::connect(&bridge, &Bridge::looked, [&] { ++looked; });
  test::Dive dive;
  dive.sail(0.0, 20.0);
  for (const Envelope& e : dive.messages) bridge.take(e);
  EXPECT_EQ(looked, 0);
  EXPECT_FALSE(bridge.snapshot().vehicle) << "the screen looks when it wants to";
  bridge.start();
  const auto until = std::chrono::steady_clock::now() + 200ms;
  while (std::chrono::steady_clock::now() < until) QCoreApplication::processEvents(QEventLoop::AllEvents, 20);
  EXPECT_EQ(looked, 1);
  ASSERT_TRUE(bridge.snapshot().vehicle);
  EXPECT_EQ(bridge.history().tracks.size(), 3U);
  bridge.take(dive.messages.back());
  bridge.look();
  EXPECT_EQ(looked, 2);
}

TEST_F(BridgeInAnEventLoop, AScreenThatHangsCostsNoMemoryAndTheNewestWins) {
  Bridge bridge(test::dive_setup());
  constexpr int kMessages = 300'000;
  const auto produce = [&](int from, int until) {
    test::Dive dive;
    for (int i = from; i < until; ++i) {
      dive.messages.clear();
      dive.go_to(i * 1e-3);
      dive.say(test::kCompass, Heading{Angle::deg(i % 360)});
      dive.solution(0, i, 0.0);
      for (const Envelope& e : dive.messages) bridge.take(e);
    }
  };
  std::thread(produce, 0, 20'000).join();
  const std::size_t before = resident();
  // As fast as it can: far more than the 100,000 a second of a ship full of sensors; nobody looks meanwhile.
  std::thread producer(produce, 20'000, kMessages);
  producer.join();
  EXPECT_LT(static_cast<double>(resident()) - static_cast<double>(before), 8e6);
  bridge.look();
  EXPECT_EQ(bridge.snapshot().now, Time{test::kDiveNs} + duration((kMessages - 1) * 1e-3));
  EXPECT_EQ(bridge.snapshot().vehicle->solution.position, test::near_busan(kMessages - 1, 0.0));
  EXPECT_LE(bridge.history().tracks.at(0).points.size(), 4096U);
}

TEST_F(BridgeInAnEventLoop, ASlowScreenSeesTimesThatOnlyGrow) {
  Bridge bridge(test::dive_setup());
  std::atomic<bool> stop{false};
  std::thread producer([&] {
    test::Dive dive;
    for (int i = 0; !stop; ++i) {
      dive.messages.clear();
      dive.go_to(i * 1e-3);
      dive.solution(0, i, 0.0);
      bridge.take(dive.messages.back());
    }
  });
  Time last{};
  for (int i = 0; i < 20; ++i) {
    std::this_thread::sleep_for(10ms);
    bridge.look();
    const Time now = bridge.snapshot().now;
    EXPECT_GE(now, last);
    EXPECT_EQ(bridge.snapshot().vehicle.has_value(), now > Time{});
    last = now;
  }
  stop = true;
  producer.join();
  EXPECT_GT(last, Time{test::kDiveNs});
}

}  // namespace
}  // namespace leadline::ui
