#pragma once

#include <bitset>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/messages/message.h"
#include "core/types/result.h"
#include "sessions/store/runs.h"

namespace leadline::sessions {

class MessageReader;

enum class Access : std::uint8_t {
  read,   ///< beside a recording, too: never writes, never waits for it
  append  ///< one process at a time
};

/// What power loss may cost a commit.
enum class Sync : std::uint8_t {
  normal,  ///< survives the program's death; power loss may take it until the next full one
  full     ///< is on the disk when commit() returns
};

/// Some of the kinds of message, by their index in Message.
using Kinds = std::bitset<std::variant_size_v<Message>>;
template <class... M>
[[nodiscard]] Kinds kinds_of() {
  Kinds kinds;
  (kinds.set(Message(M{}).index()), ...);
  return kinds;
}

/// Which messages of a run are read, and how much of them.
struct Reading {
  std::uint64_t first_seq = 0, end_seq = UINT64_MAX;  ///< first_seq <= seq < end_seq
  Kinds whole = Kinds().set();
  Kinds heads;  ///< of these (and not whole ones) seq, times and source only: the message is M{}
};

/// Whose messages of a kind are asked for; an empty one is anybody's.
struct Speaker {
  std::optional<SourceId> source;
  std::optional<EngineId> engine;  ///< of Solution, FixVerdict and ModeChange
};

/// One session file. Every Error is a sentence for the operator; a file that is refused is left as it is.
/// One thread at a time.
class Session {
 public:
  struct Birth {
    bool force = false;       ///< replace what has the name already
    std::string build;        ///< of the program
    std::string predecessor;  ///< the session this one continues
  };
  /// A new session, open to append. Error: the name is taken (without force), the folder takes no file,
  /// another Leadline records into it.
  [[nodiscard]] static Result<Session> create(const std::string& path, const Birth& birth);
  /// Error: no session, a newer schema, damaged, tampered with, being recorded by another process (append;
  /// told within a second). An older schema is migrated: to append, a migrated copy takes the name and the
  /// original stays as NAME.v<number>; to read, `path` is refused with that advice.
  [[nodiscard]] static Result<Session> open(const std::string& path, Access access);
  /// Moves a damaged session and its -wal out of the way, as NAME.damaged-<n>. Returns that name.
  [[nodiscard]] static Result<std::string> set_aside(const std::string& path);

  Session(Session&&) noexcept;
  Session& operator=(Session&&) noexcept;
  ~Session();

  [[nodiscard]] const std::string& path() const;

  // --- reading --------------------------------------------------------------------------------------------

  struct Identity {
    std::string uid, build, predecessor;
    Time created;
  };
  [[nodiscard]] Result<Identity> identity();
  [[nodiscard]] Result<std::vector<Run>> runs();
  /// In the order of their SourceId in that run.
  [[nodiscard]] Result<std::vector<RecordedSource>> sources(RunId run);
  /// The text a run was configured with; without one, the first run's.
  [[nodiscard]] Result<std::string> configuration(std::optional<RunId> run = {});
  [[nodiscard]] Result<std::vector<Event>> events();
  [[nodiscard]] Result<std::uint64_t> frame_count(RunId run);
  /// All messages of one kind of a run, in order; wall_utc is the arrival. `take` returns false to stop.
  /// Raw frames are read by a FrameReader.
  template <class M>
  [[nodiscard]] Result<void> read(RunId run, const std::function<bool(const Envelope&)>& take) {
    return read_kind(run, Message(M{}).index(), take);
  }
  /// The number in a run of its first frame at or after an arrival; empty behind the last one. Bisects.
  [[nodiscard]] Result<std::optional<std::uint64_t>> seek(RunId run, Arrival arrival);
  /// Messages of all kinds of a part of a run in bus order, merged; a RawFrame comes without its bytes (those
  /// are a FrameReader's), Ticks are not kept. Memory: a row a kind. `take` returns false to stop; it must
  /// not ask this session. A part may be long: the file is let go every few thousand messages, so that a
  /// recorder's log never waits for a reader. 10 us to begin, some 2 us a message.
  [[nodiscard]] Result<void> read_between(RunId run, const Reading& reading,
                                          const std::function<bool(const Envelope&)>& take);
  /// The last `most` messages of one kind and speaker before end_seq, oldest first; none before floor_seq is
  /// looked at: finding a speaker who fell silent costs 0.1 us for every message of the kind since.
  [[nodiscard]] Result<std::vector<Envelope>> read_last(RunId run, std::size_t kind, std::uint64_t end_seq,
                                                        int most, const Speaker& speaker = {},
                                                        std::uint64_t floor_seq = 0);
  template <class M>
  [[nodiscard]] Result<std::optional<Envelope>> last_before(RunId run, std::uint64_t end_seq,
                                                            const Speaker& speaker = {},
                                                            std::uint64_t floor_seq = 0) {
    auto last = read_last(run, Message(M{}).index(), end_seq, 1, speaker, floor_seq);
    if (!last) return last.error();
    if (last.value().empty()) return std::optional<Envelope>();
    return std::optional<Envelope>(std::move(last.value().front()));
  }
  /// The number of the first message of any kind heard after an arrival, frames or none; behind the last one
  /// the number after it (1 in a run without messages). Bisects: some 100 us.
  [[nodiscard]] Result<std::uint64_t> seek_after(RunId run, Arrival arrival);
  /// SQLite's quick_check of the whole file. Error: what is damaged.
  [[nodiscard]] Result<void> check();

  // --- appending ------------------------------------------------------------------------------------------

  /// A new run; the messages put() from now on are its own. Marks runs that never ended as died, and tells of
  /// the gap. On the disk when it returns.
  [[nodiscard]] Result<RunId> begin_run(const RunInfo& info);
  /// A transaction: begin, put..., commit. After an Error: rollback(), and put everything again.
  [[nodiscard]] Result<void> begin(Sync sync);
  [[nodiscard]] Result<void> put(const Envelope& envelope);
  [[nodiscard]] Result<void> put(const Event& event);
  /// How far the run has come; inside a transaction.
  [[nodiscard]] Result<void> put_progress(std::optional<Arrival> first, std::optional<Arrival> last);
  [[nodiscard]] Result<void> commit();
  void rollback();
  /// The run ended as it should; a transaction of its own, on the disk when it returns.
  [[nodiscard]] Result<void> end_run(Time wall, std::optional<Arrival> first, std::optional<Arrival> last);
  /// Folds the write-ahead log into the file, so that the one file is the whole session.
  [[nodiscard]] Result<void> fold();

 private:
  friend class FrameReader;
  struct Impl;
  explicit Session(std::unique_ptr<Impl> impl);
  [[nodiscard]] Result<void> read_kind(RunId run, std::size_t kind,
                                       const std::function<bool(const Envelope&)>& take);
  [[nodiscard]] MessageReader& reader(RunId run);

  std::unique_ptr<Impl> impl_;
};

}  // namespace leadline::sessions
