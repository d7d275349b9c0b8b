#pragma once

#include <algorithm>

#include "core/messages/message.h"

namespace leadline::nav {

/// Which of several sources of one quantity speaks: the first of the configuration that is alive. A later one
/// is heard only once those before it have been silent for 3 s or three of their own intervals.
class Preferred {
 public:
  /// Is a fact of `source`, true at `now`, to be used? Times that go back are refused for a new speaker only.
  bool takes(SourceId source, Time now) {
    if (source == speaker_) {
      const double interval_s = seconds(now - last_);
      if (interval_s > 0.0) hold_s_ = std::clamp(3.0 * interval_s, kHoldS, kLongestHoldS);
      last_ = std::max(last_, now);
      return true;
    }
    if (speaker_ != kNoSource && source > speaker_ && seconds(now - last_) <= hold_s_) return false;
    speaker_ = source;
    last_ = now;
    hold_s_ = kHoldS;
    return true;
  }
  [[nodiscard]] SourceId speaker() const { return speaker_; }

 private:
  static constexpr double kHoldS = 3.0, kLongestHoldS = 60.0;
  SourceId speaker_ = kNoSource;
  Time last_;
  double hold_s_ = kHoldS;
};

}  // namespace leadline::nav
