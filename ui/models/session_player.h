#pragma once

#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "ui/bridge/snapshot_builder.h"
#include "ui/models/session_loader.h"
#include "ui/models/timeline_data.h"

namespace leadline::ui {

/// A session that is looked at: a play head in arrival time over its shown runs, the state there, and all
/// that has a place in time. Opens paused at its end. The state at a time is that after every message heard
/// until then: what each source and engine said last, and the messages of the last 20 s one by one. Until the
/// history is complete, a source that was silent for long may be missing and frames count from there.
/// GUI thread; takes milliseconds a call. A file that cannot be read leaves a sentence in failure().
class SessionPlayer {
 public:
  static constexpr double kSlowest = 0.25, kFastest = 60.0;

  /// runs: of choose_runs(). Error: the file cannot be opened, or read at its end.
  [[nodiscard]] static Result<std::unique_ptr<SessionPlayer>> open(const std::string& path,
                                                                   std::vector<ShownRun> runs,
                                                                   ConsoleSetup setup);

  // --- what is shown --------------------------------------------------------------------------------------

  [[nodiscard]] const Snapshot& snapshot() const { return snapshot_; }
  [[nodiscard]] const History& history() const { return history_; }
  [[nodiscard]] const ConsoleSetup& setup() const { return builder_.setup(); }
  [[nodiscard]] Time now() const { return head_; }
  [[nodiscard]] TimeSpan run() const;
  /// What went wrong; playing has stopped there.
  [[nodiscard]] const std::optional<Error>& failure() const { return failure_; }

  // --- moving ---------------------------------------------------------------------------------------------

  void play();
  void pause() { playing_ = false; }
  [[nodiscard]] bool playing() const { return playing_; }
  /// Clamped to kSlowest..kFastest; empty: as fast as it can be read.
  void set_speed(std::optional<double> factor);
  [[nodiscard]] std::optional<double> speed() const { return speed_; }
  /// Clamped to the run.
  void seek(Time time);
  /// Behind the next solution of the engine shown, or behind the one before this; pauses.
  void step_forward();
  void step_back();
  /// To the next or previous alarm, change of availability, event or end of a gap. false: there is none.
  bool next_event();
  bool previous_event();
  /// A to B again and again; empty: no loop. One that is empty or outside is none.
  void set_loop(std::optional<TimeSpan> loop);
  [[nodiscard]] const std::optional<TimeSpan>& loop() const { return loop_; }

  /// Lets the wall's time pass; true: the snapshot is another one.
  bool advance(Duration wall);
  /// Takes what the background has read since; true: history or snapshot are others. At display rate.
  bool take_loaded();

 private:
  struct Position {
    std::size_t run = 0;
    std::uint64_t seq = 1;  ///< of the next message
  };
  SessionPlayer(sessions::Session session, std::vector<ShownRun> runs, const ConsoleSetup& setup);

  /// The state before a message, from nothing.
  [[nodiscard]] Result<void> rebuild(Position position, Time head);
  [[nodiscard]] Result<Position> position_at(Time time);
  /// What each speaker of a run said last before `seq`, into `seeds` in bus order.
  [[nodiscard]] Result<void> gather(std::size_t run, std::uint64_t seq, std::vector<Envelope>& seeds);
  [[nodiscard]] std::uint64_t index_place(std::size_t run, std::uint64_t seq) const;
  void count_until(std::size_t run, std::uint64_t seq, SnapshotBuilder& builder) const;
  /// Takes messages until `target`, at most `most`; true: it got there.
  [[nodiscard]] Result<bool> play_until(Time target, int most);
  /// Takes messages up to and with number `seq` of a run.
  [[nodiscard]] Result<void> play_with(std::size_t run, std::uint64_t seq);
  [[nodiscard]] bool go(const Result<void>& result);
  void fail(const Error& error);
  void look();

  sessions::Session session_;
  std::vector<ShownRun> runs_;
  SnapshotBuilder builder_;
  Position position_;
  Time head_;
  bool playing_ = false, grows_ = false;
  std::optional<double> speed_ = 1.0;
  std::optional<TimeSpan> loop_;
  std::vector<std::set<KindSpeaker>> met_;  // of each run, whom the player has heard
  std::vector<Time> stops_;
  Snapshot snapshot_;
  History history_;
  std::optional<Error> failure_;
  std::unique_ptr<SessionLoader> loader_;
};

}  // namespace leadline::ui
