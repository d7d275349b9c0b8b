#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string_view>

#include "core/links/link_sender.h"

namespace leadline::links {

/// What a link heard: a datagram, or as much of a stream as one read gave. Views are good during the call.
struct Hearing {
  std::span<const std::uint8_t> bytes;
  std::string_view sender;                       ///< "address:port" over UDP and from clients; else empty
  std::optional<std::int64_t> kernel_wall_ns{};  ///< when the kernel had it, by the wall clock; UDP only
};

/// Hears a link: a serial line, datagrams to a port or group, a TCP server, the clients of our own server, a
/// file that grows. A link that fails heals itself as a LinkSender's does.
class LinkReceiver {
 public:
  /// Called on the I/O thread; it must not wait.
  using Heard = std::function<void(const Hearing&)>;

  LinkReceiver(IoLoop& loop, const LinkAddress& address, const LinkLimits& limits, Heard heard);
  /// Closes; nobody is called afterwards.
  ~LinkReceiver();
  LinkReceiver(const LinkReceiver&) = delete;
  LinkReceiver& operator=(const LinkReceiver&) = delete;

  [[nodiscard]] LinkStatus status() const;
  [[nodiscard]] const LinkAddress& address() const;

 private:
  IoLoop& loop_;
  std::shared_ptr<LinkPort> port_;
};

}  // namespace leadline::links
