#pragma once

#include <boost/asio/steady_timer.hpp>
#include <chrono>
#include <random>
#include <utility>

#include "core/links/back_off.h"
#include "core/links/link_sender.h"

namespace leadline::links {

/// When a link that failed is tried again.
class RetryTimer {
 public:
  RetryTimer(boost::asio::io_context& context, const LinkLimits& limits)
      : timer_(context),
        back_off_(limits.retry_first, limits.retry_last, std::random_device{}()),
        settled_(limits.settled) {}

  void opened() { opened_at_ = std::chrono::steady_clock::now(); }

  /// Runs `again` after the wait. A link that had not settled waits longer each time, so that a server that
  /// accepts and closes is not called once a second for ever.
  template <class Again>
  void schedule(Again again) {
    const auto now = std::chrono::steady_clock::now();
    if (opened_at_ != Instant{} && now - opened_at_ >= settled_) back_off_.reset();
    opened_at_ = {};
    timer_.expires_after(back_off_.next());
    timer_.async_wait([again = std::move(again)](const boost::system::error_code& stopped) {
      if (!stopped) again();
    });
  }
  /// Runs `late` unless something else is scheduled or cancelled before.
  template <class Late>
  void limit(std::chrono::milliseconds most, Late late) {
    timer_.expires_after(most);
    timer_.async_wait([late = std::move(late)](const boost::system::error_code& stopped) {
      if (!stopped) late();
    });
  }
  void cancel() { timer_.cancel(); }

 private:
  using Instant = std::chrono::steady_clock::time_point;
  boost::asio::steady_timer timer_;
  BackOff back_off_;
  std::chrono::milliseconds settled_;
  Instant opened_at_;
};

}  // namespace leadline::links
