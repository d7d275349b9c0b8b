#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <string>

#include "core/types/time.h"

namespace leadline::sessions {

/// How long a disk will take a recording, from how the free space shrank over the last ten minutes: whoever
/// else writes there counts too.
class DiskForecast {
 public:
  static constexpr Duration kLookBack{600'000'000'000};
  static constexpr Duration kLeastTime{3'600'000'000'000};  ///< left, then it is told
  static constexpr double kLeastShare = 0.1;                ///< of the disk free, then it is told

  struct Disk {
    std::uint64_t free_bytes = 0, all_bytes = 0;
  };
  struct Outlook {
    Disk disk;
    std::optional<Duration> left;  ///< until it is full; empty: it does not shrink, or nobody knows yet
    bool short_of_space = false;   ///< 10 % or an hour left, whichever comes first
  };
  /// Times must not go back; once every few seconds suffices.
  [[nodiscard]] Outlook look(Arrival now, const Disk& disk);

 private:
  struct Seen {
    Arrival at;
    std::uint64_t free_bytes;
  };
  std::deque<Seen> seen_;
};

/// The disk that holds a file; empty where the system does not tell.
[[nodiscard]] std::optional<DiskForecast::Disk> disk_of(const std::string& path);

}  // namespace leadline::sessions
