#pragma once

#include <unistd.h>

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
  StreamPort(IoLoop& loop, const LinkAddress& where, const LinkLimits& held_to, LinkCalls calls)
      : LinkPort(where, held_to, std::move(calls)),
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
    if (open_ && account.listening()) read_the_rest();
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
  /// What the kernel still holds when the link is closed.
  void read_the_rest() {
    constexpr int kMostReads = 256;
    for (int i = 0; i < kMostReads; ++i) {  // Asio has made the handle one that does not wait
      const auto n = ::read(stream_.native_handle(), read_.data(), read_.size());
      if (n <= 0) return;
      account.heard({.bytes = std::span(read_).first(static_cast<std::size_t>(n))});
    }
  }

  /// A stream that ends says so to a reader only, so it is read even where nobody listens.
  void watch() {
    stream_.async_read_some(
        boost::asio::buffer(read_),
        [self = shared_from_this(), this](const boost::system::error_code& error, std::size_t bytes) {
          if (error == boost::asio::error::operation_aborted || !open_) return;
          if (bytes > 0 && account.listening()) account.heard({.bytes = std::span(read_).first(bytes)});
          if (error) return fail(error);
          watch();
        });
  }

  StreamPump<Stream> pump_;
  std::array<std::uint8_t, 16384> read_{};
  bool open_ = false, closed_ = false;
};

}  // namespace leadline::links
