#include "sessions/store/inspection.h"

#include <sys/stat.h>

#include <map>
#include <optional>

#include "sessions/schema/scripts.h"
#include "sessions/store/connection.h"

namespace leadline::sessions {
namespace {

using Shape = std::map<std::string, std::string>;  // type and name to the statement that made it

constexpr const char* kLeft = "it is left as it is; `sqlite3 FILE .recover` saves what can be read";

Shape shape_of(SQLite::Database& database) {
  Shape shape;
  SQLite::Statement query(database, "SELECT type || ' ' || name, coalesce(sql, '') FROM sqlite_schema");
  while (query.executeStep()) shape[text_of(query.getColumn(0))] = text_of(query.getColumn(1));
  return shape;
}

const Shape& expected() {
  static const Shape shape = [] {
    SQLite::Database memory(":memory:", SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE);
    for (const auto& script : schema::scripts()) memory.exec(std::string(script.sql));
    return shape_of(memory);
  }();
  return shape;
}

std::optional<std::string> uid_of(const std::string& path, Open how) {
  try {
    Connection connection(path, how);
    SQLite::Statement query(connection.database(), "SELECT uid FROM session");
    if (query.executeStep()) return text_of(query.getColumn(0));
  } catch (const SQLite::Exception&) {  // what is wrong is told by the questions after this one
  }
  return std::nullopt;
}

bool has_wal(const std::string& path) {
  struct stat status {};
  return ::stat((path + "-wal").c_str(), &status) == 0 && status.st_size > 0;
}

}  // namespace

Result<void> inspect(Connection& connection, const std::string& path) {
  return guarded(path, [&]() -> Result<void> {
    connection.restart_clock();
    const Shape found = shape_of(connection.database());
    for (const auto& [name, sql] : expected()) {
      const auto it = found.find(name);
      if (it == found.end() || it->second != sql)
        return Error{"the session is damaged or was changed: its " + name + " is not as Leadline makes it",
                     path, kLeft};
    }
    for (const auto& [name, sql] : found)
      if (name.rfind("trigger ", 0) == 0)
        return Error{"the session was changed: it holds the " + name + ", which could act on its own", path,
                     kLeft};
    return {};
  });
}

Result<void> inspect_before_writing(const std::string& path) {
  return guarded(path, [&]() -> Result<void> {
    if (has_wal(path)) {
      // Recovery would write another session's pages into this one: a write-ahead log does not say whose it
      // is, but a session has a name of its own that is written once and never again.
      const auto alone = uid_of(path, Open::read_immutable), together = uid_of(path, Open::read);
      if (alone && alone != together)
        return Error{"the -wal beside the session is damaged or another session's", path,
                     "move that one away"};
    }
    Connection connection(path, Open::read);
    if (auto sound = inspect(connection, path); !sound) return sound;
    connection.restart_clock();
    SQLite::Statement check(connection.database(), "PRAGMA quick_check(1)");
    try {
      if (check.executeStep() && text_of(check.getColumn(0)) != "ok")
        return Error{"the session is damaged: " + text_of(check.getColumn(0)), path, kLeft};
    } catch (const SQLite::Exception& failure) {  // interrupted: nothing was wrong in its two seconds
      if (!interrupted(failure)) throw;
    }
    return {};
  });
}

}  // namespace leadline::sessions
