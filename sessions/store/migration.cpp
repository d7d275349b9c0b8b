#include "sessions/store/migration.h"

#include <SQLiteCpp/Backup.h>
#include <sqlite3.h>

#include <filesystem>
#include <system_error>

#include "sessions/store/connection.h"
#include "sessions/store/session_file.h"

namespace leadline::sessions {
namespace {

namespace fs = std::filesystem;

/// A whole copy: what is still in the write-ahead log comes with it, and the original's files stay as they
/// are.
void copy(const std::string& from, const std::string& to) {
  Connection source(from, Open::read);
  SQLite::Database target(to, SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE);
  SQLite::Backup backup(target, source.database());
  constexpr int kPages = 4096;
  int step = SQLITE_OK;
  while (step == SQLITE_OK) {
    source.restart_clock();
    step = backup.executeStep(kPages);
  }
  if (step != SQLITE_DONE) throw SQLite::Exception("the session is in use", SQLITE_BUSY);
}

void run(const std::string& path, int from, std::span<const schema::Script> scripts) {
  SQLite::Database database(path, SQLite::OPEN_READWRITE);
  SQLite::Transaction transaction(database);
  for (const auto& script : scripts)
    if (script.version > from) database.exec(std::string(script.sql));
  transaction.commit();
}

void remove_all_of(const std::string& path) {
  std::error_code ignored;
  for (const auto& file : files_of(path)) fs::remove(file, ignored);
}

}  // namespace

Result<std::string> migrate(const std::string& path, int from, std::span<const schema::Script> scripts) {
  const std::string kept = path + ".v" + std::to_string(from), made = path + ".migrating";
  const std::string remedy = "the session is as it was";
  std::error_code failed;
  if (fs::exists(kept, failed))
    return Error{"is of an older schema, and where its original would be kept something is already: " + kept,
                 path, "move that away"};
  remove_all_of(made);
  auto done = guarded(path, [&] {
    copy(path, made);
    run(made, from, scripts);
  });
  if (done) {
    const auto old_files = files_of(path), kept_files = files_of(kept);
    for (std::size_t i = 0; i < old_files.size() && !failed; ++i)
      if (fs::exists(old_files[i])) fs::rename(old_files[i], kept_files[i], failed);
    if (!failed) fs::rename(made, path, failed);
    if (!failed) return kept;
    done = Error{"could not take its migrated copy: " + failed.message(), path, remedy};
    std::error_code ignored;
    for (std::size_t i = 0; i < old_files.size(); ++i)
      if (fs::exists(kept_files[i], ignored)) fs::rename(kept_files[i], old_files[i], ignored);
  }
  remove_all_of(made);
  return Error{"is of schema " + std::to_string(from) + " and could not be migrated: " + done.error().what,
               path, remedy};
}

}  // namespace leadline::sessions
