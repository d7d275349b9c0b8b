#include "core/links/capture_packet.h"

#include <arpa/inet.h>
#include <pcap/dlt.h>

#include <algorithm>

namespace leadline::links {
namespace {

using Bytes = std::span<const std::uint8_t>;

std::uint16_t u16(Bytes b, std::size_t at) { return static_cast<std::uint16_t>(b[at] << 8 | b[at + 1]); }
std::uint32_t u32(Bytes b, std::size_t at) {
  return static_cast<std::uint32_t>(u16(b, at)) << 16 | u16(b, at + 2);
}

constexpr std::uint16_t kIpv4 = 0x0800, kIpv6 = 0x86DD, kVlan = 0x8100, kServiceVlan = 0x88A8;

/// The network layer of an Ethernet type; empty for others.
std::optional<Bytes> behind_type(Bytes b, std::size_t type_at) {
  while (b.size() >= type_at + 6 && (u16(b, type_at) == kVlan || u16(b, type_at) == kServiceVlan))
    type_at += 4;
  if (b.size() < type_at + 2) return std::nullopt;
  const std::uint16_t type = u16(b, type_at);
  if (type != kIpv4 && type != kIpv6) return std::nullopt;
  return b.subspan(type_at + 2);
}

std::optional<Bytes> network_layer(int link_type, Bytes b) {
  switch (link_type) {
    case DLT_EN10MB:
      return behind_type(b, 12);
    case DLT_LINUX_SLL:
      return behind_type(b, 14);
    case DLT_LINUX_SLL2:
      if (b.size() < 20 || (u16(b, 0) != kIpv4 && u16(b, 0) != kIpv6)) return std::nullopt;
      return b.subspan(20);
    case DLT_NULL:
    case DLT_LOOP:
      return b.size() < 4 ? std::nullopt : std::optional(b.subspan(4));
    case DLT_RAW:
    case DLT_IPV4:
    case DLT_IPV6:
      return b;
    default:
      return std::nullopt;
  }
}

struct Network {
  std::uint8_t protocol = 0;
  Bytes payload;
};

std::optional<Network> ipv4(Bytes b, CapturedPacket& packet) {
  if (b.size() < 20) return std::nullopt;
  const std::size_t header = (b[0] & 0x0FU) * 4U, total = u16(b, 2);
  if (header < 20 || total < header || b.size() < total) return std::nullopt;
  if ((u16(b, 6) & 0x3FFF) != 0) return std::nullopt;  // more fragments, or one of them
  std::copy_n(b.begin() + 12, 4, packet.from.begin() + 12);
  std::copy_n(b.begin() + 16, 4, packet.to.begin() + 12);
  return Network{b[9], b.subspan(header, total - header)};
}

std::optional<Network> ipv6(Bytes b, CapturedPacket& packet) {
  if (b.size() < 40 || b.size() < 40U + u16(b, 4)) return std::nullopt;
  packet.is_v4 = false;
  std::copy_n(b.begin() + 8, 16, packet.from.begin());
  std::copy_n(b.begin() + 24, 16, packet.to.begin());
  Network network{b[6], b.subspan(40, u16(b, 4))};
  constexpr std::uint8_t kHopByHop = 0, kRouting = 43, kDestination = 60;
  while (network.protocol == kHopByHop || network.protocol == kRouting || network.protocol == kDestination) {
    if (network.payload.size() < 8) return std::nullopt;
    const std::size_t length = 8U * (network.payload[1] + 1U);
    if (network.payload.size() < length) return std::nullopt;
    network = {network.payload[0], network.payload.subspan(length)};
  }
  return network;
}

}  // namespace

std::string CapturedPacket::sender() const {
  std::array<char, INET6_ADDRSTRLEN> text{};
  (void)::inet_ntop(is_v4 ? AF_INET : AF_INET6, from.data() + (is_v4 ? 12 : 0), text.data(), text.size());
  return std::string(text.data()) + ":" + std::to_string(from_port);
}

std::optional<CapturedPacket> captured_packet(int link_type, Bytes frame) {
  const auto bytes = network_layer(link_type, frame);
  if (!bytes || bytes->empty()) return std::nullopt;
  CapturedPacket packet;
  const int version = (*bytes)[0] >> 4;
  const auto network = version == 4   ? ipv4(*bytes, packet)
                       : version == 6 ? ipv6(*bytes, packet)
                                      : std::nullopt;
  if (!network) return std::nullopt;
  const Bytes b = network->payload;
  constexpr std::uint8_t kTcp = 6, kUdp = 17;
  if (network->protocol == kUdp) {
    if (b.size() < 8 || u16(b, 4) < 8 || b.size() < u16(b, 4)) return std::nullopt;
    packet.payload = b.subspan(8, u16(b, 4) - 8U);
  } else if (network->protocol == kTcp) {
    if (b.size() < 20) return std::nullopt;
    const std::size_t header = static_cast<std::size_t>(b[12] >> 4) * 4;
    if (header < 20 || b.size() < header) return std::nullopt;
    packet.protocol = CapturedPacket::Protocol::tcp;
    packet.sequence = u32(b, 4);
    packet.begins = (b[13] & 0x02) != 0;
    packet.payload = b.subspan(header);
  } else {
    return std::nullopt;
  }
  packet.from_port = u16(b, 0);
  packet.to_port = u16(b, 2);
  return packet;
}

}  // namespace leadline::links
