#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <deque>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "core/flow/engine.h"
#include "sessions/recorder/message_queue.h"
#include "sessions/store/session.h"

namespace leadline::sessions {

/// Keeps every message of a Bus in a session. Attach it first: raw bytes are its own before a decoder sees
/// them. One thread writes; it commits what was taken at least every 250 ms, and once a second so that power
/// loss cannot take it. While the disk refuses, messages wait in memory and are written when it takes them
/// again.
class Recorder final : public Sink {
 public:
  struct Options {
    std::size_t memory_bytes = std::size_t{64} << 20;  ///< what may wait
    /// Full memory: true (replay) take() waits; false (live) facts are left out first, then frames, counted.
    bool lossless = false;
    /// A lossless take() waits this long for a disk that refuses, then gives up.
    std::chrono::milliseconds patience{10'000};
  };
  struct Status {
    std::uint64_t acknowledged = 0;      ///< frames that the program's death cannot take
    std::uint64_t durable = 0;           ///< frames that power loss cannot take
    std::size_t waiting_bytes = 0;       ///< of memory, not yet written
    std::size_t most_waiting_bytes = 0;  ///< ever
    std::uint64_t facts_left_out = 0;    ///< not kept for lack of memory; their frames are
    std::uint64_t frames_left_out = 0;   ///< lost for lack of memory
    std::optional<Error> failure;        ///< the disk refuses now: what the alarm says
  };

  /// Begins a run. Error: the session does not take it.
  [[nodiscard]] static Result<std::unique_ptr<Recorder>> start(Session session, const RunInfo& info,
                                                               const Options& options);
  /// Finishes, if nobody has.
  ~Recorder() override;

  /// Copies the message; no allocation, no disk. Ticks are derived and not kept, but for how far the run has
  /// come. An Alarm is committed and synced at once.
  void take(const Envelope& envelope) override;
  /// Something that happened besides the messages; any thread. It is on the disk within the next commit,
  /// which begins at once.
  void event(Severity severity, std::string kind, std::string text);

  /// Frames that were written and committed so far: what may be shown as recorded. Any thread.
  [[nodiscard]] std::uint64_t acknowledged() const { return acknowledged_.load(std::memory_order_acquire); }
  [[nodiscard]] Status status() const;
  [[nodiscard]] RunId run() const { return run_; }

  /// Writes what waits, marks the run as ended, folds the log into the file and ends the thread. Error: not
  /// all of it is on the disk.
  [[nodiscard]] Result<void> finish();

 private:
  using Steady = std::chrono::steady_clock;
  Recorder(Session session, RunId run, const Options& options);

  void write_until_finished();
  [[nodiscard]] Result<void> write_batch(Sync sync, const std::vector<Event>& events);
  void release(std::size_t blocks, std::size_t read_to);
  void rewind(std::size_t read_from);
  [[nodiscard]] bool due_full() const;

  Session session_;
  RunId run_;
  Options options_;

  mutable std::mutex mutex_;
  std::condition_variable work_, room_;
  MessageQueue queue_;                                      // guarded by mutex_
  std::vector<Event> events_;                               // guarded
  bool finishing_ = false;                                  // guarded
  bool gave_up_ = false;                                    // guarded
  bool urgent_ = false;                                     // guarded: an alarm waits, to be synced at once
  std::uint64_t facts_left_out_ = 0, frames_left_out_ = 0;  // guarded
  std::size_t most_waiting_ = 0;                            // guarded
  std::optional<Error> failure_;                            // guarded
  std::optional<Arrival> latest_;                           // guarded
  std::atomic<std::uint64_t> acknowledged_{0}, durable_{0};

  std::deque<MessageQueue::Block> batch_;  // the writer's own, as all below
  std::optional<Arrival> first_, last_;
  std::uint64_t frames_ = 0, left_out_told_ = 0;
  Steady::time_point last_full_;
  bool finished_ = false;
  std::thread writer_;
};

}  // namespace leadline::sessions
