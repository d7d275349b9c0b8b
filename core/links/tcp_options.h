#pragma once

#include <netinet/in.h>
#include <netinet/tcp.h>

#include <algorithm>
#include <boost/asio/ip/tcp.hpp>

#include "core/links/link_sender.h"

namespace leadline::links {

/// Small frames go out at once, and a peer that is gone without a word (half-open) or takes nothing more is
/// given up after limits.dead_peer. What the system does not know stays as it is.
inline void set_tcp_options(boost::asio::ip::tcp::socket& socket, const LinkLimits& limits) {
  boost::system::error_code ignored;
  socket.set_option(boost::asio::ip::tcp::no_delay(true), ignored);
  socket.set_option(boost::asio::socket_base::keep_alive(true), ignored);
  if (limits.send_buffer > 0)
    socket.set_option(boost::asio::socket_base::send_buffer_size(limits.send_buffer), ignored);
  const auto set = [&](int option, std::int64_t value) {
    const int number = static_cast<int>(std::max<std::int64_t>(value, 1));
    (void)::setsockopt(socket.native_handle(), IPPROTO_TCP, option, &number, sizeof number);
  };
  const std::int64_t dead_s = limits.dead_peer.count() / 1000;
  set(TCP_USER_TIMEOUT, limits.dead_peer.count());
  set(TCP_KEEPIDLE, dead_s / 2);
  set(TCP_KEEPINTVL, dead_s / 5);
  set(TCP_KEEPCNT, 2);
}

}  // namespace leadline::links
