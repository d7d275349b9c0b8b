#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "core/types/result.h"

namespace leadline::links {

enum class LinkKind : std::uint8_t { serial, udp, tcp, tcp_listen, file };

/// Where bytes come from or go to, as `link` of a configuration says it; kind tells which members count.
struct LinkAddress {
  enum class Parity : std::uint8_t { none, even, odd };
  enum class Flow : std::uint8_t { none, rts, xon };

  LinkKind kind = LinkKind::udp;
  std::string host;        ///< udp, tcp, tcp_listen: a name or an address, IPv6 without its brackets
  std::uint16_t port = 0;  ///< 0: tcp_listen alone, the system chooses
  std::string iface;  ///< udp multicast: name or IPv4 address of the network interface; empty: the system's
  int ttl = 1;        ///< udp multicast: hops, 1..255
  std::string path;   ///< serial, file: absolute
  std::int64_t baud = 115200;
  int data_bits = 8, stop_bits = 1;
  Parity parity = Parity::none;
  Flow flow = Flow::none;
  bool follow = false;  ///< file: what is appended later belongs to it

  bool operator==(const LinkAddress&) const = default;
  /// As parse_link() reads it, without the keys that have their defaults.
  [[nodiscard]] std::string text() const;
  [[nodiscard]] bool multicast() const;  ///< the host is a multicast address
  [[nodiscard]] bool ipv6() const { return host.find(':') != std::string::npos; }
};

/// Reads one of
///   serial:///dev/ttyUSB0?baud=115200&parity=n|e|o&flow=none|rts|xon&data=5..8&stop=1|2
///   udp://HOST:PORT, udp://239.192.0.4:60004?iface=eth0&ttl=1, tcp://HOST:PORT
///   tcp-listen://0.0.0.0:PORT, file:///x?follow=1
/// with IPv6 addresses in brackets and %20 for a blank in a path. The first mistake is named with what to
/// write instead.
[[nodiscard]] Result<LinkAddress> parse_link(std::string_view text);

/// The link on which another program hears what is sent to `sending`: the other side of a connection, the
/// same port or file. Empty for a serial line: which device its other end is, nobody here knows.
[[nodiscard]] std::optional<LinkAddress> receiving_side(const LinkAddress& sending);

}  // namespace leadline::links
