#include "sessions/store/session.h"

#include <fcntl.h>
#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <random>
#include <system_error>
#include <tuple>

#include "core/types/expect.h"
#include "sessions/schema/scripts.h"
#include "sessions/store/inspection.h"
#include "sessions/store/migration.h"
#include "sessions/store/run_rows.h"
#include "sessions/store/session_impl.h"

namespace leadline::sessions {
namespace {

namespace fs = std::filesystem;

constexpr int kPage = 512;                   // messages a question
constexpr RunId kMostRuns = RunId{1} << 24;  // or ids would not fit
constexpr const char* kSignLog = "UPDATE session SET syncs = syncs + 1";
constexpr const char* kSyncs[] = {"PRAGMA synchronous = NORMAL", "PRAGMA synchronous = FULL"};

int newest_schema() { return schema::scripts().back().version; }

std::string random_uid() {
  std::random_device random;
  constexpr const char* kHex = "0123456789abcdef";
  std::string uid;
  for (int i = 0; i < 32; ++i) uid += kHex[random() % 16];
  return uid;
}

std::int64_t wall_ns() {
  return std::chrono::duration_cast<Duration>(std::chrono::system_clock::now().time_since_epoch()).count();
}

/// A new name in a folder is on the disk only when the folder is.
void sync_folder(const std::string& path) {
  const std::string folder = fs::path(path).parent_path().string();
  const int descriptor = ::open(folder.empty() ? "." : folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor < 0) return;
  ::fsync(descriptor);
  ::close(descriptor);
}

void remove_all_of(const std::string& path) {
  std::error_code ignored;
  for (const auto& file : files_of(path)) fs::remove(file, ignored);
}

Result<void> make_way(const std::string& path) {
  std::error_code failed;
  if (fs::is_regular_file(path, failed)) {
    auto old = SessionFile::open(path);
    if (!old) return old.error();
    if (auto locked = old.value().lock(path); !locked) return locked;
    remove_all_of(path);
  }
  return {};
}

void fill(Connection& connection, const Session::Birth& birth) {
  SQLite::Database& database = connection.database();
  SQLite::Transaction transaction(database);
  for (const auto& script : schema::scripts()) database.exec(std::string(script.sql));
  SQLite::Statement add(
      database, "INSERT INTO session (id, uid, created_ns, build, predecessor) VALUES (1, ?, ?, ?, ?)");
  add.bind(1, random_uid()), add.bind(2, wall_ns()), add.bind(3, birth.build);
  if (!birth.predecessor.empty()) add.bind(4, birth.predecessor);
  add.exec();
  transaction.commit();
}

/// A reader finds the write-ahead log's index beside the file, or may make it; where it cannot (a folder it
/// may not write), a session that was closed is whole without it.
std::unique_ptr<Connection> open_to_read(const std::string& path) {
  std::error_code failed;
  try {
    auto connection = std::make_unique<Connection>(path, Open::read);
    connection->database().execAndGet("SELECT count(*) FROM session");
    return connection;
  } catch (const SQLite::Exception&) {
    if (const auto wal = fs::file_size(path + "-wal", failed); !failed && wal > 0) throw;
    return std::make_unique<Connection>(path, Open::read_immutable);
  }
}

/// The header's schema number, read by SQLite: a reader opens no descriptor of its own (SessionFile).
Result<int> schema_to_read(const std::string& path) {
  std::error_code failed;
  const auto status = fs::status(path, failed);
  if (!fs::exists(status))
    return Error{"cannot be read: No such file or directory", path, "is the name right?"};
  if (!fs::is_regular_file(status)) return Error{"is no file", path, "name a session file"};
  if (fs::file_size(path, failed) == 0) return no_session(path, "is empty, so it is no session");
  try {
    Connection connection(path, Open::read_immutable);
    const auto number = [&](const char* pragma) {
      return connection.database().execAndGet(pragma).getInt64();
    };
    if (number("PRAGMA application_id") != kApplicationId)
      return no_session(path, "is another program's database, no Leadline session");
    return static_cast<int>(number("PRAGMA user_version"));
  } catch (const SQLite::Exception& failure) {
    if (is_no_database(failure))
      return no_session(path, "is no Leadline session, or its beginning is damaged");
    return error_of(failure, path);
  }
}

}  // namespace

Session::Session(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
Session::Session(Session&&) noexcept = default;
Session& Session::operator=(Session&&) noexcept = default;
Session::~Session() = default;

const std::string& Session::path() const { return impl_->path; }

Result<Session> Session::create(const std::string& path, const Birth& birth) {
  if (birth.force)
    if (auto clear = make_way(path); !clear) return clear.error();
  auto file = SessionFile::create(path);
  if (!file) return file.error();
  std::error_code failed;
  for (const char* beside : {"-wal", "-journal"}) {
    const auto size = fs::file_size(path + beside, failed);
    if (failed || size == 0) continue;
    fs::remove(path, failed);
    return Error{std::string("a session of this name was removed, but not its ") + beside, path,
                 "move that away, or choose another name"};
  }
  auto impl = std::make_unique<Impl>();
  impl->path = path;
  impl->append = true;
  impl->file = std::move(file).value();
  const auto made = guarded(path, [&] {
    impl->connection = std::make_unique<Connection>(path, Open::append);
    fill(*impl->connection, birth);
    // The schema is in the file itself from the start: a lost or foreign -wal never costs more than messages.
    impl->connection->database().exec("PRAGMA wal_checkpoint(TRUNCATE)");
  });
  if (!made) {
    impl->connection.reset();
    remove_all_of(path);
    return made.error();
  }
  sync_folder(path);
  return Session(std::move(impl));
}

Result<Session> Session::open(const std::string& path, Access access) {
  const bool append = access == Access::append;
  SessionFile file;
  if (append) {
    auto opened = SessionFile::open(path);
    if (!opened) return opened.error();
    file = std::move(opened).value();
  }
  const auto version = append ? file.schema(path) : schema_to_read(path);
  if (!version) return version.error();
  if (version.value() > newest_schema())
    return Error{"was written by a newer Leadline: schema " + std::to_string(version.value()) +
                     ", this one knows " + std::to_string(newest_schema()),
                 path, "it is left as it is; use the newer program"};
  if (version.value() < 1)
    return Error{"was never finished being made, so it holds nothing", path, "name another file"};
  if (append)
    if (auto locked = file.lock(path); !locked) return locked.error();
  if (version.value() < newest_schema()) {
    if (!append)
      return Error{"is of the older schema " + std::to_string(version.value()), path,
                   "record or replay into it once: a copy is migrated and the original kept"};
    if (auto kept = migrate(path, version.value(), schema::scripts()); !kept) return kept.error();
    file = SessionFile();
    return open(path, access);  // the name is another file's now
  }
  // A rollback journal is there only where the program died while it closed the file; SQLite rolls it back.
  std::error_code failed;
  const bool closing = append && fs::exists(path + "-journal", failed);
  if (append && !closing)
    if (auto sound = inspect_before_writing(path); !sound) return sound.error();
  auto impl = std::make_unique<Impl>();
  impl->path = path;
  impl->append = append;
  impl->file = std::move(file);
  const auto opened = guarded(path, [&] {
    impl->connection = append ? std::make_unique<Connection>(path, Open::append) : open_to_read(path);
  });
  if (!opened) return opened.error();
  if (!append || closing)
    if (auto sound = inspect(*impl->connection, path); !sound) return sound.error();
  return Session(std::move(impl));
}

Result<std::string> Session::set_aside(const std::string& path) {
  std::error_code failed;
  std::string aside;
  for (int n = 1; aside.empty() || fs::exists(aside, failed); ++n)
    aside = path + ".damaged-" + std::to_string(n);
  const auto from = files_of(path), to = files_of(aside);
  for (std::size_t i = 0; i < from.size(); ++i) {
    if (!fs::exists(from[i])) continue;
    fs::rename(from[i], to[i], failed);
    if (failed) return Error{"cannot be moved away: " + failed.message(), from[i], "move it by hand"};
  }
  return aside;
}

// --- reading ----------------------------------------------------------------------------------------------

Result<Session::Identity> Session::identity() {
  return guarded(path(), [&]() -> Result<Identity> {
    SQLite::Statement query(impl_->database(),
                            "SELECT uid, build, coalesce(predecessor, ''), created_ns FROM session");
    if (!query.executeStep()) return Error{"the session is damaged: it has no identity", path(), ""};
    return Identity{text_of(query.getColumn(0)), text_of(query.getColumn(1)), text_of(query.getColumn(2)),
                    Time{query.getColumn(3).getInt64()}};
  });
}

Result<std::vector<Run>> Session::runs() {
  return guarded(path(), [&]() -> Result<std::vector<Run>> {
    auto runs = runs_in(impl_->database());
    for (const Run& run : runs)
      if (run.id < 1 || run.id >= kMostRuns)
        return Error{"the session is damaged: run " + std::to_string(run.id), path(), ""};
    return runs;
  });
}

Result<std::vector<RecordedSource>> Session::sources(RunId run) {
  return guarded(path(), [&]() -> Result<std::vector<RecordedSource>> {
    auto sources = sources_in(impl_->database(), run);
    for (std::size_t i = 0; i < sources.size(); ++i)
      if (sources[i].info.id != i)
        return Error{"the session is damaged: the sources of run " + std::to_string(run), path(), ""};
    return sources;
  });
}

Result<std::string> Session::configuration(std::optional<RunId> run) {
  return guarded(path(), [&]() -> Result<std::string> {
    SQLite::Statement query(impl_->database(),
                            "SELECT c.text FROM run r JOIN configuration c ON c.id = r.configuration "
                            "WHERE ?1 IS NULL OR r.id = ?1 ORDER BY r.id LIMIT 1");
    if (run) query.bind(1, *run);
    if (!query.executeStep())
      return Error{"holds no configuration: nothing was ever recorded in it", path(),
                   "name one with --config"};
    return text_of(query.getColumn(0));
  });
}

Result<std::vector<Event>> Session::events() {
  return guarded(path(), [&]() -> Result<std::vector<Event>> { return events_in(impl_->database()); });
}

Result<std::uint64_t> Session::frame_count(RunId run) {
  return guarded(path(), [&]() -> Result<std::uint64_t> {
    SQLite::Statement query(impl_->database(), "SELECT count(*) FROM raw_frame WHERE id > ? AND id < ?");
    query.bind(1, id_of(run, 0)), query.bind(2, id_of(run + 1, 0));
    query.executeStep();
    return static_cast<std::uint64_t>(query.getColumn(0).getInt64());
  });
}

Result<void> Session::read_kind(RunId run, std::size_t kind,
                                const std::function<bool(const Envelope&)>& take) {
  return guarded(path(), [&]() -> Result<void> {
    const auto places = places_in(impl_->database(), run);
    std::int64_t after = id_of(run, 0);
    for (;;) {
      bool failed = false;
      // A page a question: nothing is held between them, so that the recorder's log never waits for a reader.
      const auto page =
          message_page(impl_->database(), kind, after, id_of(run + 1, 0), kPage, places, failed);
      if (failed) return Error{"the session is damaged: a row that no Leadline wrote", path(), ""};
      for (const Envelope& envelope : page)
        if (!take(envelope)) return {};
      if (page.size() < kPage) return {};
      after = id_of(run, page.back().seq);
    }
  });
}

Result<std::optional<std::uint64_t>> Session::seek(RunId run, Arrival arrival) {
  using Found = std::optional<std::uint64_t>;
  return guarded(path(), [&]() -> Result<Found> {
    SQLite::Statement last(impl_->database(), "SELECT max(id) FROM raw_frame WHERE id > ? AND id < ?");
    last.bind(1, id_of(run, 0)), last.bind(2, id_of(run + 1, 0));
    last.executeStep();
    if (last.getColumn(0).isNull()) return Found{};
    SQLite::Statement next(impl_->database(),
                           "SELECT id, arrival_ns FROM raw_frame WHERE id >= ? ORDER BY id LIMIT 1");
    std::int64_t low = id_of(run, 1),
                 high = last.getColumn(0).getInt64() + 1;  // the answer is in [low, high]
    while (low < high) {
      const std::int64_t middle = low + (high - low) / 2;
      next.reset();
      next.bind(1, middle);
      if (!next.executeStep()) return Error{"the session is damaged", path(), ""};
      if (next.getColumn(1).getInt64() < arrival.ns)
        low = next.getColumn(0).getInt64() + 1;
      else
        high = middle;
    }
    next.reset();
    next.bind(1, low);
    if (!next.executeStep() || next.getColumn(0).getInt64() >= id_of(run + 1, 0)) return Found{};
    return Found{seq_of(next.getColumn(0).getInt64())};
  });
}

Result<void> Session::check() {
  return guarded(path(), [&]() -> Result<void> {
    Connection connection(path(), Open::read);
    connection.restart_clock(std::chrono::hours(1));
    SQLite::Statement query(connection.database(), "PRAGMA quick_check(1)");
    if (query.executeStep() && text_of(query.getColumn(0)) != "ok")
      return Error{"the session is damaged: " + text_of(query.getColumn(0)), path(), ""};
    return {};
  });
}

// --- appending --------------------------------------------------------------------------------------------

Result<RunId> Session::begin_run(const RunInfo& info) {
  impl_->writer.reset();
  if (auto begun = begin(Sync::full); !begun) return begun.error();
  std::vector<std::int64_t> sources;
  auto added = guarded(path(), [&] {
    std::tie(impl_->run, sources) = add_run(impl_->database(), info);
    LL_EXPECT(impl_->run < kMostRuns);
    impl_->database().exec(kSignLog);
  });
  if (added) added = commit();
  if (!added) {
    rollback();
    return added.error();
  }
  impl_->writer.emplace(impl_->database(), impl_->run, std::move(sources), info.store_frames);
  return impl_->run;
}

Result<void> Session::begin(Sync sync) {
  return guarded(path(), [&] {
    if (sync != impl_->sync) {
      impl_->database().exec(kSyncs[static_cast<std::size_t>(sync)]);
      impl_->sync = sync;
    }
    impl_->database().exec("BEGIN IMMEDIATE");
  });
}

Result<void> Session::put(const Envelope& envelope) {
  LL_EXPECT(impl_->writer.has_value());
  return guarded(path(), [&] { impl_->writer->put(envelope); });
}

Result<void> Session::put(const Event& event) {
  return guarded(path(), [&] { add_event(impl_->database(), impl_->run, event); });
}

Result<void> Session::put_progress(std::optional<Arrival> first, std::optional<Arrival> last) {
  return guarded(path(), [&] {
    SQLite::Statement update(impl_->database(),
                             "UPDATE run SET first_arrival_ns = ?, last_arrival_ns = ? WHERE id = ?");
    if (first) update.bind(1, first->ns);
    if (last) update.bind(2, last->ns);
    update.bind(3, impl_->run);
    update.exec();
    impl_->database().exec(kSignLog);
  });
}

Result<void> Session::commit() {
  return guarded(path(), [&] { impl_->database().exec("COMMIT"); });
}

void Session::rollback() {
  if (impl_->writer) impl_->writer->reset();
  impl_->database().tryExec("ROLLBACK");  // SQLite may have done it by itself
}

Result<void> Session::end_run(Time wall, std::optional<Arrival> first, std::optional<Arrival> last) {
  auto done = begin(Sync::full);
  if (done) done = put_progress(first, last);
  if (done)
    done = guarded(path(), [&] {
      SQLite::Statement update(impl_->database(),
                               "UPDATE run SET ended_ns = ?, ended = 'clean' WHERE id = ?");
      update.bind(1, wall.ns), update.bind(2, impl_->run);
      update.exec();
    });
  if (done) done = commit();
  if (!done) rollback();
  return done;
}

Result<void> Session::fold() {
  return guarded(path(), [&] { impl_->fold(); });
}

}  // namespace leadline::sessions
