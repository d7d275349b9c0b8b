#pragma once

#include <chrono>
#include <cstddef>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "app/lateness.h"
#include "core/links/link_sender.h"
#include "core/sim/scenario.h"

namespace leadline::app {

/// The telegrams of a scenario on their sensors' links, each when its arrival stamp is due; sensors with the
/// same link share it. Says which sensors are not sent, and when a link fails or is back.
class LiveSending {
 public:
  /// Opens the links and waits 2 s at most for them; one that is not open by then goes on trying.
  [[nodiscard]] static Result<std::unique_ptr<LiveSending>> open(const sim::Scenario& scenario);

  /// The scenario's start is now.
  void begin();
  /// Waits until the telegram is due and hands it to its link; false when interrupted before.
  bool send(std::size_t sensor, Arrival arrival, std::string_view bytes);
  /// Waits for what is under way, 2 s at most; says what each link sent and how late it was.
  void finish();

 private:
  using Steady = std::chrono::steady_clock;
  struct Line {
    std::unique_ptr<links::LinkSender> sender;
    std::string sensors;
    bool open = false;
  };

  LiveSending(const sim::Scenario& scenario, std::unique_ptr<links::IoLoop> loop);
  bool wait_until(Steady::time_point due);
  void tell_changes();

  Time start_;
  Steady::time_point began_, next_look_;
  Lateness lateness_;  // the I/O thread's until finish(); it outlives the senders
  std::unique_ptr<links::IoLoop> loop_;
  std::vector<Line> lines_;
  std::vector<links::LinkSender*> by_sensor_;  // null: not sent
};

}  // namespace leadline::app
