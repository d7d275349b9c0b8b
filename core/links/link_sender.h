#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>

#include "core/links/io_loop.h"
#include "core/links/link_address.h"

namespace leadline::links {

/// What a link does and suffers. A frame is what one send() was given; a tcp-listen link counts it once for
/// each client.
struct LinkStatus {
  bool open = false;                 ///< what is sent now goes out; tcp-listen: it listens
  std::uint64_t sent_frames = 0;     ///< taken by the system
  std::uint64_t sent_bytes = 0;      ///< of those
  std::uint64_t dropped_frames = 0;  ///< never sent: link down, queue full, no client
  std::uint64_t times_opened = 0;
  std::size_t clients = 0;                          ///< tcp-listen: connected now
  std::uint64_t dropped_clients = 0;                ///< tcp-listen: were too slow
  std::uint16_t port = 0;                           ///< tcp-listen: which one the system gave
  std::uint64_t heard_bytes = 0, heard_frames = 0;  ///< datagrams, or reads of a stream
  std::uint64_t kernel_drops = 0;                   ///< udp: the kernel had no room for
  std::size_t receive_buffer = 0;                   ///< udp: as the kernel grants it, bytes
  std::string last_error;                           ///< one sentence; kept when the link is open again
};

/// The figures a link keeps to; the defaults are for use, others for tests.
struct LinkLimits {
  std::size_t queue_bytes = 1 << 20;            ///< waiting in memory, also of each client
  std::chrono::milliseconds retry_first{1000};  ///< from one try to the next, doubled up to the last
  std::chrono::milliseconds retry_last{30000};
  std::chrono::milliseconds settled{5000};     ///< open this long, the next failure starts at the first again
  std::chrono::milliseconds dead_peer{10000};  ///< a TCP peer that neither answers nor reads is given up
  int send_buffer = 0;                         ///< TCP, bytes in the kernel; 0: the system's choice
};

class LinkPort;

/// Sends frames over a link: a datagram each over UDP, otherwise bytes one behind the other. A link that
/// fails heals itself: it is opened again after 1 to 30 s (a device after 2 s at most), and what comes
/// meanwhile is dropped and counted, as is what a slow receiver leaves no room for: a receiver wants the
/// newest, and memory stays bounded. After a failure a stream goes on with a whole frame.
class LinkSender {
 public:
  /// Called on the I/O thread when the system has taken a frame.
  using Sent = std::function<void(std::int64_t tag)>;

  LinkSender(IoLoop& loop, const LinkAddress& address, const LinkLimits& limits = {}, Sent sent = {});
  /// Closes at once; finish() first for what is under way. No `sent` is called afterwards.
  ~LinkSender();
  LinkSender(const LinkSender&) = delete;
  LinkSender& operator=(const LinkSender&) = delete;

  /// Hands a copy to the I/O thread and returns; never blocks. False: dropped at once, the queue is full.
  bool send(std::span<const std::uint8_t> frame, std::int64_t tag = 0);
  [[nodiscard]] LinkStatus status() const;
  /// Waits until every frame is sent or dropped; false when some are still under way after `at_most`.
  bool finish(std::chrono::milliseconds at_most);
  [[nodiscard]] const LinkAddress& address() const;

 private:
  IoLoop& loop_;
  std::shared_ptr<LinkPort> port_;
};

}  // namespace leadline::links
