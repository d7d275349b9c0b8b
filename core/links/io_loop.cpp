#include "core/links/io_loop.h"

#include <pthread.h>

#include <boost/asio/executor_work_guard.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/post.hpp>
#include <csignal>
#include <exception>
#include <future>

#include "core/types/expect.h"

namespace leadline::links {

struct IoLoop::Inside {
  boost::asio::io_context context{1};
  boost::asio::executor_work_guard<boost::asio::io_context::executor_type> work{context.get_executor()};
};

Result<std::unique_ptr<IoLoop>> IoLoop::start() {
  try {
    auto loop = std::unique_ptr<IoLoop>(new IoLoop(std::make_unique<Inside>()));
    // A thread starts with the mask of its maker: SIGINT belongs to the main thread, a broken pipe is an
    // error code.
    sigset_t all, before;
    sigfillset(&all);
    pthread_sigmask(SIG_SETMASK, &all, &before);
    try {
      loop->thread_ = std::thread([inside = loop->inside_.get()] { inside->context.run(); });
    } catch (const std::exception&) {
      pthread_sigmask(SIG_SETMASK, &before, nullptr);
      throw;
    }
    pthread_sigmask(SIG_SETMASK, &before, nullptr);
    return loop;
  } catch (const std::exception& e) {
    return Error{std::string("the I/O thread cannot be started (") + e.what() + ")", "links",
                 "does this user have handles and threads left? see ulimit -n and ulimit -u"};
  }
}

IoLoop::IoLoop(std::unique_ptr<Inside> inside) : inside_(std::move(inside)) {}

IoLoop::~IoLoop() {
  inside_->context.stop();
  if (thread_.joinable()) thread_.join();
}

boost::asio::io_context& IoLoop::context() { return inside_->context; }

void IoLoop::post(std::function<void()> work) { boost::asio::post(inside_->context, std::move(work)); }

void IoLoop::run_there(const std::function<void()>& work) {
  LL_EXPECT(std::this_thread::get_id() != thread_.get_id());
  std::promise<void> done;
  post([&] {
    work();
    done.set_value();
  });
  done.get_future().wait();
}

}  // namespace leadline::links
