#include <boost/asio/connect.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <vector>

#include "core/links/endpoints.h"
#include "core/links/stream_port.h"
#include "core/links/tcp_options.h"

namespace leadline::links {
namespace {

using boost::asio::ip::tcp;
using boost::system::error_code;

class TcpClientPort final : public StreamPort<tcp::socket> {
 public:
  TcpClientPort(IoLoop& loop, const LinkAddress& where, const LinkLimits& held_to, LinkCalls calls)
      : StreamPort(loop, where, held_to, std::move(calls)), resolver_(loop.context()) {}

  void close() override {
    resolver_.cancel();
    StreamPort::close();
  }

 private:
  void open() override {
    find_endpoints<tcp>(
        resolver_, address.host, address.port,
        [self = shared_from_this(), this](const error_code& error, const std::vector<tcp::endpoint>& found) {
          if (closed()) return;
          if (error) return fail(error);
          connect(found);
        });
  }

  void connect(const std::vector<tcp::endpoint>& found) {
    enum class Try : std::uint8_t { under_way, ended, too_late };
    const auto attempt = std::make_shared<Try>(Try::under_way);
    retry_.limit(limits.dead_peer, [self = shared_from_this(), this, attempt] {
      if (*attempt != Try::under_way) return;  // the callback was on its way when the timer was cancelled
      *attempt = Try::too_late;
      error_code ignored;
      stream_.close(ignored);
    });
    boost::asio::async_connect(
        stream_, found, [self = shared_from_this(), this, attempt](error_code error, const tcp::endpoint&) {
          if (closed()) return;
          if (*attempt == Try::too_late) error = boost::asio::error::timed_out;
          *attempt = Try::ended;
          if (error) return fail(error);
          set_tcp_options(stream_, limits);
          opened();
        });
  }

  tcp::resolver resolver_;
};

}  // namespace

std::shared_ptr<LinkPort> make_tcp_client_port(IoLoop& loop, const LinkAddress& address,
                                               const LinkLimits& limits, LinkCalls calls) {
  return std::make_shared<TcpClientPort>(loop, address, limits, std::move(calls));
}

}  // namespace leadline::links
