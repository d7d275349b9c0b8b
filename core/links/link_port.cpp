#include "core/links/link_port.h"

namespace leadline::links {

void LinkAccount::queued(std::size_t frames) {
  const std::lock_guard lock(mutex_);
  under_way_ += frames;
}

void LinkAccount::settle(const FrameBatch& batch, std::size_t bytes) {
  std::size_t taken = 0;
  while (taken < batch.frames.size() && batch.frames[taken].end <= bytes) ++taken;
  {
    const std::lock_guard lock(mutex_);
    status_.sent_frames += taken;
    status_.sent_bytes += taken == 0 ? 0 : batch.frames[taken - 1].end;
    status_.dropped_frames += batch.frames.size() - taken;
    if (!calls_.sent) under_way_ -= batch.frames.size();
  }
  if (!calls_.sent) return;
  for (std::size_t i = 0; i < taken; ++i) calls_.sent(batch.frames[i].tag);
  // Idle only after the last was told: whoever waits for that reads complete figures.
  const std::lock_guard lock(mutex_);
  under_way_ -= batch.frames.size();
}

void LinkAccount::sent(std::size_t bytes, std::int64_t tag) {
  if (calls_.sent) calls_.sent(tag);
  const std::lock_guard lock(mutex_);
  ++status_.sent_frames;
  status_.sent_bytes += bytes;
  --under_way_;
}

void LinkAccount::dropped(std::size_t frames) {
  const std::lock_guard lock(mutex_);
  status_.dropped_frames += frames;
  under_way_ -= frames;
}

void LinkAccount::handed_on(std::size_t frames) {
  const std::lock_guard lock(mutex_);
  under_way_ -= frames;
}

void LinkAccount::heard(const Hearing& hearing) {
  if (calls_.heard) calls_.heard(hearing);
  const std::lock_guard lock(mutex_);
  ++status_.heard_frames;
  status_.heard_bytes += hearing.bytes.size();
}

void LinkAccount::kernel_dropped(std::uint64_t all_so_far) {
  const std::lock_guard lock(mutex_);
  status_.kernel_drops = all_so_far;
}

void LinkAccount::receive_buffer(std::size_t bytes) {
  const std::lock_guard lock(mutex_);
  status_.receive_buffer = bytes;
}

void LinkAccount::opened(std::uint16_t port) {
  const std::lock_guard lock(mutex_);
  status_.open = true;
  status_.port = port;
  ++status_.times_opened;
}

void LinkAccount::failed(const Error& error) {
  const std::lock_guard lock(mutex_);
  status_.open = false;
  status_.last_error = error.line();
}

void LinkAccount::trouble(const Error& error) {
  const std::lock_guard lock(mutex_);
  status_.last_error = error.line();
}

void LinkAccount::client_came() {
  const std::lock_guard lock(mutex_);
  ++status_.clients;
}

void LinkAccount::client_left(bool too_slow) {
  const std::lock_guard lock(mutex_);
  --status_.clients;
  if (too_slow) ++status_.dropped_clients;
}

LinkStatus LinkAccount::status() const {
  const std::lock_guard lock(mutex_);
  return status_;
}

bool LinkAccount::idle() const {
  const std::lock_guard lock(mutex_);
  return under_way_ == 0;
}

void LinkPort::drop_queue() {
  if (queue.take(batch_)) account.dropped(batch_.frames.size());
}

std::shared_ptr<LinkPort> make_port(IoLoop& loop, const LinkAddress& address, const LinkLimits& limits,
                                    LinkCalls calls) {
  const bool hears = calls.heard != nullptr;
  switch (address.kind) {
    case LinkKind::serial:
      return make_serial_port(loop, address, limits, std::move(calls));
    case LinkKind::udp:
      return hears ? make_udp_input_port(loop, address, limits, std::move(calls))
                   : make_udp_port(loop, address, limits, std::move(calls));
    case LinkKind::tcp:
      return make_tcp_client_port(loop, address, limits, std::move(calls));
    case LinkKind::tcp_listen:
      return make_tcp_listen_port(loop, address, limits, std::move(calls));
    case LinkKind::file:
      break;
  }
  return hears ? make_file_input_port(loop, address, limits, std::move(calls))
               : make_file_port(loop, address, limits, std::move(calls));
}

}  // namespace leadline::links
