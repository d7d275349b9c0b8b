#pragma once

#include <functional>
#include <memory>
#include <thread>

#include "core/types/result.h"

namespace boost::asio {
class io_context;
}

namespace leadline::links {

/// The one I/O thread: whatever touches a port or a socket runs on it as callbacks, one at a time, so that no
/// link needs a lock. Signals are left to the other threads. It must outlive the links that use it.
class IoLoop {
 public:
  /// Fails when the system has no thread or handle left.
  [[nodiscard]] static Result<std::unique_ptr<IoLoop>> start();
  /// Callbacks that did not run yet are dropped.
  ~IoLoop();
  IoLoop(const IoLoop&) = delete;
  IoLoop& operator=(const IoLoop&) = delete;

  /// For links only; Boost.Asio does not leave this folder.
  [[nodiscard]] boost::asio::io_context& context();
  /// Runs work on the I/O thread soon. From any thread, never blocks.
  void post(std::function<void()> work);
  /// Runs work on the I/O thread and returns when it is done. Not from that thread.
  void run_there(const std::function<void()>& work);

 private:
  struct Inside;
  explicit IoLoop(std::unique_ptr<Inside> inside);

  std::unique_ptr<Inside> inside_;
  std::thread thread_;
};

}  // namespace leadline::links
