#include <fcntl.h>
#include <unistd.h>

#include <cerrno>

#include "core/links/link_error.h"
#include "core/links/link_port.h"
#include "core/links/retry_timer.h"

namespace leadline::links {
namespace {

boost::system::error_code last_system_error() { return {errno, boost::system::system_category()}; }

/// Appends to a file. What is written stands in the file at once, for whoever follows it.
class FilePort final : public LinkPort {
 public:
  FilePort(IoLoop& loop, const LinkAddress& where, const LinkLimits& held_to, LinkCalls calls)
      : LinkPort(where, held_to, std::move(calls)), retry_(loop.context(), held_to) {}
  ~FilePort() override { close_file(); }

  void start() override {
    if (closed_) return;
    // Without O_NONBLOCK a pipe that nobody reads would hold up every link.
    file_ = ::open(address.path.c_str(), O_WRONLY | O_APPEND | O_CREAT | O_CLOEXEC | O_NONBLOCK, 0666);
    if (file_ < 0) return fail(last_system_error());
    retry_.opened();
    account.opened();
  }

  void wake() override {
    while (file_ >= 0 && queue.take(batch_)) write();
    if (file_ < 0) drop_queue();
  }

  void close() override {
    closed_ = true;
    retry_.cancel();
    close_file();
    drop_queue();
  }

 private:
  void write() {
    std::size_t done = 0;
    while (done < batch_.bytes.size()) {
      const auto n = ::write(file_, batch_.bytes.data() + done, batch_.bytes.size() - done);
      if (n < 0 && errno == EINTR) continue;
      if (n < 0) {
        const auto error = last_system_error();
        account.settle(batch_, done);
        return fail(error);
      }
      done += static_cast<std::size_t>(n);
    }
    account.settle(batch_, done);
  }

  void fail(const boost::system::error_code& error) {
    account.failed(link_error(address, error));
    close_file();
    drop_queue();
    retry_.schedule([self = shared_from_this(), this] { start(); });
  }

  void close_file() {
    if (file_ >= 0) ::close(file_);
    file_ = -1;
  }

  RetryTimer retry_;
  int file_ = -1;
  bool closed_ = false;
};

}  // namespace

std::shared_ptr<LinkPort> make_file_port(IoLoop& loop, const LinkAddress& address, const LinkLimits& limits,
                                         LinkCalls calls) {
  return std::make_shared<FilePort>(loop, address, limits, std::move(calls));
}

}  // namespace leadline::links
