#include "core/links/link_sender.h"

#include <thread>

#include "core/links/link_port.h"

namespace leadline::links {

LinkSender::LinkSender(IoLoop& loop, const LinkAddress& address, const LinkLimits& limits, Sent sent)
    : loop_(loop), port_(make_port(loop, address, limits, {.sent = std::move(sent)})) {
  loop_.post([port = port_] { port->start(); });
}

LinkSender::~LinkSender() {
  loop_.run_there([this] {
    port_->close();
    port_->account.stop_telling();
  });
}

bool LinkSender::send(std::span<const std::uint8_t> frame, std::int64_t tag) {
  port_->account.queued(1);
  const auto pushed = port_->queue.push(frame, tag);
  if (pushed == SendQueue::Pushed::refused) {
    port_->account.dropped(1);
    return false;
  }
  if (pushed == SendQueue::Pushed::first) loop_.post([port = port_] { port->wake(); });
  return true;
}

LinkStatus LinkSender::status() const { return port_->account.status(); }

bool LinkSender::finish(std::chrono::milliseconds at_most) {
  const auto end = std::chrono::steady_clock::now() + at_most;
  while (!port_->account.idle()) {
    if (std::chrono::steady_clock::now() > end) return false;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  return true;
}

const LinkAddress& LinkSender::address() const { return port_->address; }

}  // namespace leadline::links
