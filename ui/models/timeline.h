#pragma once

#include <cstddef>
#include <vector>

#include "ui/bridge/snapshot.h"
#include "ui/models/timeline_data.h"

namespace leadline::ui {

/// A History as a timeline. Only what is new is looked at, so that it may be asked at display rate while a
/// day is being read; the sigma curve keeps the greatest of each stretch of time, at most 4096 stretches.
class TimelineModel {
 public:
  /// engine: whose sigma. Another History than before, or one that shrank, is begun anew.
  void update(const History& history, EngineId engine);
  [[nodiscard]] const TimelineData& data() const { return data_; }
  /// The sigma curve for a view `columns` pixels wide: the greatest value of each column, in order.
  [[nodiscard]] std::vector<TimelineData::Sigma> sigma(TimeSpan view, int columns) const;

 private:
  void take_modes(const History& history);
  void take_events(const History& history);
  void take_points(const Track& track);

  TimelineData data_;
  std::size_t modes_ = 0, events_ = 0, points_ = 0;
  std::int64_t bin_ns_ = 1'000'000'000;
};

/// Two or three words of a sentence, for the timeline.
[[nodiscard]] std::string short_words(const std::string& text);

}  // namespace leadline::ui
