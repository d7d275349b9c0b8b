#pragma once

#include <arpa/inet.h>
#include <fcntl.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <termios.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <cstdlib>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace leadline::test {

/// The other end of a link under test, by plain system calls.
class Peer {
 public:
  explicit Peer(int file) : file_(file) { EXPECT_GE(file, 0); }
  Peer(Peer&& other) noexcept : file_(std::exchange(other.file_, -1)) {}
  Peer& operator=(Peer&& other) noexcept {
    std::swap(file_, other.file_);
    return *this;
  }
  ~Peer() { close(); }

  void close() {
    if (file_ >= 0) ::close(std::exchange(file_, -1));
  }
  /// Forgets the handle without closing it.
  void let_go() { file_ = -1; }
  [[nodiscard]] int file() const { return file_; }

  /// What one read gives; empty at the end or when nothing came for 20 s.
  [[nodiscard]] std::string read_some() const {
    pollfd waiting{file_, POLLIN, 0};
    if (::poll(&waiting, 1, 20'000) <= 0) return {};
    std::array<char, 65536> buffer;
    const auto n = ::read(file_, buffer.data(), buffer.size());
    return n > 0 ? std::string(buffer.data(), static_cast<std::size_t>(n)) : std::string();
  }
  [[nodiscard]] std::string read(std::size_t bytes) const {
    std::string all;
    while (all.size() < bytes) {
      const auto some = read_some();
      if (some.empty()) break;
      all += some;
    }
    return all;
  }

 private:
  int file_;
};

inline sockaddr_in loopback(std::uint16_t port) {
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(port);
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  return address;
}

/// A socket on a loopback port that the system chose.
inline Peer bound(int type) {
  Peer peer(::socket(AF_INET, type | SOCK_CLOEXEC, 0));
  const int room = 4 << 20;
  ::setsockopt(peer.file(), SOL_SOCKET, SO_RCVBUF, &room, sizeof room);
  const auto address = loopback(0);
  EXPECT_EQ(::bind(peer.file(), reinterpret_cast<const sockaddr*>(&address), sizeof address), 0);
  return peer;
}
inline Peer udp_peer() { return bound(SOCK_DGRAM); }
inline Peer tcp_server() {
  Peer peer = bound(SOCK_STREAM);
  EXPECT_EQ(::listen(peer.file(), 16), 0);
  return peer;
}
inline std::uint16_t port_of(const Peer& peer) {
  sockaddr_in address{};
  socklen_t size = sizeof address;
  EXPECT_EQ(::getsockname(peer.file(), reinterpret_cast<sockaddr*>(&address), &size), 0);
  return ntohs(address.sin_port);
}
inline Peer accepted(const Peer& server) {
  pollfd waiting{server.file(), POLLIN, 0};
  EXPECT_EQ(::poll(&waiting, 1, 20'000), 1) << "nobody connected";
  return Peer(::accept(server.file(), nullptr, nullptr));
}
inline Peer connected(std::uint16_t port) {
  Peer peer(::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0));
  const auto address = loopback(port);
  EXPECT_EQ(::connect(peer.file(), reinterpret_cast<const sockaddr*>(&address), sizeof address), 0);
  return peer;
}

/// A pseudo-terminal; its other end is the device at path().
inline Peer pseudo_terminal() {
  Peer peer(::posix_openpt(O_RDWR | O_NOCTTY | O_CLOEXEC));
  EXPECT_EQ(::grantpt(peer.file()), 0);
  EXPECT_EQ(::unlockpt(peer.file()), 0);
  return peer;
}
inline std::string path_of(const Peer& terminal) {
  std::array<char, 128> path{};
  EXPECT_EQ(::ptsname_r(terminal.file(), path.data(), path.size()), 0);
  return path.data();
}

/// Waits for what must come about; a generous end, so that only a standstill fails.
template <class Condition>
bool comes_about(Condition condition) {
  const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(20);
  while (!condition()) {
    if (std::chrono::steady_clock::now() > end) return false;
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  return true;
}

}  // namespace leadline::test
