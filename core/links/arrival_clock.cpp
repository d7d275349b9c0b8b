#include "core/links/arrival_clock.h"

#include <ctime>

namespace leadline::links {
namespace {

constexpr std::int64_t kOldestStampNs = 1'000'000'000;

template <clockid_t kClock>
std::int64_t read_ns() {
  timespec t{};
  (void)::clock_gettime(kClock, &t);
  return t.tv_sec * std::int64_t{1'000'000'000} + t.tv_nsec;
}

}  // namespace

SystemClocks system_clocks() { return {&read_ns<CLOCK_BOOTTIME>, &read_ns<CLOCK_REALTIME>}; }

ArrivalClock::ArrivalClock(SystemClocks clocks)
    : clocks_(clocks), start_wall_ns_(clocks.wall_ns()), start_elapsed_ns_(clocks.elapsed_ns()) {}

Arrival ArrivalClock::now() const {
  return arrival_at({start_wall_ns_ + (clocks_.elapsed_ns() - start_elapsed_ns_)});
}

Arrival ArrivalClock::heard_at(std::int64_t kernel_wall_ns) const {
  const std::int64_t age_ns = clocks_.wall_ns() - kernel_wall_ns;
  const Arrival at = now();
  if (age_ns < 0 || age_ns > kOldestStampNs) return at;
  return arrival_at({at.ns - age_ns});
}

Duration ArrivalClock::wall_step() const {
  return Duration((clocks_.wall_ns() - start_wall_ns_) - (clocks_.elapsed_ns() - start_elapsed_ns_));
}

}  // namespace leadline::links
