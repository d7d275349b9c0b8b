#include "core/links/input_queue.h"

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <thread>

#include "tests/support/files.h"

namespace leadline::links {
namespace {

using namespace std::chrono_literals;

std::string text_of(int i) {
  return "frame " + std::to_string(i) + std::string(static_cast<std::size_t>(i % 700), 'x');
}

class InputQueueTest : public testing::Test {
 protected:
  ~InputQueueTest() override { std::filesystem::remove(path_); }

  static void push(InputQueue& queue, int i) {
    const std::string text = text_of(i), sender = "10.0.0." + std::to_string(i % 3);
    queue.push({.link = static_cast<std::uint16_t>(i % 5),
                .arrival = {i * 1000},
                .wall = {i * 1000 + 7},
                .sender = sender,
                .bytes = {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()}});
  }
  /// Takes frame i, whole.
  static void expect_next(InputQueue& queue, int i) {
    InputFrame frame;
    ASSERT_TRUE(queue.take(frame, 5s)) << i;
    EXPECT_EQ(std::string(frame.bytes.begin(), frame.bytes.end()), text_of(i));
    EXPECT_EQ(frame.link, i % 5);
    EXPECT_EQ(frame.arrival.ns, i * 1000);
    EXPECT_EQ(frame.wall.ns, i * 1000 + 7);
    EXPECT_EQ(frame.sender, "10.0.0." + std::to_string(i % 3));
  }
  static void expect_empty(InputQueue& queue) {
    InputFrame frame;
    EXPECT_FALSE(queue.take(frame, 0ms));
  }

  std::string path_ = testing::TempDir() + "leadline_input_" + std::to_string(::getpid());
  InputQueue::Options small_{.memory_bytes = 20'000, .spill_path = path_, .links = "udp://a\nudp://b\n"};
};

TEST_F(InputQueueTest, HandsOnInOrder) {
  auto queue = InputQueue::open({}).value();
  for (int i = 0; i < 1000; ++i) push(queue, i);
  for (int i = 0; i < 1000; ++i) expect_next(queue, i);
  expect_empty(queue);
}

TEST_F(InputQueueTest, WhatDoesNotFitWaitsOnTheDiskAndNothingOvertakes) {
  {
    auto queue = InputQueue::open(small_).value();
    int next = 0;
    for (int i = 0; i < 5000; ++i) {
      push(queue, i);
      if (i % 7 == 0) expect_next(queue, next++);
      EXPECT_LE(queue.status().waiting_bytes, small_.memory_bytes);
    }
    EXPECT_GT(queue.status().spilled_bytes, 1'000'000U);
    EXPECT_TRUE(std::filesystem::exists(path_));
    while (next < 5000) expect_next(queue, next++);
    expect_empty(queue);
    EXPECT_FALSE(std::filesystem::exists(path_)) << "an empty one is removed";
    push(queue, 42);
    expect_next(queue, 42);
    EXPECT_EQ(queue.status().lost_frames, 0U);
  }
  EXPECT_FALSE(std::filesystem::exists(path_));
}

TEST_F(InputQueueTest, TwoThreadsLoseNothing) {
  auto queue = InputQueue::open(small_).value();
  constexpr int kCount = 20'000;
  std::thread writer([&] {
    for (int i = 0; i < kCount; ++i) push(queue, i);
  });
  for (int i = 0; i < kCount; ++i) expect_next(queue, i);
  writer.join();
  expect_empty(queue);
}

TEST_F(InputQueueTest, WhatAProgramThatDiedHadNotTakenComesFirst) {
  {
    auto queue = InputQueue::open(small_).value();
    for (int i = 0; i < 3000; ++i) push(queue, i);
    int next = 0;
    while (queue.status().waiting_bytes > 0) expect_next(queue, next++);
    std::filesystem::copy_file(path_, path_ + ".copy", std::filesystem::copy_options::overwrite_existing);
  }
  std::filesystem::rename(path_ + ".copy", path_);
  std::ofstream(path_, std::ios::app) << "torn";
  auto queue = InputQueue::open(small_).value();
  const auto left = queue.status().left_behind_frames;
  ASSERT_GT(left, 100U);
  push(queue, 9999);
  InputFrame frame;
  int last = -1;
  for (std::uint64_t k = 0; k < left; ++k) {
    ASSERT_TRUE(queue.take(frame, 0ms));
    const int i = static_cast<int>(frame.arrival.ns / 1000);
    EXPECT_EQ(std::string(frame.bytes.begin(), frame.bytes.end()), text_of(i));
    if (last >= 0) {
      EXPECT_EQ(i, last + 1);
    }
    last = i;
  }
  expect_next(queue, 9999);
}

TEST_F(InputQueueTest, AFileOfOtherLinksIsRefusedAndStays) {
  {
    auto queue = InputQueue::open(small_).value();
    for (int i = 0; i < 3000; ++i) push(queue, i);
  }
  ASSERT_TRUE(std::filesystem::exists(path_)) << "it was not taken to its end";
  const auto bytes = test::read_bytes(path_);
  auto others = small_;
  others.links = "udp://c\n";
  const auto opened = InputQueue::open(others);
  ASSERT_FALSE(opened);
  EXPECT_NE(opened.error().line().find("other links"), std::string::npos) << opened.error().line();
  EXPECT_EQ(test::read_bytes(path_), bytes);
}

TEST_F(InputQueueTest, WithoutADiskWhatDoesNotFitIsLostAndCounted) {
  auto none = small_;
  none.spill_path.clear();
  auto queue = InputQueue::open(none).value();
  for (int i = 0; i < 5000; ++i) push(queue, i);
  int taken = 0;
  InputFrame frame;
  while (queue.take(frame, 0ms)) ++taken;
  EXPECT_GT(taken, 10);
  EXPECT_EQ(queue.status().lost_frames, 5000U - static_cast<unsigned>(taken));
}

}  // namespace
}  // namespace leadline::links
