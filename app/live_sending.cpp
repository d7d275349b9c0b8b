#include "app/live_sending.h"

#include <fmt/format.h>
#include <sys/prctl.h>

#include <algorithm>
#include <map>
#include <thread>

#include "app/interrupt.h"
#include "app/talk.h"

namespace leadline::app {
namespace {

constexpr std::chrono::milliseconds kPatience(2000);

}  // namespace

Result<std::unique_ptr<LiveSending>> LiveSending::open(const sim::Scenario& scenario) {
  auto loop = links::IoLoop::start();
  if (!loop) return loop.error();
  auto sending = std::unique_ptr<LiveSending>(new LiveSending(scenario, std::move(loop).value()));
  const auto closed = [](const Line& line) { return !line.sender->status().open; };
  const auto end = Steady::now() + kPatience;
  while (std::any_of(sending->lines_.begin(), sending->lines_.end(), closed) && !interrupted() &&
         Steady::now() < end)
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  for (auto& line : sending->lines_) {
    line.open = !closed(line);
    if (line.open) continue;
    const std::string why = line.sender->status().last_error;
    warning(fmt::format("{} cannot be sent yet: {}; it is tried again", line.sensors,
                        why.empty() ? line.sender->address().text() + ": no answer" : why));
  }
  return sending;
}

LiveSending::LiveSending(const sim::Scenario& scenario, std::unique_ptr<links::IoLoop> loop)
    : start_(scenario.start()), loop_(std::move(loop)) {
  std::map<std::string, std::size_t> by_link;
  for (const auto& sensor : scenario.sensors) {
    const auto& [name, link] = std::pair(sensor.options.name, sensor.options.link);
    if (link.empty()) {
      note(name + " has no link: it is not sent");
      by_sensor_.push_back(nullptr);
      continue;
    }
    const auto address = links::parse_link(link);
    LL_EXPECT(address.ok());  // checked when the scenario was read
    const auto [found, is_new] = by_link.emplace(address.value().text(), lines_.size());
    if (is_new)
      lines_.push_back({std::make_unique<links::LinkSender>(
          *loop_, address.value(), links::LinkLimits{}, [this](std::int64_t due_ns) {
            lateness_.add(Steady::now().time_since_epoch() - std::chrono::nanoseconds(due_ns));
          })});
    Line& line = lines_[found->second];
    line.sensors += (line.sensors.empty() ? "" : ", ") + name;
    by_sensor_.push_back(line.sender.get());
  }
}

void LiveSending::begin() {
  // The kernel may let a sleeper sleep 50 us longer to save wake-ups; that would be most of our jitter.
  (void)::prctl(PR_SET_TIMERSLACK, 1UL, 0UL, 0UL, 0UL);
  began_ = next_look_ = Steady::now();
}

bool LiveSending::wait_until(Steady::time_point due) {
  for (;;) {
    if (interrupted()) return false;
    const auto now = Steady::now();
    if (now >= next_look_) tell_changes(), next_look_ = now + std::chrono::seconds(1);
    if (now >= due) return true;
    std::this_thread::sleep_until(std::min(due, now + std::chrono::milliseconds(100)));
  }
}

bool LiveSending::send(std::size_t sensor, Arrival arrival, std::string_view bytes) {
  const auto due = began_ + (arrival.host() - start_);
  if (!wait_until(due)) return false;
  if (auto* const sender = by_sensor_[sensor])
    (void)sender->send({reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()},
                       due.time_since_epoch().count());  // a frame dropped is counted by its link
  return true;
}

void LiveSending::tell_changes() {
  for (auto& line : lines_) {
    const auto status = line.sender->status();
    if (std::exchange(line.open, status.open) == status.open) continue;
    if (status.open)
      note(fmt::format("{} is sent again over {}", line.sensors, line.sender->address().text()));
    else
      warning(fmt::format("{} is not sent for now: {}", line.sensors, status.last_error));
  }
}

void LiveSending::finish() {
  for (auto& line : lines_) {
    const bool all = line.sender->finish(kPatience);
    const auto status = line.sender->status();
    note(fmt::format("{}: {} frames, {} bytes sent to {}", line.sensors, status.sent_frames,
                     status.sent_bytes, line.sender->address().text()));
    if (status.dropped_frames > 0 || !all)
      warning(fmt::format("{}: {} frames dropped{}{}", line.sensors, status.dropped_frames,
                          all ? "" : ", the last did not go out in time",
                          status.last_error.empty() ? "" : "; " + status.last_error));
  }
  for (auto& line : lines_) line.sender.reset();  // the I/O thread is done with the figures
  if (lateness_.count() > 0)
    note(fmt::format(
        "sent after the arrival stamps by p50 {:.3f} ms, p99 {:.3f} ms, max {:.3f} ms over {} frames",
        lateness_.quantile_ms(0.5), lateness_.quantile_ms(0.99), lateness_.max_ms(), lateness_.count()));
}

}  // namespace leadline::app
