#pragma once

#include <array>
#include <boost/asio/io_context.hpp>
#include <utility>

#include "core/links/link_error.h"
#include "core/links/link_port.h"
#include "core/links/retry_timer.h"
#include "core/links/stream_pump.h"

namespace leadline::links {

/// A link that is one stream at a time, opened again whenever it fails. Who derives from it opens it.
template <class Stream>
class StreamPort : public LinkPort {
 public:
  StreamPort(IoLoop& loop, const LinkAddress& where, const LinkLimits& held_to, LinkSender::Sent sent)
      : LinkPort(where, held_to, std::move(sent)),
        stream_(loop.context()),
        retry_(loop.context(), held_to),
        pump_(stream_, queue, account, [this](const auto& error) { fail(error); }) {}

  void start() override {
    if (!closed_) open();
  }
  void wake() override {
    if (!open_) return drop_queue();
    pump_.wake(shared_from_this());
  }
  void close() override {
    closed_ = true, open_ = false;
    retry_.cancel();
    boost::system::error_code ignored;
    stream_.close(ignored);
    drop_queue();
  }

 protected:
  /// Tries once, and ends in opened() or fail().
  virtual void open() = 0;

  void opened() {
    open_ = true;
    retry_.cancel();
    retry_.opened();
    account.opened();
    watch();
    wake();
  }

  void fail(const boost::system::error_code& error) {
    if (closed_) return;
    open_ = false;
    account.failed(link_error(address, error));
    boost::system::error_code ignored;
    stream_.close(ignored);
    drop_queue();
    retry_.schedule([self = shared_from_this(), this] { start(); });
  }

  [[nodiscard]] bool closed() const { return closed_; }

  Stream stream_;
  RetryTimer retry_;

 private:
  /// A stream that ends says so to a reader only; what the other side says is of no interest here.
  void watch() {
    stream_.async_read_some(
        boost::asio::buffer(unread_),
        [self = shared_from_this(), this](const boost::system::error_code& error, std::size_t) {
          if (error == boost::asio::error::operation_aborted || !open_) return;
          if (error) return fail(error);
          watch();
        });
  }

  StreamPump<Stream> pump_;
  std::array<char, 4096> unread_{};
  bool open_ = false, closed_ = false;
};

}  // namespace leadline::links
