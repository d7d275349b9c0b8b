#include <algorithm>
#include <array>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <vector>

#include "core/links/link_error.h"
#include "core/links/link_port.h"
#include "core/links/retry_timer.h"
#include "core/links/stream_pump.h"
#include "core/links/tcp_options.h"

namespace leadline::links {
namespace {

namespace asio = boost::asio;
using asio::ip::tcp;
using boost::system::error_code;

/// One who listens to us, with a queue of its own: a slow one delays nobody.
struct Client {
  Client(tcp::socket connected, const LinkLimits& limits, LinkAccount& account,
         StreamPump<tcp::socket>::Failed failed)
      : socket(std::move(connected)),
        queue(limits.queue_bytes),
        pump(socket, queue, account, std::move(failed)) {}

  tcp::socket socket;
  SendQueue queue;
  StreamPump<tcp::socket> pump;
  std::array<std::uint8_t, 16384> read{};
  std::string name;  ///< address:port
};

class TcpListenPort final : public LinkPort {
 public:
  TcpListenPort(IoLoop& loop, const LinkAddress& where, const LinkLimits& held_to, LinkCalls calls)
      : LinkPort(where, held_to, std::move(calls)),
        acceptor_(loop.context()),
        retry_(loop.context(), held_to) {}

  void start() override {
    if (closed_) return;
    if (const error_code error = listen()) return fail(error);
    retry_.opened();
    accept();
  }

  void wake() override {
    while (queue.take(batch_)) {
      if (clients_.empty()) {
        account.dropped(batch_.frames.size());
        continue;
      }
      const auto to_all = clients_;  // a slow one leaves the list meanwhile
      for (const auto& client : to_all) hand_to(client);
      account.handed_on(batch_.frames.size());
    }
  }

  void close() override {
    closed_ = true;
    retry_.cancel();
    error_code ignored;
    acceptor_.close(ignored);
    while (!clients_.empty()) leave(clients_.back(), false);
    drop_queue();
  }

 private:
  using Held = std::shared_ptr<Client>;
  std::shared_ptr<TcpListenPort> shared() {
    return std::static_pointer_cast<TcpListenPort>(shared_from_this());
  }

  error_code listen() {
    error_code error;
    const auto host = asio::ip::make_address(address.host, error);
    if (error) return error;
    const tcp::endpoint at(host, address.port);
    acceptor_.open(at.protocol(), error);
    if (!error) acceptor_.set_option(asio::socket_base::reuse_address(true), error);
    if (!error) acceptor_.bind(at, error);
    if (!error) acceptor_.listen(asio::socket_base::max_listen_connections, error);
    if (!error) account.opened(acceptor_.local_endpoint(error).port());
    return error;
  }

  void accept() {
    acceptor_.async_accept([self = shared(), this](const error_code& error, tcp::socket socket) {
      if (closed_) return;
      if (!error) {
        welcome(std::move(socket));
      } else if (error != asio::error::connection_aborted) {
        // Out of handles, mostly: those who are here stay, the next is let in later.
        account.trouble(link_error(address, error));
        return retry_.schedule([self, this] {
          if (!closed_) accept();
        });
      }
      accept();
    });
  }

  void welcome(tcp::socket socket) {
    set_tcp_options(socket, limits);
    // By weak pointers: a client that held itself would never go.
    const auto place = std::make_shared<std::weak_ptr<Client>>();
    auto client =
        std::make_shared<Client>(std::move(socket), limits, account, [this, place](const error_code& error) {
          if (const auto gone = place->lock()) {
            account.trouble(link_error(address, error));
            leave(gone, error == asio::error::timed_out);
          }
        });
    *place = client;
    error_code gone_already;
    const auto peer = client->socket.remote_endpoint(gone_already);
    if (!gone_already) client->name = peer.address().to_string() + ":" + std::to_string(peer.port());
    clients_.push_back(client);
    account.client_came();
    watch(client);
  }

  /// A client that leaves says so to a reader only, so it is read even where nobody listens.
  void watch(const Held& client) {
    client->socket.async_read_some(
        asio::buffer(client->read),
        [self = shared(), this, client](const error_code& error, std::size_t bytes) {
          if (error == asio::error::operation_aborted || !client->socket.is_open()) return;
          if (bytes > 0 && account.listening())
            account.heard({.bytes = std::span(client->read).first(bytes), .sender = client->name});
          if (error) return leave(client, error == asio::error::timed_out);
          watch(client);
        });
  }

  void hand_to(const Held& client) {
    const std::size_t all = batch_.frames.size();
    account.queued(all);
    for (std::size_t i = 0; i < all; ++i) {
      if (client->queue.push(batch_[i], batch_.frames[i].tag) != SendQueue::Pushed::refused) continue;
      account.dropped(all - i);
      return leave(client, true);
    }
    client->pump.wake(std::make_shared<Kept>(Kept{shared(), client}));
  }
  /// A pump's callback needs the client and the account, which is the port's.
  struct Kept {
    std::shared_ptr<TcpListenPort> port;
    Held client;
  };

  void leave(Held client, bool too_slow) {
    const auto found = std::find(clients_.begin(), clients_.end(), client);
    if (found == clients_.end()) return;
    clients_.erase(found);
    error_code ignored;
    client->socket.close(ignored);
    FrameBatch unsent;
    if (client->queue.take(unsent)) account.dropped(unsent.frames.size());
    account.client_left(too_slow);
    if (too_slow)
      account.trouble({"a client did not keep up and was let go", address.text(),
                       "it may connect again; is it reading, and its network fast enough?"});
  }

  void fail(const error_code& error) {
    account.failed(link_error(address, error));
    error_code ignored;
    acceptor_.close(ignored);
    drop_queue();
    retry_.schedule([self = shared(), this] { start(); });
  }

  tcp::acceptor acceptor_;
  RetryTimer retry_;
  std::vector<Held> clients_;
  bool closed_ = false;
};

}  // namespace

std::shared_ptr<LinkPort> make_tcp_listen_port(IoLoop& loop, const LinkAddress& address,
                                               const LinkLimits& limits, LinkCalls calls) {
  return std::make_shared<TcpListenPort>(loop, address, limits, std::move(calls));
}

}  // namespace leadline::links
