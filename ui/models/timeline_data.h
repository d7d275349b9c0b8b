#pragma once

// What the timeline of a run shows. Plain values; it grows while a file is being read.

#include <string>
#include <vector>

#include "core/messages/bookkeeping.h"
#include "core/messages/navigation.h"
#include "core/types/time.h"

namespace leadline::ui {

/// From `from` to before `until`.
struct TimeSpan {
  Time from, until;
  [[nodiscard]] constexpr bool contains(Time t) const { return from <= t && t < until; }
  bool operator==(const TimeSpan&) const = default;
};

struct TimelineData {
  struct Availability {
    TimeSpan span;
    Mode mode = Mode::E0;
    bool operator==(const Availability&) const = default;
  };
  struct Alert {
    Time at;
    Alarm::Priority priority = Alarm::Priority::warning;
    std::string text;
    bool operator==(const Alert&) const = default;
  };
  struct Event {
    Time at;
    std::string text;  ///< two or three words: "bottom lock"
    bool operator==(const Event&) const = default;
  };
  struct Gap {
    TimeSpan span;
    std::string text;
    bool operator==(const Gap&) const = default;
  };
  struct Sigma {
    Time at;
    double drms_m = 0.0;
    bool operator==(const Sigma&) const = default;
  };

  TimeSpan run;  ///< all there is
  // Each list in the order of time.
  std::vector<Availability> availability;
  std::vector<Alert> alerts;
  std::vector<Event> events;
  std::vector<Gap> gaps;
  std::vector<Sigma> sigma;
  bool complete = true;  ///< false: still being read
  bool operator==(const TimelineData&) const = default;
};

}  // namespace leadline::ui
