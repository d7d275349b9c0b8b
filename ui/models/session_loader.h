#pragma once

#include <condition_variable>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "ui/bridge/history_builder.h"
#include "ui/models/shown_runs.h"
#include "ui/models/speaker_index.h"

namespace leadline::ui {

/// Reads the whole of the shown runs in a thread of its own, with a session of its own, oldest first, a batch
/// at a time; a run that is still being recorded is followed. One reader: take() and before() by one thread.
class SessionLoader {
 public:
  SessionLoader(std::string path, std::vector<ShownRun> runs, ConsoleSetup setup);
  ~SessionLoader();
  SessionLoader(const SessionLoader&) = delete;
  SessionLoader& operator=(const SessionLoader&) = delete;

  struct Loaded {
    History history;          ///< what is new
    std::vector<Time> stops;  ///< new moments worth going to, by arrival
    ShownRun newest;          ///< how far the newest run has come
    bool complete = false;    ///< everything that is in the file now was read
    std::optional<Error> failure;
  };
  /// What has come since the last call; empty: nothing.
  [[nodiscard]] std::optional<Loaded> take();
  /// Everybody who spoke in a shown run before `seq`, which begins a block; empty: not read that far yet.
  [[nodiscard]] std::optional<std::vector<SpeakerIndex::Last>> before(std::size_t run,
                                                                      std::uint64_t seq) const;

 private:
  struct Said {
    KindSpeaker speaker;
    std::uint64_t seq;
  };
  void run();
  [[nodiscard]] Result<void> load(sessions::Session& session);
  [[nodiscard]] Result<void> load_run(sessions::Session& session, std::size_t place);
  void take_envelope(std::size_t place, const Envelope& envelope);
  void take_events_until(Time t);
  /// run_done: everything of that run was read.
  void hand_over(std::size_t place, bool run_done);
  [[nodiscard]] bool stopping() const;

  std::string path_;
  ConsoleSetup setup_;

  // The thread's own.
  std::vector<ShownRun> runs_;
  std::vector<std::uint64_t> next_seq_;
  HistoryBuilder history_;
  std::vector<EventMark> events_;  // of the session itself, to come, newest first
  std::vector<Said> said_;
  std::vector<Time> stops_;

  mutable std::mutex mutex_;
  std::condition_variable wake_;
  std::optional<Loaded> loaded_;       // guarded
  std::vector<SpeakerIndex> indices_;  // guarded
  bool stop_ = false;                  // guarded
  std::thread thread_;
};

}  // namespace leadline::ui
