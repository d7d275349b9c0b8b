#pragma once

#include <memory>
#include <mutex>

#include "core/links/link_sender.h"
#include "core/links/send_queue.h"
#include "core/types/result.h"

namespace leadline::links {

/// A link's books; from any thread.
class LinkAccount {
 public:
  explicit LinkAccount(LinkSender::Sent sent) : sent_(std::move(sent)) {}

  void queued(std::size_t frames);
  /// The system took this many bytes of a batch: the frames wholly among them are sent, the others dropped.
  void settle(const FrameBatch& batch, std::size_t bytes);
  void sent(std::size_t bytes, std::int64_t tag);
  void dropped(std::size_t frames);
  /// Frames left the queue for those of the clients, which keep their own account.
  void handed_on(std::size_t frames);

  void opened(std::uint16_t port = 0);
  void failed(const Error& error);   ///< and closed
  void trouble(const Error& error);  ///< and goes on
  void client_came();
  void client_left(bool too_slow);

  /// From here on nobody is told what was sent. On the I/O thread.
  void stop_telling() { sent_ = nullptr; }

  [[nodiscard]] LinkStatus status() const;
  [[nodiscard]] bool idle() const;

 private:
  LinkSender::Sent sent_;
  mutable std::mutex mutex_;
  LinkStatus status_;
  std::size_t under_way_ = 0;
};

/// A link as the I/O thread sees it: all but queue and account are touched on that thread only. Callbacks
/// hold the port, so it lives until the last one has run.
class LinkPort : public std::enable_shared_from_this<LinkPort> {
 public:
  LinkPort(LinkAddress where, const LinkLimits& held_to, LinkSender::Sent sent)
      : address(std::move(where)), limits(held_to), queue(held_to.queue_bytes), account(std::move(sent)) {}
  virtual ~LinkPort() = default;
  LinkPort(const LinkPort&) = delete;
  LinkPort& operator=(const LinkPort&) = delete;

  virtual void start() = 0;
  virtual void wake() = 0;   ///< the queue is no longer empty
  virtual void close() = 0;  ///< for good

  const LinkAddress address;
  const LinkLimits limits;
  SendQueue queue;
  LinkAccount account;

 protected:
  /// What waits is dropped.
  void drop_queue();
  FrameBatch batch_;
};

[[nodiscard]] std::shared_ptr<LinkPort> make_udp_port(IoLoop&, const LinkAddress&, const LinkLimits&,
                                                      LinkSender::Sent);
[[nodiscard]] std::shared_ptr<LinkPort> make_tcp_client_port(IoLoop&, const LinkAddress&, const LinkLimits&,
                                                             LinkSender::Sent);
[[nodiscard]] std::shared_ptr<LinkPort> make_tcp_listen_port(IoLoop&, const LinkAddress&, const LinkLimits&,
                                                             LinkSender::Sent);
[[nodiscard]] std::shared_ptr<LinkPort> make_serial_port(IoLoop&, const LinkAddress&, const LinkLimits&,
                                                         LinkSender::Sent);
[[nodiscard]] std::shared_ptr<LinkPort> make_file_port(IoLoop&, const LinkAddress&, const LinkLimits&,
                                                       LinkSender::Sent);

}  // namespace leadline::links
