#include "ui/chart/tile_workers.h"

#include <sys/resource.h>

#include <algorithm>

namespace leadline::ui {
namespace {

constexpr int kNiceness = 10;

}  // namespace

std::size_t TileKeyHash::operator()(const TileKey& key) const {
  std::uint64_t h = 0;
  for (const std::int64_t part :
       {std::int64_t{key.chart}, std::int64_t{key.plane}, std::int64_t{key.level}, key.east, key.north}) {
    h = (h ^ static_cast<std::uint64_t>(part)) * 0x9E3779B97F4A7C15u;
    h ^= h >> 32;
  }
  return static_cast<std::size_t>(h);
}

TileWorkers::TileWorkers(int threads) {
  for (int i = 0; i < threads; ++i) threads_.emplace_back([this] { work(); });
}

TileWorkers::~TileWorkers() {
  {
    const std::lock_guard lock(mutex_);
    stop_ = true;
  }
  wake_.notify_all();
  for (auto& thread : threads_) thread.join();
}

void TileWorkers::add(Job job) {
  {
    const std::lock_guard lock(mutex_);
    first_.push_back(std::move(job));
  }
  wake_.notify_one();
}

void TileWorkers::want(std::vector<TileJob> jobs) {
  {
    const std::lock_guard lock(mutex_);
    wanted_.clear();
    for (auto& job : jobs) {
      if (std::find(in_hand_.begin(), in_hand_.end(), job.key) == in_hand_.end())
        wanted_.push_back(std::move(job));
    }
  }
  wake_.notify_all();
}

void TileWorkers::taken(const TileKey& key) {
  const std::lock_guard lock(mutex_);
  in_hand_.erase(std::remove(in_hand_.begin(), in_hand_.end(), key), in_hand_.end());
}

bool TileWorkers::no_tiles() const {
  const std::lock_guard lock(mutex_);
  return wanted_.empty() && in_hand_.empty();
}

void TileWorkers::work() {
  setpriority(PRIO_PROCESS, 0, kNiceness);  // of this thread alone, on Linux
  OpenCharts charts;
  for (;;) {
    Job job;
    {
      std::unique_lock lock(mutex_);
      wake_.wait(lock, [this] { return stop_ || !first_.empty() || !wanted_.empty(); });
      if (stop_) return;
      if (!first_.empty()) {
        job = std::move(first_.front());
        first_.pop_front();
      } else {
        in_hand_.push_back(wanted_.front().key);
        job = std::move(wanted_.front().run);
        wanted_.pop_front();
      }
    }
    job(charts);
  }
}

}  // namespace leadline::ui
