#pragma once

#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "maps/charts/raster_chart.h"

namespace leadline::ui {

/// One square of one chart: 256 px of 2^level m, counted from the origin of a plane, east and north.
struct TileKey {
  int chart = 0;  ///< a number never used again
  int plane = 0;  ///< likewise
  int level = 0;
  std::int64_t east = 0, north = 0;
  bool operator==(const TileKey&) const = default;
};
struct TileKeyHash {
  std::size_t operator()(const TileKey& key) const;
};

/// The threads that read charts, so that nothing else ever waits for a disk: few, and of low priority. They
/// hand their results on themselves.
class TileWorkers {
 public:
  /// The charts that this worker has open, by TileKey::chart.
  using OpenCharts = std::map<int, Result<maps::RasterChart>>;
  using Job = std::function<void(OpenCharts&)>;
  struct TileJob {
    TileKey key;
    Job run;
  };

  explicit TileWorkers(int threads = 2);
  /// Waits for the jobs in hand; the rest is dropped.
  ~TileWorkers();
  TileWorkers(const TileWorkers&) = delete;
  TileWorkers& operator=(const TileWorkers&) = delete;

  /// To be done first, in the order given.
  void add(Job job);
  /// The tiles wanted now, most wanted first. Those wanted before and not begun are dropped; those in hand
  /// (until taken()) are not begun twice.
  void want(std::vector<TileJob> jobs);
  /// Its result has been received.
  void taken(const TileKey& key);
  /// No tile waits, is in hand or on its way.
  [[nodiscard]] bool no_tiles() const;

 private:
  void work();

  mutable std::mutex mutex_;
  std::condition_variable wake_;
  std::deque<Job> first_;
  std::deque<TileJob> wanted_;
  std::vector<TileKey> in_hand_;
  bool stop_ = false;
  std::vector<std::thread> threads_;
};

}  // namespace leadline::ui
