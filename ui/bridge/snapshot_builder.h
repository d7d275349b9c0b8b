#pragma once

#include <array>
#include <deque>
#include <optional>
#include <utility>
#include <vector>

#include "ui/bridge/source_book.h"

namespace leadline::ui {

/// The newest state out of messages in bus order. A value that may be copied; no allocation a message, no
/// clock. What it remembers of a source is bounded: twelve intervals, eight fixes, one value a quantity.
class SnapshotBuilder {
 public:
  explicit SnapshotBuilder(ConsoleSetup setup);

  void take(const Envelope& envelope);
  /// How many frames and refusals of a source there were so far, seen by this builder or not.
  void set_counts(SourceId source, std::uint64_t frames, std::uint64_t refused);

  [[nodiscard]] const ConsoleSetup& setup() const { return setup_; }
  /// The newest arrival taken; Ticks let time go on where all are silent.
  [[nodiscard]] Arrival now() const { return now_; }
  /// The state as it is looked at from `now`, which is not before now().
  [[nodiscard]] Snapshot snapshot(Time now) const;
  [[nodiscard]] Snapshot snapshot() const { return snapshot(now_.host()); }

  static constexpr std::size_t kMostAlerts = 50;

 private:
  struct Said {  // by an engine
    Solution solution;
    Time valid;
    Pulse pulse;
    RecentCount recent;
  };
  enum class Figure : std::uint8_t { heading, velocity, depth, attitude, altitude };
  static constexpr std::size_t kFigures = 5, kBodies = 3;
  /// Who feeds a figure; the second one only where two make a position.
  struct Feeding {
    SourceId source = kNoSource, second = kNoSource;
    Quantity quantity = Quantity::other;
    bool operator==(const Feeding&) const = default;
  };
  struct Fed {
    Feeding by, before;
    std::optional<Arrival> changed;
  };
  struct Alert {
    Alarm alarm;
    Time raised;
    SourceId source = kNoSource;
  };

  void solution(const Envelope& envelope, const Solution& solution);
  void verdict(const Envelope& envelope, const FixVerdict& verdict);
  void alarm(const Envelope& envelope, const Alarm& alarm);
  void review(Body body, Arrival now);
  void review_position(Arrival now);
  [[nodiscard]] Feeding choose(Body body, Figure figure, Arrival now) const;
  static void change(Fed& fed, const Feeding& by, Arrival now);
  [[nodiscard]] std::optional<Feed> feed(const Fed& fed, Time now) const;
  [[nodiscard]] std::string name_of(const Feeding& feeding) const;
  [[nodiscard]] std::optional<BodyState> body_state(EngineId engine, Time now) const;
  void fill_feeds(BodyState& state, Body body, Time now) const;

  ConsoleSetup setup_;
  Arrival now_;
  std::vector<SourceBook> books_;
  std::vector<std::optional<Said>> said_;  // by engine; the ship's own track is the last one
  std::array<std::array<Fed, kFigures>, kBodies> fed_;
  Fed position_;
  SourceId accepted_ = kNoSource;  // whose fix the engine shown used last
  AvailabilityState availability_;
  struct Seen {
    FixVerdict verdict;
    Time valid;
  };
  std::vector<std::optional<Seen>>
      seen_;  // the newest fix of each source, as the engine shown was told of it
  SourceId beam_ = kNoSource;
  std::vector<Alert> alerts_;  // oldest first
};

}  // namespace leadline::ui
