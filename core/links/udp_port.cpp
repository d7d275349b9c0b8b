#include <net/if.h>
#include <netinet/in.h>

#include <boost/asio/buffer.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/multicast.hpp>
#include <boost/asio/ip/udp.hpp>

#include "core/links/endpoints.h"
#include "core/links/link_error.h"
#include "core/links/link_port.h"
#include "core/links/retry_timer.h"

namespace leadline::links {
namespace {

namespace asio = boost::asio;
using asio::ip::udp;
using boost::system::error_code;

error_code last_system_error() { return {errno, boost::system::system_category()}; }

class UdpPort final : public LinkPort {
 public:
  UdpPort(IoLoop& loop, const LinkAddress& where, const LinkLimits& held_to, LinkCalls calls)
      : LinkPort(where, held_to, std::move(calls)),
        socket_(loop.context()),
        resolver_(loop.context()),
        retry_(loop.context(), held_to) {}

  void start() override {
    if (closed_) return;
    find_endpoints<udp>(resolver_, address.host, address.port,
                        [self = shared(), this](error_code error, const std::vector<udp::endpoint>& found) {
                          if (closed_) return;
                          if (!error) error = open(found.front());
                          if (error) return fail(error);
                          retry_.opened();
                          account.opened();
                        });
  }

  void wake() override {
    if (!socket_.is_open()) return drop_queue();
    if (!waiting_) send_all();
  }

  void close() override {
    closed_ = true;
    resolver_.cancel();
    retry_.cancel();
    error_code ignored;
    socket_.close(ignored);
    drop_rest();
    drop_queue();
  }

 private:
  std::shared_ptr<UdpPort> shared() { return std::static_pointer_cast<UdpPort>(shared_from_this()); }

  error_code open(const udp::endpoint& to) {
    error_code error;
    to_ = to;
    socket_.open(to.protocol(), error);
    if (!error) socket_.non_blocking(true, error);
    if (!error && to.address().is_v4()) socket_.set_option(asio::socket_base::broadcast(true), error);
    if (!error && to.address().is_multicast()) error = set_multicast();
    return error;
  }

  error_code set_multicast() {
    error_code error;
    socket_.set_option(asio::ip::multicast::hops(address.ttl), error);
    // Programs on this computer hear it too.
    if (!error) socket_.set_option(asio::ip::multicast::enable_loopback(true), error);
    if (error || address.iface.empty()) return error;
    error_code is_name;
    const auto own = asio::ip::make_address_v4(address.iface, is_name);
    if (!is_name && to_.address().is_v4()) {
      socket_.set_option(asio::ip::multicast::outbound_interface(own), error);
      return error;
    }
    const unsigned index = ::if_nametoindex(address.iface.c_str());
    if (index == 0) return {ENODEV, boost::system::system_category()};
    if (to_.address().is_v6()) {
      socket_.set_option(asio::ip::multicast::outbound_interface(index), error);
      return error;
    }
    ip_mreqn by_index{};
    by_index.imr_ifindex = static_cast<int>(index);
    if (::setsockopt(socket_.native_handle(), IPPROTO_IP, IP_MULTICAST_IF, &by_index, sizeof by_index) != 0)
      return last_system_error();
    return {};
  }

  /// Until the queue is empty or the system's buffer full: then when it has room again.
  void send_all() {
    for (;;) {
      for (; next_ < batch_.frames.size(); ++next_) {
        const auto frame = batch_[next_];
        error_code error;
        socket_.send_to(asio::buffer(frame.data(), frame.size()), to_, 0, error);
        if (error == asio::error::would_block || error == asio::error::no_buffer_space)
          return wait_for_room();
        if (!error) {
          account.sent(frame.size(), batch_.frames[next_].tag);
        } else {
          account.dropped(1);
          account.trouble(link_error(address, error));
        }
      }
      next_ = 0;
      if (!queue.take(batch_)) return;
    }
  }

  void wait_for_room() {
    waiting_ = true;
    socket_.async_wait(udp::socket::wait_write, [self = shared(), this](const error_code& error) {
      waiting_ = false;
      if (!error && !closed_) send_all();
    });
  }

  void fail(const error_code& error) {
    account.failed(link_error(address, error));
    error_code ignored;
    socket_.close(ignored);
    drop_queue();
    retry_.schedule([self = shared(), this] { start(); });
  }

  void drop_rest() {
    if (next_ < batch_.frames.size()) account.dropped(batch_.frames.size() - next_);
    batch_.clear();
    next_ = 0;
  }

  udp::socket socket_;
  udp::resolver resolver_;
  RetryTimer retry_;
  udp::endpoint to_;
  std::size_t next_ = 0;  ///< frame of the batch
  bool waiting_ = false, closed_ = false;
};

}  // namespace

std::shared_ptr<LinkPort> make_udp_port(IoLoop& loop, const LinkAddress& address, const LinkLimits& limits,
                                        LinkCalls calls) {
  return std::make_shared<UdpPort>(loop, address, limits, std::move(calls));
}

}  // namespace leadline::links
