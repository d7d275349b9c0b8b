#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>

namespace leadline::links {

/// The transport part of one captured packet.
struct CapturedPacket {
  enum class Protocol : std::uint8_t { udp, tcp };
  Protocol protocol = Protocol::udp;
  bool is_v4 = true;
  std::array<std::uint8_t, 16> from{}, to{};  ///< IPv4 in the last four bytes
  std::uint16_t from_port = 0, to_port = 0;
  std::uint32_t sequence = 0;  ///< tcp: of the first payload byte
  bool begins = false;         ///< tcp: SYN; the payload begins at sequence + 1
  std::span<const std::uint8_t> payload;

  [[nodiscard]] std::string sender() const;  ///< "address:port"
};

/// Finds it in a frame of a link type (DLT_ numbers of libpcap: Ethernet with VLAN tags, Linux cooked 1 and
/// 2, raw IP, loopback), IPv4 or IPv6. Empty: no UDP or TCP, a fragment, or cut short.
[[nodiscard]] std::optional<CapturedPacket> captured_packet(int link_type,
                                                            std::span<const std::uint8_t> frame);

}  // namespace leadline::links
