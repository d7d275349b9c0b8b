#pragma once

#include <memory>
#include <mutex>

#include "core/links/link_receiver.h"
#include "core/links/link_sender.h"
#include "core/links/send_queue.h"
#include "core/types/result.h"

namespace leadline::links {

/// Whom a link calls, on the I/O thread.
struct LinkCalls {
  LinkSender::Sent sent;
  LinkReceiver::Heard heard;
};

/// A link's books; from any thread.
class LinkAccount {
 public:
  explicit LinkAccount(LinkCalls calls) : calls_(std::move(calls)) {}

  /// Whether anybody listens: then what is read is handed to heard().
  [[nodiscard]] bool listening() const { return calls_.heard != nullptr; }
  void heard(const Hearing& hearing);
  void kernel_dropped(std::uint64_t all_so_far);
  void receive_buffer(std::size_t bytes);

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

  /// From here on nobody is called. On the I/O thread.
  void stop_telling() { calls_ = {}; }

  [[nodiscard]] LinkStatus status() const;
  [[nodiscard]] bool idle() const;

 private:
  LinkCalls calls_;
  mutable std::mutex mutex_;
  LinkStatus status_;
  std::size_t under_way_ = 0;
};

/// A link as the I/O thread sees it: all but queue and account are touched on that thread only. Callbacks
/// hold the port, so it lives until the last one has run.
class LinkPort : public std::enable_shared_from_this<LinkPort> {
 public:
  LinkPort(LinkAddress where, const LinkLimits& held_to, LinkCalls calls)
      : address(std::move(where)), limits(held_to), queue(held_to.queue_bytes), account(std::move(calls)) {}
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

/// The port of a link's kind: one that hears where somebody listens, else one that sends.
[[nodiscard]] std::shared_ptr<LinkPort> make_port(IoLoop&, const LinkAddress&, const LinkLimits&, LinkCalls);
[[nodiscard]] std::shared_ptr<LinkPort> make_udp_port(IoLoop&, const LinkAddress&, const LinkLimits&,
                                                      LinkCalls);
[[nodiscard]] std::shared_ptr<LinkPort> make_udp_input_port(IoLoop&, const LinkAddress&, const LinkLimits&,
                                                            LinkCalls);
[[nodiscard]] std::shared_ptr<LinkPort> make_tcp_client_port(IoLoop&, const LinkAddress&, const LinkLimits&,
                                                             LinkCalls);
[[nodiscard]] std::shared_ptr<LinkPort> make_tcp_listen_port(IoLoop&, const LinkAddress&, const LinkLimits&,
                                                             LinkCalls);
[[nodiscard]] std::shared_ptr<LinkPort> make_serial_port(IoLoop&, const LinkAddress&, const LinkLimits&,
                                                         LinkCalls);
[[nodiscard]] std::shared_ptr<LinkPort> make_file_port(IoLoop&, const LinkAddress&, const LinkLimits&,
                                                       LinkCalls);
[[nodiscard]] std::shared_ptr<LinkPort> make_file_input_port(IoLoop&, const LinkAddress&, const LinkLimits&,
                                                             LinkCalls);

}  // namespace leadline::links
