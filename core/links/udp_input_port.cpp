#include <net/if.h>
#include <netinet/in.h>
#include <sys/socket.h>

#include <algorithm>
#include <array>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/multicast.hpp>
#include <boost/asio/ip/udp.hpp>
#include <cstring>
#include <memory>
#include <unordered_map>
#include <vector>

#include "core/links/endpoints.h"
#include "core/links/link_error.h"
#include "core/links/link_port.h"
#include "core/links/retry_timer.h"

namespace leadline::links {
namespace {

namespace asio = boost::asio;
using asio::ip::udp;
using boost::system::error_code;

constexpr int kWantedBuffer = 8 << 20;
constexpr std::size_t kBatch = 32, kDatagram = 65536;
constexpr int kBatchesATurn = 4;        ///< then the other links have theirs
constexpr int kBatchesAtTheEnd = 2048;  ///< what the kernel still holds when the link is closed
constexpr std::size_t kMostSenders = 1024;

error_code last_system_error() { return {errno, boost::system::system_category()}; }

/// Room for what one call of the kernel hands over; there is one I/O thread, so one is enough for all ports.
struct Batch {
  std::vector<std::uint8_t> bytes = std::vector<std::uint8_t>(kBatch * kDatagram);
  std::array<mmsghdr, kBatch> messages{};
  std::array<iovec, kBatch> pieces{};
  std::array<sockaddr_storage, kBatch> senders{};
  struct alignas(cmsghdr) Control {
    std::array<std::uint8_t, 128> bytes;
  };
  std::array<Control, kBatch> controls{};

