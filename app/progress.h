#pragma once

#include <fmt/format.h>

#include <cstdint>
#include <cstdio>
#include <string>

namespace leadline::app {

/// A bar on a terminal, redrawn each half per cent.
class Progress {
 public:
  Progress(bool shown, std::uint64_t total_bytes) : shown_(shown), total_(total_bytes) {}
  ~Progress() {
    if (shown_) std::fputs("\r\033[K", stderr);
  }
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  void add(std::uint64_t bytes) {
    done_ += bytes;
    if (!shown_ || total_ == 0 || done_ < next_) return;
    next_ = done_ + total_ / 200 + 1;
    const auto parts = static_cast<std::size_t>(40 * std::min(done_, total_) / total_);
    fmt::print(stderr, "\r[{:<40}] {:3.0f} %", std::string(parts, '='),
               100.0 * static_cast<double>(done_) / static_cast<double>(total_));
  }

 private:
  bool shown_;
  std::uint64_t total_, done_ = 0, next_ = 0;
};

}  // namespace leadline::app
