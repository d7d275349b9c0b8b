#pragma once

#include <boost/asio/buffer.hpp>
#include <boost/asio/write.hpp>
#include <functional>
#include <memory>

#include "core/links/link_port.h"

namespace leadline::links {

/// Writes what a queue holds to a stream, one batch at a time and in order.
template <class Stream>
class StreamPump {
 public:
  using Failed = std::function<void(const boost::system::error_code&)>;

  StreamPump(Stream& stream, SendQueue& queue, LinkAccount& account, Failed failed)
      : stream_(stream), queue_(queue), account_(account), failed_(std::move(failed)) {}

  /// owner: whoever holds the pump, kept until the callback has run.
  void wake(std::shared_ptr<void> owner) {
    if (writing_ || !queue_.take(batch_)) return;
    writing_ = true;
    boost::asio::async_write(
        stream_, boost::asio::buffer(batch_.bytes),
        [this, owner = std::move(owner)](const boost::system::error_code& error, std::size_t bytes) mutable {
          writing_ = false;
          account_.settle(batch_, bytes);
          if (!error) return wake(std::move(owner));
          if (error != boost::asio::error::operation_aborted) failed_(error);
        });
  }

 private:
  Stream& stream_;
  SendQueue& queue_;
  LinkAccount& account_;
  Failed failed_;
  FrameBatch batch_;
  bool writing_ = false;
};

}  // namespace leadline::links
