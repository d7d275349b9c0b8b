#pragma once

#include <optional>
#include <vector>

#include "ui/bridge/console_setup.h"

namespace leadline::ui {

/// Moves what is new to the end of a History; both keep their order.
void append(History& to, History&& more);

/// What messages in bus order add to a History, kept until it is taken. Of fixes that the engine shown does
/// not use, one a second and source.
class HistoryBuilder {
 public:
  /// most_points: of each track that may wait; beyond, every second one is left out, so that a screen that
  /// does not look costs no memory. 0: no bound.
  explicit HistoryBuilder(ConsoleSetup setup, std::size_t most_points = 0);

  /// Any message; of kinds that leave no trace only the arrival is looked at, for gaps.
  void take(const Envelope& envelope);
  /// The recording ended and goes on: what comes next follows a gap until `first`.
  void recording_goes_on(Time first);
  /// What the program or the operator wrote down; in order of time with the messages.
  void take(const EventMark& mark) { event(mark); }
  /// Everything since the last call.
  [[nodiscard]] History take_new();

  /// All sources silent for longer is a gap, if it is five times the usual interval, too.
  static constexpr double kGapS = 10.0;

 private:
  struct Engine {
    std::optional<TrackPoint> last;
    std::size_t stride = 1, skipped = 0;  // one point of `stride` is kept
  };
  void solution(const Envelope& envelope, const Solution& solution);
  void gap(Arrival arrival);
  void event(EventMark mark);
  [[nodiscard]] Engine& engine(EngineId id);
  [[nodiscard]] Track& track(EngineId id);

  ConsoleSetup setup_;
  std::size_t most_points_;
  std::vector<Engine> engines_;
  std::vector<Time> unused_;  // the last fix of each source that the engine did not use, and that was kept
  std::optional<Arrival> first_, last_;
  std::uint64_t heard_ = 0;
  History fresh_;
};

}  // namespace leadline::ui
