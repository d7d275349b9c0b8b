#include "sessions/store/connection.h"

#include <sqlite3.h>

namespace leadline::sessions {
namespace {

constexpr int kBusyMs = 800;  // a second program is told within a second

/// SQLite's own escapes of a file name in a URI.
std::string uri_of(const std::string& path) {
  std::string uri = "file:";
  for (const char c : path) {
    if (c == '%' || c == '?' || c == '#') {
      constexpr const char* kHex = "0123456789ABCDEF";
      uri += {'%', kHex[static_cast<unsigned char>(c) >> 4], kHex[static_cast<unsigned char>(c) & 15]};
    } else {
      uri += c;
    }
  }
  return uri + "?immutable=1";
}

}  // namespace

int Connection::expired(void* clock) {
  return std::chrono::steady_clock::now() > static_cast<Clock*>(clock)->deadline ? 1 : 0;
}

Connection::Connection(const std::string& path, Open how)
    : database_(how == Open::read_immutable ? uri_of(path) : path,
                (how == Open::append ? SQLite::OPEN_READWRITE : SQLite::OPEN_READONLY) |
                    SQLite::OPEN_NOMUTEX | (how == Open::read_immutable ? SQLite::OPEN_URI : 0),
                kBusyMs) {
  sqlite3* handle = database_.getHandle();
  sqlite3_extended_result_codes(handle, 1);
  sqlite3_db_config(handle, SQLITE_DBCONFIG_DEFENSIVE, 1, nullptr);
  sqlite3_db_config(handle, SQLITE_DBCONFIG_TRUSTED_SCHEMA, 0, nullptr);
  sqlite3_db_config(handle, SQLITE_DBCONFIG_ENABLE_LOAD_EXTENSION, 0, nullptr);
  restart_clock();
  database_.exec("PRAGMA cell_size_check = ON");
  if (how != Open::append) {
    sqlite3_progress_handler(handle, 10'000, &Connection::expired, clock_.get());
    database_.exec("PRAGMA query_only = ON");
    return;
  }
  database_.exec(
      "PRAGMA journal_mode = WAL;"
      "PRAGMA synchronous = NORMAL;"
      "PRAGMA foreign_keys = ON;"
      "PRAGMA journal_size_limit = 67108864;"
      "PRAGMA wal_autocheckpoint = 2000");
}

bool interrupted(const SQLite::Exception& failure) {
  return (failure.getErrorCode() & 0xFF) == SQLITE_INTERRUPT;
}

bool is_no_database(const SQLite::Exception& failure) {
  return (failure.getErrorCode() & 0xFF) == SQLITE_NOTADB;
}

Error error_of(const SQLite::Exception& failure, const std::string& path) {
  switch (failure.getErrorCode() & 0xFF) {
    case SQLITE_FULL:
      return {"the disk is full", path, "free some space; nothing is deleted by itself"};
    case SQLITE_IOERR:
      return {std::string("the disk does not take or give the data: ") + failure.what(), path,
              "is it full, unplugged or failing?"};
    case SQLITE_BUSY:
    case SQLITE_LOCKED:
      return {"another program holds it", path, "close that program"};
    case SQLITE_READONLY:
    case SQLITE_PERM:
    case SQLITE_CANTOPEN:
      return {std::string("the session or its folder cannot be written: ") + failure.what(), path,
              "choose a folder that can be written"};
    case SQLITE_CORRUPT:
    case SQLITE_NOTADB:
    case SQLITE_ERROR:       // a table that is not there
    case SQLITE_CONSTRAINT:  // a row that cannot be
    case SQLITE_TOOBIG:
      return {std::string("the session is damaged: ") + failure.what(), path,
              "it is left as it is; `sqlite3 FILE .recover` saves what can be read"};
    case SQLITE_INTERRUPT:
      return {"the session takes too long to read", path, "it may be damaged or no session of ours"};
    default:
      return {std::string("the session cannot be used: ") + failure.what(), path, ""};
  }
}

}  // namespace leadline::sessions
