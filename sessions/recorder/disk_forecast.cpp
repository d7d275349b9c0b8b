#include "sessions/recorder/disk_forecast.h"

#include <sys/statvfs.h>

#include <filesystem>

namespace leadline::sessions {
namespace {

/// A shorter look says more about one checkpoint than about the recording.
constexpr Duration kLeastLook{30'000'000'000};

}  // namespace

DiskForecast::Outlook DiskForecast::look(Arrival now, const Disk& disk) {
  while (!seen_.empty() && now - seen_.front().at > kLookBack) seen_.pop_front();
  Outlook outlook{disk, std::nullopt, false};
  if (!seen_.empty() && now - seen_.front().at >= kLeastLook && seen_.front().free_bytes > disk.free_bytes) {
    const auto taken = static_cast<double>(seen_.front().free_bytes - disk.free_bytes);
    const double bytes_per_s = taken / seconds(now - seen_.front().at);
    const double left_s = static_cast<double>(disk.free_bytes) / bytes_per_s;
    constexpr double kForEver_s = 1e9;
    if (left_s < kForEver_s) outlook.left = duration(left_s);
  }
  const double share =
      disk.all_bytes == 0 ? 1.0 : static_cast<double>(disk.free_bytes) / static_cast<double>(disk.all_bytes);
  outlook.short_of_space = share < kLeastShare || (outlook.left && *outlook.left < kLeastTime);
  seen_.push_back({now, disk.free_bytes});
  return outlook;
}

std::optional<DiskForecast::Disk> disk_of(const std::string& path) {
  const std::string folder = std::filesystem::path(path).parent_path().string();
  struct statvfs about {};
  if (::statvfs(folder.empty() ? "." : folder.c_str(), &about) != 0) return std::nullopt;
  return DiskForecast::Disk{std::uint64_t{about.f_bavail} * about.f_frsize,
                            std::uint64_t{about.f_blocks} * about.f_frsize};
}

}  // namespace leadline::sessions
