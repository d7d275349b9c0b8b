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
    if (!sent_) under_way_ -= batch.frames.size();
  }
  if (!sent_) return;
  for (std::size_t i = 0; i < taken; ++i) sent_(batch.frames[i].tag);
  // Idle only after the last was told: whoever waits for that reads complete figures.
  const std::lock_guard lock(mutex_);
  under_way_ -= batch.frames.size();
}

void LinkAccount::sent(std::size_t bytes, std::int64_t tag) {
  if (sent_) sent_(tag);
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

}  // namespace leadline::links
