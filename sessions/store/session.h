#pragma once

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

enum class Access : std::uint8_t {
  read,   ///< beside a recording, too: never writes, never waits for it
  append  ///< one process at a time
};

/// What power loss may cost a commit.
enum class Sync : std::uint8_t {
  normal,  ///< survives the program's death; power loss may take it until the next full one
  full     ///< is on the disk when commit() returns
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

  std::unique_ptr<Impl> impl_;
};

}  // namespace leadline::sessions