  void prepare() {
    for (std::size_t i = 0; i < kBatch; ++i) {
      pieces[i] = {bytes.data() + i * kDatagram, kDatagram};
      msghdr& header = messages[i].msg_hdr;
      header = {};
      header.msg_name = &senders[i], header.msg_namelen = sizeof senders[i];
      header.msg_iov = &pieces[i], header.msg_iovlen = 1;
      header.msg_control = controls[i].bytes.data(), header.msg_controllen = sizeof controls[i];
    }
  }
};

class UdpInputPort final : public LinkPort {
 public:
  UdpInputPort(IoLoop& loop, const LinkAddress& where, const LinkLimits& held_to, LinkCalls calls)
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
                          account.opened(socket_.local_endpoint(error).port());
                          tell_buffer();
                          wait();
                        });
  }
  void wake() override { drop_queue(); }
  void close() override {
    if (socket_.is_open()) read(kBatchesAtTheEnd);
    closed_ = true;
    resolver_.cancel();
    retry_.cancel();
    error_code ignored;
    socket_.close(ignored);
  }

 private:
  std::shared_ptr<UdpInputPort> shared() {
    return std::static_pointer_cast<UdpInputPort>(shared_from_this());
  }

  error_code open(const udp::endpoint& at) {
    error_code error;
    const bool group = at.address().is_multicast();
    socket_.open(at.protocol(), error);
    if (!error) socket_.non_blocking(true, error);
    // Several programs may listen to a group; a port of one's own belongs to one, or each gets a part.
    if (!error && group) socket_.set_option(asio::socket_base::reuse_address(true), error);
    if (!error) socket_.bind(at, error);
    if (!error && group) error = join(at.address());
    if (!error) ask_kernel();
    return error;
  }

  error_code join(const asio::ip::address& group) {
    error_code error;
    error_code is_name;
    const auto own = asio::ip::make_address_v4(address.iface, is_name);
    const unsigned index = ::if_nametoindex(address.iface.c_str());
    if (!address.iface.empty() && is_name && index == 0) return {ENODEV, boost::system::system_category()};
    if (group.is_v6()) {
      socket_.set_option(asio::ip::multicast::join_group(group.to_v6(), index), error);
      return error;
    }
    ip_mreqn request{};
    request.imr_multiaddr.s_addr = htonl(group.to_v4().to_uint());
    if (!is_name && !address.iface.empty()) request.imr_address.s_addr = htonl(own.to_uint());
    request.imr_ifindex = static_cast<int>(index);
    if (::setsockopt(socket_.native_handle(), IPPROTO_IP, IP_ADD_MEMBERSHIP, &request, sizeof request) != 0)
      return last_system_error();
    return {};
  }

  /// What a kernel does not know is done without.
  void ask_kernel() {
    const int on = 1, file = socket_.native_handle();
    if (::setsockopt(file, SOL_SOCKET, SO_RCVBUFFORCE, &kWantedBuffer, sizeof kWantedBuffer) != 0)
      (void)::setsockopt(file, SOL_SOCKET, SO_RCVBUF, &kWantedBuffer, sizeof kWantedBuffer);
    (void)::setsockopt(file, SOL_SOCKET, SO_TIMESTAMPNS, &on, sizeof on);
    (void)::setsockopt(file, SOL_SOCKET, SO_RXQ_OVFL, &on, sizeof on);
  }

  /// The kernel cuts the request without a word: it is read back. It counts its own books as half of it.
  void tell_buffer() {
    int granted = 0;
    socklen_t size = sizeof granted;
    if (::getsockopt(socket_.native_handle(), SOL_SOCKET, SO_RCVBUF, &granted, &size) != 0) return;
    granted /= 2;
    account.receive_buffer(static_cast<std::size_t>(granted));
    if (granted >= kWantedBuffer) return;
    account.trouble({"the system grants a receive buffer of " + std::to_string(granted >> 10) +
                         " KiB instead of 8 MiB, so that datagrams may be lost in a flood",
                     address.text(), "sudo sysctl -w net.core.rmem_max=8388608"});
  }

  void wait() {
    socket_.async_wait(udp::socket::wait_read, [self = shared(), this](const error_code& error) {
      if (closed_ || error == asio::error::operation_aborted) return;
      if (error) return fail(error);
      read(kBatchesATurn);
      wait();
    });
  }

  void read(int most_batches) {
    thread_local const auto batch = std::make_unique<Batch>();
    for (int turn = 0; turn < most_batches; ++turn) {
      batch->prepare();
      const int count =
          ::recvmmsg(socket_.native_handle(), batch->messages.data(), kBatch, MSG_DONTWAIT, nullptr);
      if (count <= 0) return;  // EAGAIN; or an ICMP answer to somebody else's datagram, which is read away
      for (int i = 0; i < count; ++i) hand_on(*batch, static_cast<std::size_t>(i));
      if (count < static_cast<int>(kBatch)) return;
    }
  }

  void hand_on(Batch& batch, std::size_t i) {
    msghdr& header = batch.messages[i].msg_hdr;
    Hearing hearing{.bytes = {batch.bytes.data() + i * kDatagram, batch.messages[i].msg_len},
                    .sender = name_of(batch.senders[i])};
    for (cmsghdr* c = CMSG_FIRSTHDR(&header); c != nullptr; c = CMSG_NXTHDR(&header, c)) {
      if (c->cmsg_level != SOL_SOCKET) continue;
      if (c->cmsg_type == SCM_TIMESTAMPNS) {
        timespec t{};
        std::memcpy(&t, CMSG_DATA(c), sizeof t);
        hearing.kernel_wall_ns = t.tv_sec * std::int64_t{1'000'000'000} + t.tv_nsec;
      } else if (c->cmsg_type == SO_RXQ_OVFL) {
        std::uint32_t drops = 0;
        std::memcpy(&drops, CMSG_DATA(c), sizeof drops);
        if (drops != drops_) account.kernel_dropped(drops_ = drops);
      }
    }
    account.heard(hearing);
  }

  /// Each sender's name is made once; behind a thousand of them somebody invents them.
  std::string_view name_of(const sockaddr_storage& from) {
    udp::endpoint endpoint;
    const std::size_t size = from.ss_family == AF_INET6 ? sizeof(sockaddr_in6) : sizeof(sockaddr_in);
    if (last_name_ != nullptr && std::memcmp(&last_, &from, size) == 0) return *last_name_;
    std::memcpy(endpoint.data(), &from, size);
    const std::string key(reinterpret_cast<const char*>(&from), size);
    auto found = senders_.find(key);
    if (found == senders_.end()) {
      if (senders_.size() >= kMostSenders) return "many senders";
      const std::string name = endpoint.address().to_string() + ":" + std::to_string(endpoint.port());
      found = senders_.emplace(key, name).first;
    }
    last_ = from, last_name_ = &found->second;
    return *last_name_;
  }

  void fail(const error_code& error) {
    account.failed(link_error(address, error));
    error_code ignored;
    socket_.close(ignored);
    retry_.schedule([self = shared(), this] { start(); });
  }

  udp::socket socket_;
  udp::resolver resolver_;
  RetryTimer retry_;
  std::unordered_map<std::string, std::string> senders_;
  sockaddr_storage last_{};  ///< most datagrams come from whom the last one came
  const std::string* last_name_ = nullptr;
  std::uint32_t drops_ = 0;
  bool closed_ = false;
};

}  // namespace

std::shared_ptr<LinkPort> make_udp_input_port(IoLoop& loop, const LinkAddress& address,
                                              const LinkLimits& limits, LinkCalls calls) {
  return std::make_shared<UdpInputPort>(loop, address, limits, std::move(calls));
}

}  // namespace leadline::links
