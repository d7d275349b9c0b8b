#include "ui/bridge/bridge.h"

namespace leadline::ui {
namespace {

constexpr std::size_t kMostPoints = 4096;  // of a track that the screen has not looked at

}  // namespace

Bridge::Bridge(const ConsoleSetup& setup, QObject* parent)
    : QObject(parent), builder_(setup), history_builder_(setup, kMostPoints) {
  timer_.setInterval(kDisplayMs);
  connect(&timer_, &QTimer::timeout, this, &Bridge::look);
  snapshot_ = builder_.snapshot();
}

void Bridge::take(const Envelope& envelope) {
  const std::lock_guard lock(mutex_);
  builder_.take(envelope);
  history_builder_.take(envelope);
  fresh_ = true;
}

void Bridge::look() {
  History more;
  {
    const std::lock_guard lock(mutex_);
    if (!fresh_) return;
    fresh_ = false;
    snapshot_ = builder_.snapshot();
    more = history_builder_.take_new();
  }
  append(history_, std::move(more));
  emit looked();
}

}  // namespace leadline::ui
