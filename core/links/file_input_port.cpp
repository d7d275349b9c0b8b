#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <boost/asio/post.hpp>
#include <cerrno>

#include "core/links/link_error.h"
#include "core/links/link_port.h"
#include "core/links/retry_timer.h"

namespace leadline::links {
namespace {

using namespace std::chrono_literals;
constexpr auto kLook = 50ms;

boost::system::error_code last_system_error() { return {errno, boost::system::system_category()}; }

/// Reads a file from its beginning and, with follow=1, what is appended to it. A file that was cut short or
/// replaced is read anew.
class FileInputPort final : public LinkPort {
 public:
  FileInputPort(IoLoop& loop, const LinkAddress& where, const LinkLimits& held_to, LinkCalls calls)
      : LinkPort(where, held_to, std::move(calls)), retry_(loop.context(), held_to) {}
  ~FileInputPort() override { close_file(); }

  void start() override {
    if (closed_) return;
    // Without O_NONBLOCK a pipe that nobody writes would hold up every link.
    file_ = ::open(address.path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
    if (file_ < 0) return fail(last_system_error());
    at_ = 0;
    retry_.opened();
    account.opened();
    read();
  }
  void wake() override { drop_queue(); }
  void close() override {
    closed_ = true;
    retry_.cancel();
    close_file();
  }

 private:
  void read() {
    if (closed_ || file_ < 0) return;
    const auto n = ::read(file_, piece_.data(), piece_.size());
    if (n < 0 && errno != EINTR && errno != EAGAIN) return fail(last_system_error());
    if (n > 0) {
      at_ += n;
      account.heard({.bytes = std::span(piece_).first(static_cast<std::size_t>(n))});
      return again(0ms);  // the other links have their turn between two pieces
    }
    if (!address.follow) return account.trouble({"the file is at its end", address.text(), ""});
    struct stat now {
    }, open{};
    const bool replaced = ::stat(address.path.c_str(), &now) == 0 && ::fstat(file_, &open) == 0 &&
                          (now.st_ino != open.st_ino || now.st_size < at_);
    if (!replaced) return again(kLook);
    close_file();
    start();
  }

  void again(std::chrono::milliseconds wait) {
    retry_.limit(wait, [self = shared_from_this(), this] { read(); });
  }

  void fail(const boost::system::error_code& error) {
    account.failed(link_error(address, error));
    close_file();
    retry_.schedule([self = shared_from_this(), this] { start(); });
  }

  void close_file() {
    if (file_ >= 0) ::close(file_);
    file_ = -1;
  }

  RetryTimer retry_;
  std::array<std::uint8_t, 65536> piece_{};
  std::int64_t at_ = 0;
  int file_ = -1;
  bool closed_ = false;
};

}  // namespace

std::shared_ptr<LinkPort> make_file_input_port(IoLoop& loop, const LinkAddress& address,
                                               const LinkLimits& limits, LinkCalls calls) {
  return std::make_shared<FileInputPort>(loop, address, limits, std::move(calls));
}

}  // namespace leadline::links
